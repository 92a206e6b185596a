//! Changes of items, and values in both trees.

use serde::Serialize;

/// Change from the old to the new tree.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Change {
    /// The item is only in the new tree.
    Added,
    /// The item is only in the old tree.
    Removed,
    /// The item is in both trees, with differences.
    Changed,
}

impl Change {
    /// Returns the change for an item that is in the old tree, in the new tree, or in both.
    pub(crate) fn of(in_old: bool, in_new: bool) -> Self {
        match (in_old, in_new) {
            (false, true) => Self::Added,
            (true, false) => Self::Removed,
            _ => Self::Changed,
        }
    }
}

/// A value in both trees.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ValuePair<T> {
    /// Value in the old tree.
    pub old: T,
    /// Value in the new tree.
    pub new: T,
}

impl<T: PartialEq> ValuePair<T> {
    /// Returns both values, if they differ.
    pub(crate) fn differing(old: T, new: T) -> Option<Self> {
        (old != new).then_some(Self { old, new })
    }
}
