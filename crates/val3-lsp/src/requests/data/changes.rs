//! Tables that the client has, and the difference from the current text.

use std::hash::{Hash as _, Hasher as _};
use std::ops::Range;

use rustc_hash::FxHasher;
use val3_ide::{DataOutline, DataType};

use super::messages::{DataFinding, Datum, ReplacedValues, Replacement};
use crate::lines::PositionConverter;

/// Extract of the last `val3/data` result for a document, sufficient for comparison with the next result.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct KeptTables {
    pub(super) types: Vec<DataType>,
    data: Vec<KeptDatum>,
    /// Row hashes, by datum.
    rows: Vec<KeptRows>,
    /// Hashes of the findings.
    findings: Vec<u64>,
}

/// A variable that the client has.
#[derive(Debug, Clone, Copy)]
struct KeptDatum {
    fingerprint: u64,
    line: u32,
    /// Start and end column of the name.
    columns: (u32, u32),
    /// Number of lines since the previous variable.
    distance: u32,
}

/// Rows of a variable that the client has.
#[derive(Debug, Clone, PartialEq)]
struct KeptRows {
    /// Hash of the datum without its values and location.
    head: u64,
    /// Hashes of the values.
    values: Box<[u64]>,
}

impl KeptRows {
    fn of(datum: &Datum) -> Self {
        let head = hash(&(&datum.name, &datum.access, &datum.type_name, &datum.container, &datum.size));
        Self { head, values: datum.values.iter().map(hash).collect() }
    }
}

/// The absolute line is not compared, because an edit before the variable shifts it.
impl PartialEq for KeptDatum {
    fn eq(&self, other: &Self) -> bool {
        let key = |datum: &Self| (datum.fingerprint, datum.columns, datum.distance);
        key(self) == key(other)
    }
}

impl KeptTables {
    pub(super) fn new(lines: &PositionConverter<'_>, tables: &DataOutline) -> Self {
        let mut before = 0;
        let data = tables.data.iter().map(|source| {
            let range = lines.range(source.name);
            let line = range.start.line;
            let distance = line.saturating_sub(before);
            before = line;
            let columns = (range.start.character, range.end.character);
            KeptDatum { fingerprint: source.fingerprint, line, columns, distance }
        });
        Self { types: tables.types.clone(), data: data.collect(), rows: Vec::new(), findings: Vec::new() }
    }

    /// Sets the rows of all data.
    pub(super) fn set_rows(&mut self, data: &[Datum]) {
        self.rows = data.iter().map(KeptRows::of).collect();
    }

    /// Stores the rows that differ from `before`. If only the values of a datum have changed, removes all unchanged
    /// values from `data` and returns the replaced range.
    pub(super) fn change_rows(
        &mut self,
        before: &Self,
        difference: &Difference,
        data: &mut [Datum],
    ) -> Option<ReplacedValues> {
        let new = data.iter().map(KeptRows::of);
        self.rows.clone_from(&before.rows);
        let old: Vec<KeptRows> = self.rows.splice(difference.old.clone(), new).collect();
        let ([datum], [old]) = (data, old.as_slice()) else { return None };
        let new = self.rows.get(difference.new.start).filter(|new| new.head == old.head)?;
        let values = Difference::between(&old.values, &new.values);
        datum.values.truncate(values.new.end);
        datum.values.drain(..values.new.start);
        Some(ReplacedValues { start: values.old.start, delete_count: values.old.len() })
    }

    /// Sets the findings that the client has with the tables.
    pub(super) fn set_findings(&mut self, findings: &[DataFinding]) {
        self.findings = findings.iter().map(hash).collect();
    }

    /// Copies the findings from an earlier result, which the client keeps.
    pub(super) fn keep_findings(&mut self, before: &Self) {
        self.findings.clone_from(&before.findings);
    }

    /// Identifier of this state; equal states have equal identifiers.
    pub(super) fn id(&self) -> String {
        let mut hasher = FxHasher::default();
        self.findings.hash(&mut hasher);
        for datum in &self.data {
            (datum.fingerprint, datum.line, datum.columns).hash(&mut hasher);
        }
        format!("{:x}", hasher.finish())
    }

    /// Data that differ from `before`, and the line shift of the data after them.
    pub(super) fn changed_data(&self, before: &Self) -> (Difference, i64) {
        let difference = Difference::between(&before.data, &self.data);
        let line = |data: &[KeptDatum], at: usize| data.get(at).map(|datum| i64::from(datum.line));
        let (old, new) = (line(&before.data, difference.old.end), line(&self.data, difference.new.end));
        let shift = new.zip(old).map_or(0, |(new, old)| new - old);
        (difference, shift)
    }

    /// Findings that differ from `before`.
    pub(super) fn changed_findings(&self, before: &Self) -> Difference {
        Difference::between(&before.findings, &self.findings)
    }
}

/// Ranges in which two lists differ, after their common prefix and suffix are removed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Difference {
    pub(super) old: Range<usize>,
    pub(super) new: Range<usize>,
}

impl Difference {
    fn between<T: PartialEq>(old: &[T], new: &[T]) -> Self {
        let start = old.iter().zip(new).take_while(|(old, new)| old == new).count();
        let rest = |list: &[T]| list.len() - start;
        let common = old.iter().rev().zip(new.iter().rev()).take_while(|(old, new)| old == new).count();
        let common = common.min(rest(old)).min(rest(new));
        Self { old: start..old.len() - common, new: start..new.len() - common }
    }

    /// Replacement of the old range by `items`.
    pub(super) fn replace_with<T>(&self, items: Vec<T>) -> Replacement<T> {
        Replacement { start: self.old.start, delete_count: self.old.len(), items }
    }
}

fn hash(value: &impl std::hash::Hash) -> u64 {
    let mut hasher = FxHasher::default();
    value.hash(&mut hasher);
    hasher.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_difference_is_between_common_ends() {
        for (old, new, expected) in [
            ("abc", "abc", (3..3, 3..3)),
            ("abc", "axc", (1..2, 1..2)),
            ("abc", "abbc", (2..2, 2..3)),
            ("aaa", "aa", (2..3, 2..2)),
            ("", "ab", (0..0, 0..2)),
            ("ab", "", (0..2, 0..0)),
        ] {
            let found = Difference::between(old.as_bytes(), new.as_bytes());
            assert_eq!((found.old, found.new), expected, "{old} {new}");
        }
    }
}
