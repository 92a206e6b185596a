//! The counters of a program: one for each line, and one for each side of a branch that does not begin with a line.

use val3_analysis::body::Stmt;
use val3_bytecode::{Branch, Counters, Side};
use val3_syntax::TextRange;

use crate::error::{Limit, Result};

/// The sides of a condition.
pub(crate) const TRUE: &str = "true";
pub(crate) const FALSE: &str = "false";
/// The sides of a `for`.
pub(crate) const ROUND: &str = "round";
pub(crate) const END: &str = "end";
/// The side of a `switch` without `default` whose cases do not apply.
pub(crate) const NO_CASE: &str = "no case";

/// A branch of the program, by number.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BranchId(usize);

/// Gives numbers to counters.
#[derive(Debug, Default)]
pub(crate) struct Counting {
    /// The code that is not counted; `None` where nothing is.
    uncovered: Option<Vec<TextRange>>,
    counters: Counters,
}

impl Counting {
    /// Counts everything but `uncovered`.
    pub(crate) fn except(uncovered: &[TextRange]) -> Self {
        Self { uncovered: Some(uncovered.to_vec()), counters: Counters::default() }
    }

    /// Whether a line is counted that begins at a byte of the file.
    pub(crate) fn counts(&self, start: u32) -> bool {
        let Some(uncovered) = &self.uncovered else { return false };
        !uncovered.iter().any(|range| range.contains(start.into()))
    }

    /// A new counter. [`finish`](Self::finish) refuses more of them than a program can have.
    pub(crate) fn counter(&mut self) -> u16 {
        let number = u16::try_from(self.counters.count).unwrap_or(u16::MAX);
        self.counters.count += 1;
        number
    }

    /// A branch at the condition with this range, at a row of the file. `None` if it is not counted.
    pub(crate) fn branch(&mut self, condition: TextRange, row: u32) -> Option<BranchId> {
        if !self.counts(condition.start().into()) {
            return None;
        }
        self.counters.branches.push(Branch { row, sides: Vec::new() });
        Some(BranchId(self.counters.branches.len() - 1))
    }

    /// The counter of a side with these statements. `None` if the clause with them is not counted.
    pub(crate) fn side(&mut self, branch: BranchId, name: &str, block: &[Stmt]) -> Option<u16> {
        let first = block.first().map(|first| first.range.start());
        // A comment above the first statement leaves out this one alone.
        let is_left_out = |range: &TextRange| first.is_some_and(|first| range.start() < first && range.contains(first));
        if self.uncovered.iter().flatten().any(is_left_out) {
            return None;
        }
        let counter = self.counter();
        let branch = self.counters.branches.get_mut(branch.0)?;
        branch.sides.push(Side { name: name.to_owned(), counter });
        Some(counter)
    }

    /// The counters.
    pub(crate) fn finish(self) -> Result<Counters> {
        if self.counters.count > u32::from(u16::MAX) + 1 { Err(Limit::Counters) } else { Ok(self.counters) }
    }
}
