//! Renamed programs and data of one application.
//!
//! A name is renamed if programs use the new name wherever they used the old one, or if one removed item and one added item have
//! the same content and no other item has it.

mod bodies;
mod contents;
mod uses;

use std::collections::BTreeSet;

use crate::read::code::Renames;
use crate::read::data::Data;
use crate::read::program::Program;

/// Both versions of a program.
pub(super) type Versions<'p> = [Option<&'p Program>; 2];

/// Renamed items, by their old names.
#[derive(Debug, Default)]
pub(super) struct Renamed {
    pub(super) data: Renames,
    pub(super) programs: Renames,
}

impl Renamed {
    /// New names of programs and data.
    pub(super) fn names(&self) -> Renames {
        self.data.iter().chain(&self.programs).map(|(old, new)| (old.clone(), new.clone())).collect()
    }
}

/// Finds the renamed items among the data and the programs that differ.
pub(super) fn find([old, new]: [&[Data]; 2], programs: &[Versions<'_>]) -> Renamed {
    let mut renamed = Renamed::default();
    let data =
        Names::of(old.iter().map(|data| data.decl.name.as_str()), new.iter().map(|data| data.decl.name.as_str()));
    let names = |side: usize| {
        let versions = programs.iter().filter_map(move |versions| *versions.get(side)?);
        versions.map(|program| program.header.name.as_str())
    };
    let program_names = Names::of(names(0), names(1));
    if data.is_empty() && program_names.is_empty() {
        return renamed;
    }
    let followed = uses::followed(programs, &[&data, &program_names]);
    contents::find([old, new], &data, &followed, &mut renamed.data);
    bodies::find(programs, &program_names, &followed, &mut renamed);
    renamed
}

/// Names that only one version has.
#[derive(Debug)]
struct Names<'n> {
    removed: BTreeSet<&'n str>,
    added: BTreeSet<&'n str>,
}

impl<'n> Names<'n> {
    fn of(old: impl Iterator<Item = &'n str>, new: impl Iterator<Item = &'n str>) -> Self {
        let (old, new): (BTreeSet<&str>, BTreeSet<&str>) = (old.collect(), new.collect());
        Self { removed: &old - &new, added: &new - &old }
    }

    /// Whether there is no pair of an old and a new name.
    fn is_empty(&self) -> bool {
        self.removed.is_empty() || self.added.is_empty()
    }
}
