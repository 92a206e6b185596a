//! Names that replaced another name in programs.

use std::collections::{BTreeMap, BTreeSet};

use similar::{Algorithm, DiffOp, capture_diff_slices};

use super::items::{ItemVersions, UnmatchedNames};
use crate::read::code::{CodeLine, Renames};
use crate::read::program::ProgramVersion;

/// Returns the removed names that were replaced by one added name in all places, where the added name replaced no other
/// name.
pub(super) fn followed(programs: &[ItemVersions<'_>], names: &[&UnmatchedNames<'_>]) -> Renames {
    let mut uses = NameUses::default();
    for versions in programs {
        if let [Some(old), Some(new)] = versions {
            uses.add(old, new);
        }
    }
    let mut followed = Renames::new();
    for names in names {
        for removed in &names.removed {
            if let Some(successor) = uses.only_successor(removed).filter(|new| names.added.contains(new)) {
                followed.insert((*removed).to_owned(), successor.to_owned());
            }
        }
    }
    followed
}

/// Names at corresponding places of both versions.
#[derive(Default)]
struct NameUses<'p> {
    successors: BTreeMap<&'p str, BTreeSet<&'p str>>,
    predecessors: BTreeMap<&'p str, BTreeSet<&'p str>>,
}

impl<'p> NameUses<'p> {
    /// Adds the names in lines that differ at most in names.
    fn add(&mut self, old: &'p ProgramVersion, new: &'p ProgramVersion) {
        let shapes = |lines: &[CodeLine]| lines.iter().map(CodeLine::shape).collect::<Vec<_>>();
        let (old_lines, new_lines) = (old.code.lines(), new.code.lines());
        for op in capture_diff_slices(Algorithm::Myers, &shapes(old_lines), &shapes(new_lines)) {
            let DiffOp::Equal { old_index, new_index, len } = op else { continue };
            let pairs = old_lines.iter().skip(old_index).zip(new_lines.iter().skip(new_index)).take(len);
            for (before, after) in pairs.flat_map(|(old, new)| old.names().zip(new.names())) {
                if !old.has_local(before) && !new.has_local(after) {
                    self.successors.entry(before).or_default().insert(after);
                    self.predecessors.entry(after).or_default().insert(before);
                }
            }
        }
    }

    /// Returns the name that always replaced `name`, if it replaced no other name.
    fn only_successor(&self, name: &str) -> Option<&'p str> {
        let only = |names: &BTreeSet<&'p str>| names.first().copied().filter(|_| names.len() == 1);
        let successor = only(self.successors.get(name)?)?;
        only(self.predecessors.get(successor)?).map(|_| successor)
    }
}
