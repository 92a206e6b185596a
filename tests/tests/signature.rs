//! Changes of program signatures: nothing changes for the programs of a cell, and the inverse change restores every
//! byte.
//!
//! `VAL3_PROGRAMS=FOLDER cargo test -p val3-tests --test it signature::public -- --ignored --nocapture` does the same
//! at random locations in programs outside this repository, for each folder below `FOLDER`, and prints a table.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::panic, reason = "a test may fail loudly")]
#![allow(clippy::disallowed_methods, reason = "the public programs are named by the environment")]

mod cell;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use camino::Utf8PathBuf;
use cell::ChangedCell;
use val3_analysis::db::File;
use val3_analysis::items::program::header;
use val3_ide::{NewParameter, NewVariables, Variables, change_signature};
use val3_lang::types::Container;

/// Number of locations for each kind of change.
const PLACES: usize = 50;

/// A name that no program has.
const NEW: &str = "zq_new";

/// Pseudo-random numbers, the same in every run.
struct Chance(u64);

impl Chance {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).unwrap() % limit.max(1)
    }
}

/// A kind of change with its inverse. The number is the index of the parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    Add,
    Rename,
    Reorder,
    Remove,
}

const KINDS: [Kind; 4] = [Kind::Add, Kind::Rename, Kind::Reorder, Kind::Remove];

impl Kind {
    /// Returns the parameters at which the program can be changed in this way.
    fn places(self, found: &Variables) -> Vec<usize> {
        let count = found.parameters.len();
        match self {
            Self::Add => (0..=count).collect(),
            Self::Rename => (0..count).collect(),
            Self::Reorder => (1..count).collect(),
            Self::Remove => (0..count).filter(|index| found.parameters[*index].uses == 0).collect(),
        }
    }

    fn change(self, index: usize, new: &mut NewVariables) {
        match self {
            Self::Add => new.parameters.insert(index, added()),
            Self::Rename => NEW.clone_into(&mut new.parameters[index].name),
            Self::Reorder => {
                let moved = new.parameters.remove(index);
                new.parameters.insert(0, moved);
            }
            Self::Remove => drop(new.parameters.remove(index)),
        }
    }

    /// Applies the inverse to the changed program; `None` if there is no inverse.
    fn back(self, index: usize, old: &str, new: &mut NewVariables) -> Option<()> {
        match self {
            Self::Add => drop(new.parameters.remove(index)),
            Self::Rename => old.clone_into(&mut new.parameters[index].name),
            Self::Reorder => {
                let moved = new.parameters.remove(0);
                new.parameters.insert(index, moved);
            }
            Self::Remove => return None,
        }
        Some(())
    }
}

fn added() -> NewParameter {
    NewParameter {
        from: None,
        name: NEW.to_owned(),
        type_name: "num".to_owned(),
        container: Container::Element,
        by_reference: false,
        argument: "1".to_owned(),
    }
}

/// Results by kind of change.
#[derive(Debug, Default)]
struct Outcomes {
    done: usize,
    returned: usize,
    edits: usize,
    refused: BTreeMap<String, usize>,
    failures: Vec<String>,
}

impl Outcomes {
    /// Changes the program in a file, and applies the inverse.
    fn check(&mut self, cell: &mut ChangedCell, kind: Kind, file: File, index: usize) {
        let mut wanted = NewVariables::of(header(cell.db(), file));
        let old = wanted.parameters.get(index).map_or(NEW.to_owned(), |old| old.name.clone());
        // Findings about a parameter are added or removed with the parameter.
        let (gone, come, renamed) = match kind {
            Kind::Add => (NEW, NEW, None),
            Kind::Remove => (old.as_str(), old.as_str(), None),
            Kind::Rename => (NEW, NEW, Some(old.as_str())),
            Kind::Reorder => (NEW, NEW, None),
        };
        kind.change(index, &mut wanted);
        let change = match change_signature(cell.db(), file, &wanted) {
            Ok(change) => change,
            Err(reason) => return *self.refused.entry(anonymous(&reason.0)).or_default() += 1,
        };
        let findings = cell.findings(gone, None);
        let place = format!("{kind:?} {index} of {}", file.path(cell.db()));
        let before = cell.apply(&change);
        self.done += 1;
        self.edits += change.edits.len();
        let after = cell.findings(come, renamed);
        let added: Vec<_> = after.iter().filter(|(found, count)| findings.get(*found) != Some(count)).collect();
        if !added.is_empty() || (kind != Kind::Remove && after.len() < findings.len()) {
            let lost: Vec<_> = findings.iter().filter(|(found, count)| after.get(*found) != Some(count)).collect();
            self.failures.push(format!("{place}: findings {added:#?} instead of {lost:#?}"));
        }
        let mut back = NewVariables::of(header(cell.db(), file));
        if kind.back(index, &old, &mut back).is_some() {
            match change_signature(cell.db(), file, &back) {
                Ok(change) => _ = cell.apply(&change),
                Err(reason) => self.failures.push(format!("{place}: no way back, {}", reason.0)),
            }
            let differ = before.iter().filter(|(file, text)| file.text(cell.db()) != text);
            let differ: Vec<_> = differ.map(|(file, _)| file.path(cell.db())).collect();
            match differ.is_empty() {
                true => self.returned += 1,
                false => self.failures.push(format!("{place}: other bytes in {differ:?}")),
            }
        }
        cell.restore(before);
    }
}

/// Returns a reason without the names in it.
fn anonymous(reason: &str) -> String {
    (0..).zip(reason.split('`')).map(|(place, part)| if place % 2 == 0 { part } else { "…" }).collect()
}

/// Applies each kind of change at `count` random locations; `None` means all locations.
fn outcomes(cell: &mut ChangedCell, count: Option<usize>) -> BTreeMap<Kind, Outcomes> {
    let programs = cell.programs();
    let mut chance = Chance(1);
    let mut all = BTreeMap::new();
    for kind in KINDS {
        let places =
            programs.iter().flat_map(|(file, found)| kind.places(found).into_iter().map(move |index| (*file, index)));
        let mut places: Vec<(File, usize)> = places.collect();
        let outcomes: &mut Outcomes = all.entry(kind).or_default();
        while !places.is_empty() && count.is_none_or(|count| outcomes.done < count) {
            let (file, index) = places.swap_remove(chance.below(places.len()));
            outcomes.check(cell, kind, file, index);
        }
    }
    all
}

fn example(name: &str) -> ChangedCell {
    let files = val3_tests::cell::files(name).into_iter();
    ChangedCell::open(files.map(|(path, bytes)| (Utf8PathBuf::from("/").join(path), bytes)))
}

#[test]
fn signatures_of_the_examples_change_there_and_back() {
    for (name, least) in [("palletiser", 20), ("faulty", 1)] {
        let all = outcomes(&mut example(name), None);
        for (kind, outcomes) in &all {
            assert_eq!(outcomes.failures, [] as [String; 0], "{name} {kind:?}");
            assert!(*kind == Kind::Remove || outcomes.returned == outcomes.done, "{name} {kind:?}");
        }
        assert!(all[&Kind::Add].done >= least && all[&Kind::Rename].done >= least, "{name}: {all:#?}");
    }
}

#[test]
#[ignore = "it needs a folder of programs in VAL3_PROGRAMS"]
fn signatures_of_public_programs_change_there_and_back() {
    let folder = PathBuf::from(std::env::var("VAL3_PROGRAMS").unwrap());
    let mut failed = 0;
    for entry in std::fs::read_dir(&folder).unwrap() {
        let root = entry.unwrap().path();
        let mut files = Vec::new();
        collect(&root, &root, &mut files);
        let mut cell = ChangedCell::open(files.into_iter());
        for (kind, outcomes) in outcomes(&mut cell, Some(PLACES)) {
            let Outcomes { done, returned, edits, refused, failures } = outcomes;
            let name = root.file_name().unwrap().display();
            println!(
                "| {name} | {kind:?} | {done} done | {edits} edits | {returned} returned | {} failed |",
                failures.len()
            );
            refused.iter().for_each(|(reason, count)| println!("    refused {count}: {reason}"));
            failures.iter().take(5).for_each(|failure| println!("    {failure}"));
            failed += failures.len();
        }
    }
    assert_eq!(failed, 0, "failures");
}

/// Collects the files of projects below a folder.
fn collect(root: &Path, folder: &Path, files: &mut Vec<(Utf8PathBuf, Vec<u8>)>) {
    for path in std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        let extension = path.extension().and_then(|it| it.to_str()).unwrap_or("").to_ascii_lowercase();
        if path.is_dir() {
            collect(root, &path, files);
        } else if ["pgx", "dtx", "pjx", "cfx"].contains(&extension.as_str()) {
            let inside = Utf8PathBuf::from_path_buf(path.strip_prefix(root).unwrap().to_owned()).unwrap();
            files.push((Utf8PathBuf::from("/").join(inside), std::fs::read(&path).unwrap()));
        }
    }
}
