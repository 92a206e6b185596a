//! Coverage of a program.

use std::collections::BTreeMap;

use crate::share::Share;

/// Execution counts of the lines and branches of a program.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct ProgramCoverage {
    /// Name of the application or library.
    pub project: String,
    /// Path of the project file.
    pub project_file: String,
    /// Program name.
    pub program: String,
    /// Execution counts of executable lines, by line number in the file, from 1.
    pub lines: BTreeMap<u32, u64>,
    /// Branches in source order.
    pub branches: Vec<Branch>,
    /// Displayed code: line number in the file, from 1, and text. Empty if no format displays it.
    pub source: Vec<(u32, String)>,
}

/// A statement with several possible successors.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Branch {
    /// Line of the condition, from 1.
    pub line: u32,
    /// Sides of the branch.
    pub sides: Vec<Side>,
}

/// A side of a branch: one of the possible successors.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Side {
    /// Name, for example `true`, `false` or `case 1, 2`.
    pub name: String,
    /// Number of times the side was taken.
    pub hits: u64,
}

/// Coverage of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LineState {
    /// The line is not executable, or is not counted.
    Uncounted,
    /// The line was never executed.
    Missed,
    /// The line was executed, but a branch side was never taken.
    Partial,
    /// The line was executed, and every branch side was taken.
    Hit,
}

impl Branch {
    /// Returns the sides that were not taken.
    pub fn missing(&self) -> impl Iterator<Item = &Side> {
        self.sides.iter().filter(|side| side.hits == 0)
    }

    /// Whether it is the same branch, ignoring the counts.
    fn is_same(&self, other: &Self) -> bool {
        self.line == other.line
            && self.sides.iter().map(|side| &side.name).eq(other.sides.iter().map(|side| &side.name))
    }
}

impl ProgramCoverage {
    /// Adds the counts of the same program on another controller.
    pub fn add(&mut self, other: Self) {
        for (line, hits) in other.lines {
            *self.lines.entry(line).or_default() += hits;
        }
        for branch in other.branches {
            match self.branches.iter_mut().find(|known| known.is_same(&branch)) {
                Some(known) => {
                    known.sides.iter_mut().zip(&branch.sides).for_each(|(side, other)| side.hits += other.hits)
                }
                None => self.branches.push(branch),
            }
        }
        self.branches.sort_by_key(|branch| branch.line);
    }

    /// Returns the share of executed lines.
    #[must_use]
    pub fn line_share(&self) -> Share {
        Share::of(self.lines.values().copied())
    }

    /// Returns the share of taken branch sides.
    #[must_use]
    pub fn branch_share(&self) -> Share {
        Share::of(self.branches.iter().flat_map(|branch| &branch.sides).map(|side| side.hits))
    }

    /// Returns the branches at a line.
    pub fn branches_at(&self, line: u32) -> impl Iterator<Item = &Branch> {
        self.branches.iter().filter(move |branch| branch.line == line)
    }

    /// Returns the coverage of a line.
    #[must_use]
    pub fn state(&self, line: u32) -> LineState {
        match self.lines.get(&line) {
            None => LineState::Uncounted,
            Some(0) => LineState::Missed,
            Some(_) if self.branches_at(line).any(|branch| branch.missing().next().is_some()) => LineState::Partial,
            Some(_) => LineState::Hit,
        }
    }

    /// Returns the ranges of lines that were not executed. Lines without code do not split a range.
    #[must_use]
    pub fn missing_lines(&self) -> Vec<(u32, u32)> {
        let mut ranges: Vec<(u32, u32)> = Vec::new();
        let mut continues = false;
        for (line, hits) in &self.lines {
            match ranges.last_mut() {
                _ if *hits > 0 => continues = false,
                Some((_, last)) if continues => *last = *line,
                _ => {
                    ranges.push((*line, *line));
                    continues = true;
                }
            }
        }
        ranges
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn branch(line: u32, hits: [u64; 2]) -> Branch {
        let side = |(name, hits): (&str, u64)| Side { name: name.to_owned(), hits };
        Branch { line, sides: ["true", "false"].into_iter().zip(hits).map(side).collect() }
    }

    fn program(lines: &[(u32, u64)], branches: &[(u32, [u64; 2])]) -> ProgramCoverage {
        ProgramCoverage {
            lines: lines.iter().copied().collect(),
            branches: branches.iter().map(|(line, hits)| branch(*line, *hits)).collect(),
            ..ProgramCoverage::default()
        }
    }

    #[test]
    fn counts_are_added_in_any_order() {
        let parts = [
            program(&[(1, 1), (2, 0)], &[(1, [1, 0])]),
            program(&[(1, 2), (2, 2), (3, 1)], &[(1, [0, 2])]),
            program(&[(7, 0)], &[(7, [0, 0]), (9, [1, 1])]),
        ];
        let expected = program(&[(1, 3), (2, 2), (3, 1), (7, 0)], &[(1, [1, 2]), (7, [0, 0]), (9, [1, 1])]);
        for order in [[0, 1, 2], [2, 1, 0], [1, 0, 2]] {
            let mut sum = ProgramCoverage::default();
            order.into_iter().for_each(|part| sum.add(parts[part].clone()));
            assert_eq!(sum, expected);
        }
        assert_eq!(expected.line_share(), Share { hit: 3, total: 4 });
        assert_eq!(expected.branch_share(), Share { hit: 4, total: 6 });
    }

    #[test]
    fn missing_lines_are_ranges_without_the_lines_between_statements() {
        let missing = |lines: &[(u32, u64)]| program(lines, &[]).missing_lines();
        assert_eq!(missing(&[(1, 0), (2, 1), (4, 0), (6, 0), (7, 0), (9, 3), (12, 0)]), [(1, 1), (4, 7), (12, 12)]);
        assert_eq!(missing(&[(1, 1)]), []);
    }

    #[test]
    fn a_line_is_partly_executed_if_a_side_is_missing() {
        let program = program(&[(1, 1), (2, 5), (3, 0), (4, 1)], &[(1, [1, 0]), (2, [3, 2]), (3, [0, 0])]);
        let states = [1, 2, 3, 4, 5].map(|line| program.state(line));
        use LineState::{Hit, Missed, Partial, Uncounted};
        assert_eq!(states, [Partial, Hit, Missed, Hit, Uncounted]);
    }
}
