//! Frames and tools that a value can be relative to.

use val3_analysis::db::Db;
use val3_analysis::items::project::{DataItem, fields, items};
use val3_analysis::ty::Base;
use val3_lang::builtins;
use val3_lang::types::{BaseType, Container};
use val3_syntax::xml::escaped;

use crate::completion::list::{CompletionKind as Kind, CompletionList};
use crate::completion::names::data_detail;
use crate::hover::keys_of;
use crate::xml_context::XmlContext;

/// Elements of one array that are offered at most.
const SHOWN: u32 = 20;
/// User types within user types that are looked into.
const DEEPEST: u32 = 3;

/// Frames for points and frames, tools for tools; with an index in s7 and s8.
pub(super) fn fathers(found: &mut CompletionList<'_>, context: &XmlContext<'_>, is_old: bool) {
    let Some((ty, _)) = context.builtin(found.db, found.project) else { return };
    let Some(father) = ty.father() else { return };
    let own = context.declarations().last().and_then(|(data, _)| data.value("name"));
    let mut data: Vec<_> = items(found.db, found.project).data.iter().collect();
    data.sort_unstable_by_key(|(name, _)| *name);
    for (name, item) in data {
        // A single frame or tool is not relative to itself.
        if own == Some(name.as_str()) && item.decl.sizes == [1] {
            continue;
        }
        if is_old {
            if item.base == Base::of(father) {
                found.add(name, Kind::Data).detail(|| data_detail(item));
            }
            continue;
        }
        for (place, reference) in (0..).zip(references(found, name, item, father, 0)) {
            found.add(&reference, Kind::Data).detail(|| data_detail(item)).scored(-place);
        }
    }
    let index = if is_old { "" } else { "[0]" };
    for builtin in builtins::BUILTINS.iter().filter(|builtin| builtin.ty == father && builtin.is_variable) {
        found.add(&format!("{}{index}", builtin.name), Kind::Constant).detail(|| father.name().to_owned());
    }
}

/// The elements of a variable, or of fields in them, that have the type `father`: `fTray[0]`, `tSlot["a"].fIn[0]`.
fn references(found: &CompletionList<'_>, name: &str, item: &DataItem, father: BaseType, depth: u32) -> Vec<String> {
    let db: &dyn Db = found.db;
    let keys = if depth == 0 { keys_of(db, found.project, name) } else { Vec::new() };
    let elements = elements(name, item, &keys);
    match item.base {
        base if base == Base::of(father) => elements,
        Base::User(project) if depth < DEEPEST => {
            let mut fields: Vec<_> = fields(db, project).iter().collect();
            fields.sort_unstable_by_key(|(name, _)| *name);
            let inner: Vec<String> = fields
                .into_iter()
                .flat_map(|(name, field)| references(found, name, field, father, depth + 1))
                .collect();
            elements.iter().flat_map(|element| inner.iter().map(move |field| format!("{element}.{field}"))).collect()
        }
        _ => Vec::new(),
    }
}

/// The elements of a variable, as an attribute writes them.
fn elements(name: &str, item: &DataItem, keys: &[String]) -> Vec<String> {
    match (item.decl.container, item.decl.sizes.as_slice()) {
        (Container::Collection, _) => keys.iter().map(|key| escaped(&format!("{name}[\"{key}\"]"))).collect(),
        (_, [size]) => (0..(*size).min(SHOWN)).map(|index| format!("{name}[{index}]")).collect(),
        (_, sizes) => vec![format!("{name}[{}]", vec!["0"; sizes.len().max(1)].join(","))],
    }
}
