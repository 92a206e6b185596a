//! Programs with another name and the same code.

use similar::TextDiff;

use super::items::{Names, Renamed, Versions};
use crate::read::code::Renames;
use crate::read::program::Program;

/// The part of the lines that a program has in common with the one whose calls follow the new name.
const LEAST_RATIO: f32 = 0.5;

/// `begin` and `end`: many programs have no other code.
const EMPTY: usize = 2;

/// Adds the renamed programs: those with the same parameters, variables and statements, and those that calls follow, if their code is similar.
pub(super) fn find(programs: &[Versions<'_>], names: &Names<'_>, followed: &Renames, renamed: &mut Renamed) {
    let removed = programs
        .iter()
        .filter_map(|[old, _]| *old)
        .filter(|program| names.removed.contains(program.header.name.as_str()));
    let added: Vec<&Program> = programs
        .iter()
        .filter_map(|[_, new]| *new)
        .filter(|program| names.added.contains(program.header.name.as_str()))
        .collect();
    let removed: Vec<&Program> = removed.collect();
    for old in &removed {
        let successor = followed.get(old.header.name.as_str());
        let new = added.iter().find(|new| Some(new.header.name.as_str()) == successor.map(String::as_str));
        if let Some(new) = new.filter(|new| is_similar(old, new)) {
            renamed.programs.insert(old.header.name.to_string(), new.header.name.to_string());
        }
    }
    let mut others = Vec::new();
    for old in removed.iter().filter(|old| !renamed.programs.contains_key(old.header.name.as_str())) {
        let is_taken = |new: &Program| renamed.programs.values().any(|name| *name == new.header.name);
        let same: Vec<&&Program> =
            added.iter().filter(|new| !is_taken(new) && is_same(old, new, &renamed.names())).collect();
        let rivals =
            removed.iter().filter(|other| same.first().is_some_and(|new| is_same(other, new, &renamed.names())));
        if let ([new], 1) = (same.as_slice(), rivals.count()) {
            others.push((old.header.name.to_string(), new.header.name.to_string()));
        }
    }
    renamed.programs.extend(others);
}

/// Whether both have the same parameters, variables and statements, and more than none.
fn is_same(old: &Program, new: &Program, renames: &Renames) -> bool {
    let mut renames = renames.clone();
    renames.insert(old.header.name.to_string(), new.header.name.to_string());
    old.header.params == new.header.params
        && old.header.locals == new.header.locals
        && old.code.statements(&renames).nth(EMPTY).is_some()
        && old.code.same_statements(&new.code, &renames)
}

/// Whether at least half of the lines between `begin` and `end` are the same.
fn is_similar(old: &Program, new: &Program) -> bool {
    let [old, new] = [old, new].map(|program| {
        let lines = program.code.lines();
        let inner = lines.get(1..lines.len().saturating_sub(1)).unwrap_or_default();
        inner.iter().map(|line| line.text.as_str()).collect::<Vec<_>>()
    });
    TextDiff::from_slices(&old, &new).ratio() >= LEAST_RATIO
}
