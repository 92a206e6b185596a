//! All names in a file with their symbols: the basis of navigation, renaming and highlighting.

mod code;
mod data_path;
mod occurrence;
mod tasks;
mod texts;
mod xml_names;

use rustc_hash::FxHashMap;
use val3_syntax::{TextRange, TextSize};

pub(crate) use self::data_path::path_names;
pub use self::occurrence::{Occurrence, Symbol, Usage};
pub use self::tasks::task_names;
pub use self::texts::elements as page_elements;
use crate::body::body;
use crate::db::{Db, File, Project};
use crate::items::project::{data_files, program_files};
use crate::{pages, surroundings};

/// Returns every resolved name in `file` as a part of `project`, in source order.
#[salsa::tracked(lru = 256)]
pub fn occurrences(db: &dyn Db, project: Project, file: File) -> Vec<Occurrence> {
    if project.pages(db).contains(&file) {
        return pages::occurrences(db, project, file);
    }
    if project.surroundings(db) == Some(file) {
        return surroundings::occurrences(db, project, file);
    }
    let mut found = xml_names::names(db, project, file);
    if program_files(db, project).contains(&file) {
        found.extend(code::names(db, project, file));
        found.extend(texts::names(db, project, file, body(db, file)));
    }
    found.sort_by_key(|occurrence| occurrence.range.start());
    found.dedup();
    found
}

/// Ranges in a file by symbol. This small table remains memoised when the occurrences are evicted, and a workspace
/// search reads only this table.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
struct RangesBySymbol {
    /// Symbols, each with the end index in `ranges`.
    symbols: Box<[(Symbol, usize)]>,
    ranges: Box<[TextRange]>,
}

#[salsa::tracked]
fn places(db: &dyn Db, project: Project, file: File) -> RangesBySymbol {
    let mut by_symbol: FxHashMap<&Symbol, Vec<TextRange>> = FxHashMap::default();
    for Occurrence { symbol, range, .. } in occurrences(db, project, file) {
        by_symbol.entry(symbol).or_default().push(*range);
    }
    let mut by_symbol: Vec<(&Symbol, Vec<TextRange>)> = by_symbol.into_iter().collect();
    by_symbol.sort_unstable_by_key(|(_, ranges)| ranges.first().map(|first| first.start()));
    let mut end = 0;
    let symbols = by_symbol.iter().map(|(symbol, ranges)| {
        end += ranges.len();
        ((*symbol).clone(), end)
    });
    RangesBySymbol {
        symbols: symbols.collect(),
        ranges: by_symbol.iter().flat_map(|(_, ranges)| ranges).copied().collect(),
    }
}

/// Returns the ranges of `symbol` in `file` as a part of `project`, in source order.
pub fn places_of<'db>(db: &'db dyn Db, project: Project, file: File, symbol: &Symbol) -> &'db [TextRange] {
    let RangesBySymbol { symbols, ranges } = places(db, project, file);
    let Some(at) = symbols.iter().position(|(known, _)| known == symbol) else { return &[] };
    let start = at.checked_sub(1).and_then(|before| symbols.get(before)).map_or(0, |(_, end)| *end);
    symbols.get(at).and_then(|(_, end)| ranges.get(start..*end)).unwrap_or(&[])
}

/// Computes the occurrences of a project ahead of the first search.
pub fn index(db: &dyn Db, project: Project) {
    project_files(db, project).for_each(|file| _ = places(db, project, file));
}

/// Returns the name that contains the offset or ends at it.
pub fn occurrence_at(db: &dyn Db, project: Project, file: File, offset: TextSize) -> Option<&Occurrence> {
    let occurrences = occurrences(db, project, file);
    let covering = occurrences.iter().filter(|occurrence| occurrence.range.contains_inclusive(offset));
    covering.max_by_key(|occurrence| occurrence.range.start())
}

/// Returns the files of a project: the `.pjx`, data, programs, files of user pages, and `cell.toml`.
pub fn project_files(db: &dyn Db, project: Project) -> impl Iterator<Item = File> {
    let data = data_files(db, project).iter().copied();
    std::iter::once(project.manifest(db))
        .chain(data)
        .chain(program_files(db, project).iter().copied())
        .chain(project.pages(db).iter().copied())
        .chain(project.surroundings(db))
}
