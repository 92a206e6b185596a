//! Programs and names in both versions, and renamed items.

use std::collections::BTreeSet;

use crate::read::code::Renames;
use crate::read::program::ProgramVersion;

/// Old and new version of a program.
pub(crate) type ItemVersions<'p> = [Option<&'p ProgramVersion>; 2];

/// Renamed items: new names by old names.
#[derive(Debug, Default)]
pub(crate) struct Renamed {
    pub(crate) data: Renames,
    pub(crate) programs: Renames,
}

impl Renamed {
    /// Returns the new names of programs and data.
    pub(crate) fn names(&self) -> Renames {
        self.data.iter().chain(&self.programs).map(|(old, new)| (old.clone(), new.clone())).collect()
    }
}

/// Names that exist in only one version.
#[derive(Debug)]
pub(super) struct UnmatchedNames<'n> {
    pub(super) removed: BTreeSet<&'n str>,
    pub(super) added: BTreeSet<&'n str>,
}

impl<'n> UnmatchedNames<'n> {
    pub(super) fn of(old: impl Iterator<Item = &'n str>, new: impl Iterator<Item = &'n str>) -> Self {
        let (old, new): (BTreeSet<&str>, BTreeSet<&str>) = (old.collect(), new.collect());
        Self { removed: &old - &new, added: &new - &old }
    }

    /// Whether there is no pair with an old and a new name.
    pub(super) fn is_empty(&self) -> bool {
        self.removed.is_empty() || self.added.is_empty()
    }
}
