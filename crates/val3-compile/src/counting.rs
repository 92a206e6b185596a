//! Counters of a program: one for each line, and one for each branch side that does not begin with a line.

use val3_analysis::body::Stmt;
use val3_bytecode::{Branch, BranchSide, Counters};
use val3_syntax::TextRange;

use crate::error::{CompileLimit, Result};

/// Sides of a condition.
pub(crate) const TRUE: &str = "true";
pub(crate) const FALSE: &str = "false";
/// Sides of a `for`.
pub(crate) const ROUND: &str = "round";
pub(crate) const END: &str = "end";
/// Side of a `switch` without `default` if no case applies.
pub(crate) const NO_CASE: &str = "no case";

/// Number of a branch in the program.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BranchId(usize);

/// Assigns numbers to counters.
#[derive(Debug, Default)]
pub(crate) struct Counting {
    /// Source ranges that are not counted; `None` if nothing is counted.
    uncovered: Option<Vec<TextRange>>,
    counters: Counters,
}

impl Counting {
    /// Counts all code except `uncovered`.
    pub(crate) fn except(uncovered: &[TextRange]) -> Self {
        Self { uncovered: Some(uncovered.to_vec()), counters: Counters::default() }
    }

    /// Whether a line that begins at this byte is counted.
    pub(crate) fn counts(&self, start: u32) -> bool {
        let Some(uncovered) = &self.uncovered else { return false };
        !uncovered.iter().any(|range| range.contains(start.into()))
    }

    /// Assigns a new counter. [`finish`](Self::finish) returns an error if there are more counters than a program can
    /// have.
    pub(crate) fn counter(&mut self) -> u16 {
        let number = u16::try_from(self.counters.count).unwrap_or(u16::MAX);
        self.counters.count += 1;
        number
    }

    /// Declares a branch at the condition with this range, in a row of the file. `None` if the branch is not counted.
    pub(crate) fn branch(&mut self, condition: TextRange, row: u32) -> Option<BranchId> {
        if !self.counts(condition.start().into()) {
            return None;
        }
        self.counters.branches.push(Branch { row, sides: Vec::new() });
        Some(BranchId(self.counters.branches.len() - 1))
    }

    /// Assigns the counter for a side with these statements. `None` if the clause is not counted.
    pub(crate) fn side(&mut self, branch: BranchId, name: &str, block: &[Stmt]) -> Option<u16> {
        if let Some(first) = block.first().map(|first| first.range.start()) {
            // A comment above the first statement excludes only this statement.
            let mut excluded = self.uncovered.iter().flatten();
            if excluded.any(|range| range.start() < first && range.contains(first)) {
                return None;
            }
        }
        let counter = self.counter();
        let branch = self.counters.branches.get_mut(branch.0)?;
        branch.sides.push(BranchSide { name: name.to_owned(), counter });
        Some(counter)
    }

    /// Returns the counters.
    pub(crate) fn finish(self) -> Result<Counters> {
        if self.counters.count > u32::from(u16::MAX) + 1 { Err(CompileLimit::Counters) } else { Ok(self.counters) }
    }
}
