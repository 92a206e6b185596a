//! Elements in an XML file as a flat list of entries.

use rustc_hash::FxHashMap;
use val3_analysis::xml::XmlElement;

use super::program::text_in;

/// Maximum nesting of elements that are read, so that hostile files cannot overflow the stack.
const NESTING: usize = 64;

/// An attribute, or the text of an element.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct XmlEntry {
    /// Enclosing elements and the attribute, for example `bioDin[3] name`.
    pub(crate) path: String,
    /// Value; empty for an element.
    pub(crate) value: String,
}

/// Rules for converting elements to entries.
#[derive(Debug)]
pub(crate) struct EntryRules {
    /// Attributes that identify an element among its siblings, in this order.
    pub(crate) keys: &'static [&'static str],
    /// Elements to omit.
    pub(crate) without: &'static [&'static str],
    /// Whether each element with a key has a separate entry without a value. Otherwise only an element without content
    /// has one.
    pub(crate) has_keys: bool,
}

/// Returns the entries in an element, in order.
pub(crate) fn entries(root: XmlElement<'_>, style: &EntryRules) -> Vec<XmlEntry> {
    let mut entries = Vec::new();
    add("", root, style, NESTING, &mut entries);
    entries
}

fn add(around: &str, element: XmlElement<'_>, style: &EntryRules, nesting: usize, entries: &mut Vec<XmlEntry>) {
    let join = |name: &str| if around.is_empty() { name.to_owned() } else { format!("{around} {name}") };
    let key = key_of(element, style);
    for attribute in
        element.attributes().filter(|attribute| Some(attribute.name) != key.as_ref().map(|(name, _)| *name))
    {
        entries.push(XmlEntry { path: join(attribute.name), value: attribute.text().into_owned() });
    }
    let text = text_in(element);
    if !text.trim().is_empty() {
        entries.push(XmlEntry { path: join("text"), value: text.trim().to_owned() });
    }
    let mut seen: FxHashMap<String, usize> = FxHashMap::default();
    let inner = element.elements().filter(|inner| nesting > 0 && !style.without.contains(&inner.name()));
    for inner in inner {
        let mut path = join(&named(inner, style));
        let count = seen.entry(path.clone()).or_default();
        *count += 1;
        if *count > 1 {
            path = format!("{path} #{count}");
        }
        let before = entries.len();
        if style.has_keys && key_of(inner, style).is_some() {
            entries.push(XmlEntry { path: path.clone(), value: String::new() });
        }
        add(&path, inner, style, nesting - 1, entries);
        if entries.len() == before {
            entries.push(XmlEntry { path, value: String::new() });
        }
    }
}

fn key_of(element: XmlElement<'_>, style: &EntryRules) -> Option<(&'static str, String)> {
    style.keys.iter().find_map(|name| Some((*name, element.value(name)?.trim().to_owned())))
}

/// Formats an element with its key, for example `bioDin[3]`.
fn named(element: XmlElement<'_>, style: &EntryRules) -> String {
    let key = key_of(element, style).map(|(_, key)| format!("[{key}]")).unwrap_or_default();
    format!("{}{key}", element.name())
}
