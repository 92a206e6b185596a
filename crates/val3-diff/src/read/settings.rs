//! A file of the controller's configuration as a list of entries.

use rustc_hash::FxHashMap;
use val3_analysis::xml::{self, Element};

use super::program::text_in;

/// Attributes that identify an element among its siblings, in this order.
const KEYS: [&str; 4] = ["index", "key", "id", "name"];

/// Levels of elements that are read, so that hostile files cannot overflow the stack.
const NESTING: usize = 64;

/// An entry: the elements around it with the attribute, and the value.
pub(crate) type Entry = (String, String);

/// The entries of a file in their order; `None` if it is no XML.
pub(crate) fn read(text: &str) -> Option<Vec<Entry>> {
    let parse = val3_syntax::parse(text);
    let root = xml::root(parse.view()).filter(|_| parse.errors().is_empty())?;
    let mut entries = Vec::new();
    element("", root, NESTING, &mut entries);
    Some(entries)
}

fn element(around: &str, element_read: Element<'_>, nesting: usize, entries: &mut Vec<Entry>) {
    let join = |name: &str| if around.is_empty() { name.to_owned() } else { format!("{around} {name}") };
    let key = key(element_read);
    let attributes = element_read.attributes().filter(|attribute| !attribute.name.starts_with("xmlns"));
    for attribute in attributes.filter(|attribute| Some(attribute.name) != key.as_ref().map(|(name, _)| *name)) {
        entries.push((join(attribute.name), attribute.text().into_owned()));
    }
    let text = text_in(element_read);
    if !text.trim().is_empty() {
        entries.push((join("text"), text.trim().to_owned()));
    }
    let mut seen: FxHashMap<String, usize> = FxHashMap::default();
    for inner in element_read.elements().filter(|_| nesting > 0) {
        let mut path = join(&named(inner));
        let count = seen.entry(path.clone()).or_default();
        *count += 1;
        if *count > 1 {
            path = format!("{path} #{count}");
        }
        let before = entries.len();
        element(&path, inner, nesting - 1, entries);
        if entries.len() == before {
            entries.push((path, String::new()));
        }
    }
}

fn key(element: Element<'_>) -> Option<(&'static str, String)> {
    KEYS.into_iter().find_map(|name| Some((name, element.value(name)?.trim().to_owned())))
}

/// `bioDin[3]`
fn named(element: Element<'_>) -> String {
    let key = key(element).map(|(_, key)| format!("[{key}]")).unwrap_or_default();
    format!("{}{key}", element.name())
}

/// The file describes inputs and outputs: `bio.cfx`, `sio.cfx`, `modbus.cfx`.
pub(crate) fn is_io(file_name: &str) -> bool {
    let name = file_name.to_lowercase();
    let stem = name.rsplit_once('.').map_or(name.as_str(), |(stem, _)| stem);
    let stem = stem.trim_end_matches(|last: char| last.is_ascii_digit() || matches!(last, '-' | 's'));
    let fieldbuses = ["modbus", "fieldbus", "applicom", "profinet", "ethercat", "canopen", "socket"];
    stem.ends_with("io") || stem.starts_with("io") || fieldbuses.iter().any(|bus| stem.contains(bus))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_have_the_path_of_their_elements() {
        let text = "<io xmlns=\"a\"><bioDin index=\"3\" name=\"door\"/><v>s7</v><sock><String name=\"ip\" value=\"1\"/></sock>\
            <sock><String name=\"ip\" value=\"2\"/></sock><e/></io>";
        let entries: Vec<String> =
            read(text).unwrap().into_iter().map(|(path, value)| format!("{path}={value}")).collect();
        assert_eq!(
            entries,
            ["bioDin[3] name=door", "v text=s7", "sock String[ip] value=1", "sock #2 String[ip] value=2", "e="]
        );
        assert!(read("<io>").is_none());
    }

    #[test]
    fn files_of_inputs_and_outputs() {
        assert!(["bio.cfx", "BIO2.CFX", "systemios.cfx", "sio.cfx", "ModbusSrv-0.cfx"].iter().all(|name| is_io(name)));
        assert!(!["arm.cfx", "cell.cfx", "val3version.xml"].iter().any(|name| is_io(name)));
    }
}
