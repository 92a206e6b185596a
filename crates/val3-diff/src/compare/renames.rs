//! Detection of renamed programs and data in an application.
//!
//! An item is renamed if programs use the new name in all places of the old name, or if one removed item and one added
//! item have the same content and no other item has it.

mod bodies;
mod contents;
mod items;
mod uses;

use crate::read::data::DataVersion;

use items::UnmatchedNames;
pub(super) use items::{ItemVersions, Renamed};

/// Finds renamed items among the data and programs that differ.
pub(super) fn find([old, new]: [&[DataVersion]; 2], programs: &[ItemVersions<'_>]) -> Renamed {
    let mut renamed = Renamed::default();
    let data = UnmatchedNames::of(
        old.iter().map(|data| data.decl.name.as_str()),
        new.iter().map(|data| data.decl.name.as_str()),
    );
    let old_programs = programs.iter().filter_map(|[old, _]| *old);
    let new_programs = programs.iter().filter_map(|[_, new]| *new);
    let program_names = UnmatchedNames::of(
        old_programs.map(|program| program.header.name.as_str()),
        new_programs.map(|program| program.header.name.as_str()),
    );
    if data.is_empty() && program_names.is_empty() {
        return renamed;
    }
    let followed = uses::followed(programs, &[&data, &program_names]);
    contents::find([old, new], &data, &followed, &mut renamed.data);
    bodies::find(programs, &program_names, &followed, &mut renamed);
    renamed
}
