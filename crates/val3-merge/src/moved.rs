//! Array elements with new indexes, for the report.

use std::fmt;

use crate::plan::{Append, Plan, Plans};

/// Elements that theirs has appended to an array to which ours has appended elements, too.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Moved {
    /// Data path of the variable or field, for example `pPick` or `tSlot[1].pPick`.
    pub path: String,
    /// Dimension in which the array was extended, from 0.
    pub axis: usize,
    /// First index in theirs.
    pub from: usize,
    /// First index in the merged file.
    pub to: usize,
    /// Number of elements.
    pub count: usize,
}

impl fmt::Display for Moved {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { path, from, to, count, .. } = self;
        let [from, to] = [from, to].map(|first| match count {
            1 => first.to_string(),
            count => format!("{first} to {}", first + count - 1),
        });
        let dimension = match self.axis {
            0 => String::new(),
            axis => format!(" of dimension {}", axis + 1),
        };
        let word = if *count == 1 { "index" } else { "indexes" };
        write!(f, "`{path}`: {word} {from}{dimension} of theirs became {to}")
    }
}

/// Returns the elements that move, sorted by path.
pub(crate) fn of(plans: &Plans) -> Vec<Moved> {
    let appends = plans.values().filter_map(Plan::append).filter(|append| append.by > 0 && append.count > 0);
    let mut moved: Vec<Moved> = appends.map(entry).collect();
    moved.sort_by(|one, other| one.path.cmp(&other.path));
    moved
}

fn entry(append: &Append) -> Moved {
    let Append { path, axis, from, by, count, .. } = append;
    Moved { path: path.clone(), axis: *axis, from: *from, to: from + by, count: *count }
}
