//! References to other data in elements of s5 and s6. For example, `<pFather alias="" name="fTable" fatherIndex="0" />`
//! is `fTable[0]`, and `<io alias="io" name="valve1" ioIndex="0" … />` is `io:valve1[0]`.

use val3_lang::keywords::is_identifier;
use val3_syntax::xml::XmlElement;

use crate::edits::Edits;
use crate::tag;

/// Names of the attribute with the index.
const INDEXES: [&str; 2] = ["fatherIndex", "ioIndex"];

/// Data of an application or one of its libraries.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
struct DataReference<'t> {
    alias: &'t str,
    name: &'t str,
    index: &'t str,
}

/// Reference in an element; empty if it has no name.
pub(crate) fn text(element: XmlElement<'_>) -> String {
    let value = |name: &str| element.value(name).unwrap_or_default();
    let (alias, name) = (value("alias"), value("name"));
    if name.is_empty() {
        return String::new();
    }
    let index = INDEXES.into_iter().find_map(|name| element.value(name)).unwrap_or("0".into());
    let library = if alias.is_empty() { String::new() } else { format!("{alias}:") };
    format!("{library}{name}[{index}]")
}

/// Changes the reference in an element. An invalid reference has no effect.
pub(crate) fn write(edits: &mut Edits, element: XmlElement<'_>, text: &str) {
    let Some(new) = parse(text) else { return };
    let index = INDEXES.into_iter().find(|name| element.attribute(name).is_some()).unwrap_or("");
    for (name, text) in [("alias", new.alias), ("name", new.name), (index, new.index)] {
        if let Some(attribute) = element.attribute(name).filter(|attribute| attribute.text() != text) {
            edits.replace(attribute.range, tag::escaped(text, attribute.quote));
        }
    }
}

/// Whether the text is empty, or has the form `alias:name[index]` with optional library and index.
#[must_use]
pub fn is_old_reference(text: &str) -> bool {
    parse(text).is_some()
}

fn parse(text: &str) -> Option<DataReference<'_>> {
    if text.is_empty() {
        return Some(DataReference { index: "0", ..DataReference::default() });
    }
    let (alias, rest) = text.split_once(':').unwrap_or(("", text));
    let (name, index) = match rest.strip_suffix(']') {
        Some(rest) => rest.split_once('[')?,
        None => (rest, "0"),
    };
    let is_sound = (alias.is_empty() || is_identifier(alias)) && is_identifier(name) && index.parse::<u32>().is_ok();
    is_sound.then_some(DataReference { alias, name, index })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn references_have_a_library_and_an_index() {
        let parsed = |text| parse(text).map(|found| [found.alias, found.name, found.index]);
        assert_eq!(parsed("io:valve1[2]"), Some(["io", "valve1", "2"]));
        assert_eq!(parsed("world"), Some(["", "world", "0"]));
        assert_eq!(parsed(""), Some(["", "", "0"]));
        for text in ["f[", "f[a]", "f]", ":f[0]x", "a b[0]", r"Modbus\In[0]"] {
            assert_eq!(parsed(text), None, "{text}");
        }
    }
}
