//! The other uses of a name in its file, reads and writes apart.

use val3_analysis::db::Db;
use val3_analysis::occurrences::{Usage, occurrences};
use val3_syntax::TextRange;

use crate::FilePosition;
use crate::navigate::name_at;

/// A use of the name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Highlight {
    /// The name.
    pub range: TextRange,
    /// It gets a value here, or is declared.
    pub is_write: bool,
}

/// Every use of the name at a position in the same file.
pub fn highlights(db: &dyn Db, at: FilePosition) -> Vec<Highlight> {
    let Some((project, found)) = name_at(db, at) else { return Vec::new() };
    let same = occurrences(db, project, at.file).iter().filter(|occurrence| occurrence.symbol == found.symbol);
    same.map(|occurrence| Highlight { range: occurrence.range, is_write: occurrence.usage != Usage::Read }).collect()
}
