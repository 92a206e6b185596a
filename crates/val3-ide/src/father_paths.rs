//! References to frames and tools, as in `fatherId`.

use val3_analysis::db::{Db, Project};
use val3_analysis::items::project::{DataItem, fields};
use val3_analysis::ty::Base;
use val3_lang::types::{BaseType, Container};

use crate::hover::keys_of;

/// Maximum number of listed elements per array.
const SHOWN: u32 = 20;
/// Nesting limit of user types within user types.
const DEEPEST: u32 = 3;

/// Elements with the type `father` in a variable of `project` and in its fields, for example `fTray[0]` or
/// `tSlot["a"].fIn[0]`.
pub(crate) fn father_paths(
    db: &dyn Db,
    project: Project,
    name: &str,
    item: &DataItem,
    father: BaseType,
) -> Vec<String> {
    // Keys are read only if necessary, because most variables are numbers and reading keys is slow.
    let leads_on = matches!(item.base, Base::User(_)) || item.base == Base::of(father);
    let is_collection = item.decl.container == Container::Collection;
    let keys = if leads_on && is_collection { keys_of(db, project, name) } else { Vec::new() };
    paths(db, name, item, father, &keys, 0)
}

fn paths(db: &dyn Db, name: &str, item: &DataItem, father: BaseType, keys: &[String], depth: u32) -> Vec<String> {
    match item.base {
        base if base == Base::of(father) => elements(name, item, keys),
        Base::User(project) if depth < DEEPEST => {
            let mut fields: Vec<_> = fields(db, project).iter().collect();
            fields.sort_unstable_by_key(|(name, _)| *name);
            let inner: Vec<String> =
                fields.into_iter().flat_map(|(name, field)| paths(db, name, field, father, &[], depth + 1)).collect();
            let elements = if inner.is_empty() { Vec::new() } else { elements(name, item, keys) };
            elements.iter().flat_map(|element| inner.iter().map(move |field| format!("{element}.{field}"))).collect()
        }
        _ => Vec::new(),
    }
}

/// Elements of a variable.
fn elements(name: &str, item: &DataItem, keys: &[String]) -> Vec<String> {
    match (item.decl.container, item.decl.sizes.as_slice()) {
        (Container::Collection, _) => keys.iter().map(|key| format!("{name}[\"{key}\"]")).collect(),
        (_, [size]) => (0..(*size).min(SHOWN)).map(|index| format!("{name}[{index}]")).collect(),
        (_, sizes) => vec![format!("{name}[{}]", vec!["0"; sizes.len().max(1)].join(","))],
    }
}
