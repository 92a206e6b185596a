//! Completions in the XML of a file: elements, attributes, values.

mod attributes;
mod elements;
mod fathers;
mod keys;
mod names;
mod snippet;
mod values;

use super::list::{Completion, CompletionKind, CompletionList};
use crate::xml_context::XmlContext;
use crate::xml_cursor::XmlPlace;

/// Adds the completions at a position in XML.
pub(super) fn complete(found: &mut CompletionList<'_>, context: &XmlContext<'_>) {
    match context.cursor.place {
        XmlPlace::Content(_) => elements::elements(found, context, "<"),
        XmlPlace::ElementName(_) => elements::elements(found, context, ""),
        XmlPlace::EndTag(_) => {
            let name = context.parent();
            if !name.is_empty() {
                let end = if found.is_before(">") { "" } else { ">" };
                let added = found.add(name, CompletionKind::Element).detail(|| "ends the element".to_owned());
                added.with(|item| {
                    item.insert += end;
                    item.plain += end;
                });
            }
        }
        XmlPlace::AttributeName(_) => attributes::attributes(found, context),
        XmlPlace::Value(name, _) => {
            values::values(found, context, name);
            if !found.is_preceded_by(['"', '\'']) {
                found.items.iter_mut().for_each(quote);
            }
        }
    }
}

/// Adds the missing quotes to a value.
fn quote(item: &mut Completion) {
    item.insert = format!("\"{}\"", item.insert);
    item.plain = format!("\"{}\"", item.plain);
}
