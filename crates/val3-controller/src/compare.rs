//! Three-way comparison: the last pull or push, the files here, and the files of the controller.

use std::collections::{BTreeMap, BTreeSet};

use crate::digest::{FileDigest, FileDigests};
use crate::path::ControllerPath;

/// Change of a file on one side since the last pull or push.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SideChange {
    /// The file is new.
    Added,
    /// The file has another content.
    Modified,
    /// The file was removed.
    Removed,
}

/// Difference of a file between both sides, or from the last pull or push.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileDifference {
    /// Only the local file has changed.
    Local(SideChange),
    /// Only the file on the controller has changed.
    Controller(SideChange),
    /// Both have changed, and differ.
    Conflict {
        /// Change of the local file.
        local: SideChange,
        /// Change of the file on the controller.
        controller: SideChange,
    },
    /// Both have changed in the same way.
    Alike(SideChange),
}

/// Files with a difference, by path.
pub type FileDifferences = BTreeMap<ControllerPath, FileDifference>;

/// Compares contents.
#[must_use]
pub fn compare(base: &FileDigests, local: &FileDigests, controller: &FileDigests) -> FileDifferences {
    let paths: BTreeSet<&ControllerPath> = base.keys().chain(local.keys()).chain(controller.keys()).collect();
    let difference = |path: &ControllerPath| difference(base.get(path), local.get(path), controller.get(path));
    paths.into_iter().filter_map(|path| Some((path.clone(), difference(path)?))).collect()
}

/// Compares the versions of a file; `None` if both sides are unchanged.
fn difference(
    base: Option<&FileDigest>,
    local: Option<&FileDigest>,
    controller: Option<&FileDigest>,
) -> Option<FileDifference> {
    match (side_change(base, local), side_change(base, controller)) {
        (None, None) => None,
        (Some(local), None) => Some(FileDifference::Local(local)),
        (None, Some(controller)) => Some(FileDifference::Controller(controller)),
        (Some(change), Some(_)) if local == controller => Some(FileDifference::Alike(change)),
        (Some(local), Some(controller)) => Some(FileDifference::Conflict { local, controller }),
    }
}

fn side_change(base: Option<&FileDigest>, side: Option<&FileDigest>) -> Option<SideChange> {
    match (base, side) {
        (None, Some(_)) => Some(SideChange::Added),
        (Some(_), None) => Some(SideChange::Removed),
        (Some(base), Some(side)) if base != side => Some(SideChange::Modified),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Contents of three files on one side; 0 means that the file does not exist.
    fn digests(contents: [u8; 3]) -> FileDigests {
        let files = contents.iter().zip(["a", "b", "c"]).filter(|(content, _)| **content != 0);
        files.map(|(content, name)| (ControllerPath::parse(name).unwrap(), FileDigest::of(&[*content]))).collect()
    }

    /// Copies the files with a difference of this kind from one side to the other.
    fn apply(from: &FileDigests, to: &mut FileDigests, paths: impl Iterator<Item = ControllerPath>) {
        for path in paths {
            match from.get(&path) {
                Some(digest) => _ = to.insert(path, digest.clone()),
                None => _ = to.remove(&path),
            }
        }
    }

    proptest! {
        /// After a pull and a push, both sides differ only in conflicts, and no change of a side is lost.
        #[test]
        fn pull_and_push_agree(base: [u8; 3], local: [u8; 3], controller: [u8; 3]) {
            let [base, local, controller] =
                [base, local, controller].map(|side| digests(side.map(|content| content % 3)));
            let differences = compare(&base, &local, &controller);
            let of = |wanted: fn(&FileDifference) -> bool| {
                differences.iter().filter(move |(_, difference)| wanted(difference)).map(|(path, _)| path.clone())
            };
            let (mut pulled, mut pushed) = (local.clone(), controller.clone());
            apply(&controller, &mut pulled, of(|difference| matches!(difference, FileDifference::Controller(_))));
            apply(&local, &mut pushed, of(|difference| matches!(difference, FileDifference::Local(_))));
            let conflicts: BTreeSet<_> = of(|difference| matches!(difference, FileDifference::Conflict { .. })).collect();
            for path in ["a", "b", "c"].map(|name| ControllerPath::parse(name).unwrap()) {
                prop_assert_eq!(pulled.get(&path) != pushed.get(&path), conflicts.contains(&path));
                if !differences.contains_key(&path) {
                    prop_assert!(base.get(&path) == local.get(&path) && base.get(&path) == controller.get(&path));
                }
            }
        }
    }
}
