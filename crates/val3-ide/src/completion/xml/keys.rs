//! Keys and indexes of values, and initial values of attributes.

use val3_analysis::items::sizes;
use val3_lang::enumerations;
use val3_lang::types::{AttributeValue, BaseType, DefaultValue, ValueAttribute};

use crate::completion::list::CompletionList;
use crate::declare::built_in_father;
use crate::rename::spelt_keys;
use crate::xml_context::XmlContext;

/// Limit of offered array indexes.
const SHOWN: usize = 50;

/// Most likely key or index of a new value.
pub(super) fn next(found: &CompletionList<'_>, context: &XmlContext<'_>) -> String {
    let key = free(found, context).into_iter().next();
    key.unwrap_or_else(|| if is_collection(context) { "key" } else { "0" }.to_owned())
}

/// Unused keys: array indexes, or collection keys that the code uses.
pub(super) fn free(found: &CompletionList<'_>, context: &XmlContext<'_>) -> Vec<String> {
    let Some((data, parent)) = context.declarations().next() else { return Vec::new() };
    let is_old = parent.ends_with("Section");
    let attribute = if is_old { "index" } else { "key" };
    let is_direct = matches!(parent, "Datas");
    let keys = match is_collection(context) {
        true if is_direct => spelt_keys(found.db, found.project, data.value("name").unwrap_or("")),
        true => Vec::new(),
        // In the old dialect, the size is the number of values.
        false if is_old => (0..=context.cursor.siblings.len()).map(|index| index.to_string()).collect(),
        false => indexes(&data.value("size").and_then(sizes).unwrap_or_else(|| vec![1]), context.cursor.siblings.len()),
    };
    keys.into_iter().filter(|key| !context.cursor.has_sibling_with(attribute, key)).take(SHOWN).collect()
}

fn is_collection(context: &XmlContext<'_>) -> bool {
    context.declarations().next().is_some_and(|(data, _)| data.value("xsi:type") == Some("collection"))
}

/// First array indexes, at most [`SHOWN`] more than `taken`.
fn indexes(sizes: &[u32], taken: usize) -> Vec<String> {
    let wanted = taken.saturating_add(SHOWN);
    let mut keys = vec![String::new()];
    for size in sizes {
        let longer = keys.iter().flat_map(|key| {
            (0..*size).map(move |index| if key.is_empty() { index.to_string() } else { format!("{key},{index}") })
        });
        keys = longer.take(wanted).collect();
    }
    keys
}

/// Default of a value's attribute.
pub(super) fn initial(attribute: &ValueAttribute) -> String {
    match (attribute.value, attribute.default) {
        (AttributeValue::Father(ty), _) => father(ty),
        (_, DefaultValue::Number(number)) => number.to_string(),
        (_, DefaultValue::False) => "false".to_owned(),
        (_, DefaultValue::Enumerator(name)) => {
            enumerations::find(name).map_or(name, |found| found.file_name).to_owned()
        }
        _ => String::new(),
    }
}

/// Default father of a position.
fn father(ty: BaseType) -> String {
    built_in_father(ty.name()).map(|name| format!("{name}[0]")).unwrap_or_default()
}
