//! Names of data. A file of s5 or s6 has a section for each type, so one name may come into two sections.

use rustc_hash::{FxHashMap, FxHashSet};
use smol_str::SmolStr;

use crate::node::Node;

/// Names of the data that ours has added, be it with another type.
pub(crate) fn added(base: Option<&Node<'_>>, ours: &Node<'_>) -> FxHashSet<SmolStr> {
    let old: FxHashMap<SmolStr, String> = base.into_iter().flat_map(declarations).collect();
    declarations(ours).filter(|(name, id)| old.get(name) != Some(id)).map(|(name, _)| name).collect()
}

/// Names and identities of the declarations of a file.
fn declarations<'n>(file: &'n Node<'_>) -> impl Iterator<Item = (SmolStr, String)> + 'n {
    let lists = file.children.iter().flat_map(|root| &root.children);
    lists.flat_map(|list| &list.children).filter_map(|data| Some((data.key.clone()?, data.id.clone())))
}
