//! Content of a VAL 3 file as a list of entries, including content that no rule reads: namespaces, unknown attributes,
//! texts between elements.

use val3_analysis::xml;
use val3_lang::types::{BaseType, attributes};

use super::entries::{EntryRules, XmlEntry, entries};

/// Default values of attributes that files may omit.
const DEFAULTS: [(&str, &str); 7] = [
    ("access", "private"),
    ("public", "false"),
    ("autoload", "true"),
    ("use", "value"),
    ("byVal", "true"),
    ("dimensions", "1"),
    ("fatherIndex", "0"),
];

/// Elements whose content is compared as code or text.
const TEXTS: [&str; 4] = ["Code", "code", "Description", "description"];

/// Types that together have all attributes of values.
const TYPES: [BaseType; 9] = [
    BaseType::Num,
    BaseType::Dio,
    BaseType::Frame,
    BaseType::Tool,
    BaseType::Point,
    BaseType::Joint,
    BaseType::Config,
    BaseType::Trsf,
    BaseType::Mdesc,
];

/// Content of a file.
#[derive(Debug)]
pub(crate) struct Contents {
    /// Name of the root element, which determines the dialect.
    pub(crate) root: String,
    /// Entries, without defaults, elements without name and content, empty attributes, code, and values.
    pub(crate) entries: Vec<XmlEntry>,
}

impl Contents {
    /// Reads the text of a file; `None` if it is no XML.
    pub(crate) fn read(text: &str) -> Option<Self> {
        let parse = val3_syntax::parse(text);
        let root = xml::root(parse.view())?;
        let style =
            EntryRules { keys: &["index", "key", "id", "name", "alias", "file"], without: &TEXTS, has_keys: true };
        let mut entries = entries(root, &style);
        entries.retain(|entry| !is_usual(entry));
        Some(Self { root: root.name().to_owned(), entries })
    }
}

/// Whether an entry has no information, or is compared as a value.
fn is_usual(entry: &XmlEntry) -> bool {
    let XmlEntry { path, value } = entry;
    if is_unread(path) {
        return false;
    }
    let (element, attribute) = path.rsplit_once(' ').unwrap_or(("", path));
    if value.is_empty() {
        // An element's name is no default.
        return !path.ends_with(']') || innermost_value(path).is_some();
    }
    DEFAULTS.contains(&(attribute, value.as_str())) || innermost_value(element).is_some() && is_of_value(attribute)
}

/// Whether an entry belongs to a value that is not read, because it is written twice or has no key.
fn is_unread(path: &str) -> bool {
    innermost_value(path).is_some_and(|value| !value.contains('[') || path.contains(" #"))
}

/// Returns the innermost element that contains an entry, if it is a value, for example `Value[0]` for
/// `Datas Data[nA] Value[0]`. Values of `world` and `flange`, which files of s5 and s6 declare, are excluded.
fn innermost_value(path: &str) -> Option<&str> {
    let is_built_in = ["frame[world]", "tool[flange]"].iter().any(|name| path.contains(name));
    let innermost = path.rsplit(' ').find(|part| is_value(part) && *part != "value" || part.starts_with("Field["));
    innermost.filter(|part| is_value(part) && !is_built_in)
}

/// Whether the element is a value: `Value[0]`, `valueFrame[0]`.
fn is_value(element: &str) -> bool {
    element.to_ascii_lowercase().starts_with("value")
}

fn is_of_value(attribute: &str) -> bool {
    let known = TYPES.into_iter().flat_map(|ty| attributes(ty, None));
    ["name", "alias", "fatherIndex", "ioIndex"].contains(&attribute)
        || known.into_iter().any(|known| known.name == attribute || known.old_name() == attribute)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(text: &str) -> Vec<String> {
        let entries = Contents::read(text).unwrap().entries;
        entries.into_iter().map(|XmlEntry { path, value }| format!("{path}={value}")).collect()
    }

    #[test]
    fn defaults_code_and_values_are_left_out() {
        let text = "<Database xmlns=\"a\"><Datas><Data name=\"nA\" access=\"private\" type=\"num\" size=\"1\">\
            <Value key=\"0\" value=\"3\" other=\"1\"/></Data>text</Datas></Database>";
        assert_eq!(
            shown(text),
            [
                "xmlns=a",
                "Datas text=text",
                "Datas Data[nA]=",
                "Datas Data[nA] type=num",
                "Datas Data[nA] size=1",
                "Datas Data[nA] Value[0] other=1"
            ]
        );
        let program = "<Programs><Program name=\"p\" access=\"public\"><Parameters><Parameter name=\"x\" use=\"value\" dimensions=\"1\" \
            type=\"num\"/></Parameters><Locals/><Code>begin end</Code></Program></Programs>";
        assert_eq!(
            shown(program),
            [
                "Program[p]=",
                "Program[p] access=public",
                "Program[p] Parameters Parameter[x]=",
                "Program[p] Parameters Parameter[x] type=num"
            ]
        );
    }

    #[test]
    fn fields_of_values_and_elements_that_are_written_twice_are_kept() {
        let text = "<Database><Datas><Data name=\"t\"><Value key=\"0\"><Field name=\"n\" type=\"num\"><Value key=\"1\" value=\"2\"/>\
            <Value key=\"1\" value=\"2\"/></Field></Value></Data></Datas></Database>";
        assert_eq!(
            shown(text),
            [
                "Datas Data[t]=",
                "Datas Data[t] Value[0] Field[n]=",
                "Datas Data[t] Value[0] Field[n] type=num",
                "Datas Data[t] Value[0] Field[n] Value[1] #2=",
                "Datas Data[t] Value[0] Field[n] Value[1] #2 value=2"
            ]
        );
    }
}
