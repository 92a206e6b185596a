//! Data names. A file of s5 or s6 has a section for each type, so merging may add one name to two sections.

use rustc_hash::{FxHashMap, FxHashSet};
use smol_str::SmolStr;

use crate::node::MergeNode;

/// Returns the names of data that ours has added or declared with another type.
pub(crate) fn added(base: Option<&MergeNode<'_>>, ours: &MergeNode<'_>) -> FxHashSet<SmolStr> {
    let old: FxHashMap<SmolStr, String> = base.into_iter().flat_map(declarations).collect();
    declarations(ours).filter(|(name, id)| old.get(name) != Some(id)).map(|(name, _)| name).collect()
}

/// Returns the names and identities of the declarations in a file.
fn declarations<'n>(file: &'n MergeNode<'_>) -> impl Iterator<Item = (SmolStr, String)> + 'n {
    let lists = file.children.iter().flat_map(|root| &root.children);
    lists.flat_map(|list| &list.children).filter_map(|data| Some((data.key.clone()?, data.id.clone())))
}
