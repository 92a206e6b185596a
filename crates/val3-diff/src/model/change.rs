//! What happened to an item, and values of both trees.

use serde::Serialize;

/// What happened to an item from the old to the new tree.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Change {
    /// Only the new tree has it.
    Added,
    /// Only the old tree has it.
    Removed,
    /// Both have it, with differences.
    Changed,
}

impl Change {
    /// The change of an item that is in the old tree, in the new one, or in both.
    pub(crate) fn of(in_old: bool, in_new: bool) -> Self {
        match (in_old, in_new) {
            (false, true) => Self::Added,
            (true, false) => Self::Removed,
            _ => Self::Changed,
        }
    }
}

/// A value of both trees.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Pair<T> {
    /// In the old tree.
    pub old: T,
    /// In the new tree.
    pub new: T,
}

impl<T: PartialEq> Pair<T> {
    /// Both values, if they differ.
    pub(crate) fn differing(old: T, new: T) -> Option<Self> {
        (old != new).then_some(Self { old, new })
    }
}
