//! Renamed programs: programs with the same code under another name.

use std::collections::{BTreeMap, BTreeSet};

use similar::TextDiff;

use super::items::{ItemVersions, Renamed, UnmatchedNames};
use crate::read::code::Renames;
use crate::read::program::ProgramVersion;

/// Minimum ratio of equal lines between a program and its successor according to the calls.
const LEAST_RATIO: f32 = 0.5;

/// Placeholder for the program's own name in its code.
const SELF: &str = "\0";

/// Number of tokens in `begin` and `end`, which are the only code of many programs.
const EMPTY: usize = 2;

/// Adds the renamed programs: programs with equal parameters, variables and statements, and programs whose calls use a
/// new name, if their code is similar.
pub(super) fn find(
    programs: &[ItemVersions<'_>],
    names: &UnmatchedNames<'_>,
    followed: &Renames,
    renamed: &mut Renamed,
) {
    let removed = programs
        .iter()
        .filter_map(|[old, _]| *old)
        .filter(|program| names.removed.contains(program.header.name.as_str()));
    let added: Vec<&ProgramVersion> = programs
        .iter()
        .filter_map(|[_, new]| *new)
        .filter(|program| names.added.contains(program.header.name.as_str()))
        .collect();
    let removed: Vec<&ProgramVersion> = removed.collect();
    for old in &removed {
        let successor = followed.get(old.header.name.as_str());
        let new = added.iter().find(|new| Some(new.header.name.as_str()) == successor.map(String::as_str));
        if let Some(new) = new.filter(|new| is_similar(old, new)) {
            renamed.programs.insert(old.header.name.to_string(), new.header.name.to_string());
        }
    }
    let taken: BTreeSet<String> = renamed.programs.values().cloned().collect();
    let open = removed.into_iter().filter(|old| !renamed.programs.contains_key(old.header.name.as_str()));
    let free = added.into_iter().filter(|new| !taken.contains(new.header.name.as_str()));
    let (old, new) = (by_body(open, renamed.names()), by_body(free, Renames::new()));
    let pairs = old.iter().filter_map(|(body, names)| match (names.as_slice(), new.get(body)?.as_slice()) {
        ([before], [after]) => Some((before.clone(), after.clone())),
        _ => None,
    });
    renamed.programs.extend(pairs);
}

/// Returns program names by parameters, variables and statements. Programs without statements are omitted.
fn by_body<'p>(
    programs: impl Iterator<Item = &'p ProgramVersion>,
    mut renames: Renames,
) -> BTreeMap<String, Vec<String>> {
    let mut found: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for program in programs {
        let name = program.header.name.to_string();
        // A recursive program calls itself by its own name.
        let before = renames.insert(name.clone(), SELF.to_owned());
        let statements: Vec<&str> = program.code.statements(&renames).collect();
        if statements.len() > EMPTY {
            let body = format!("{:?} {:?} {statements:?}", program.header.params, program.header.locals);
            found.entry(body).or_default().push(name.clone());
        }
        match before {
            Some(new) => renames.insert(name, new),
            None => renames.remove(&name),
        };
    }
    found
}

/// Whether at least half of the lines between `begin` and `end` are equal.
fn is_similar(old: &ProgramVersion, new: &ProgramVersion) -> bool {
    let [old, new] = [old, new].map(|program| {
        let lines = program.code.lines();
        let inner = lines.get(1..lines.len().saturating_sub(1)).unwrap_or_default();
        inner.iter().map(|line| line.text.as_str()).collect::<Vec<_>>()
    });
    TextDiff::from_slices(&old, &new).ratio() >= LEAST_RATIO
}
