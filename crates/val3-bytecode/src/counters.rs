//! Counters of executed lines and branch sides: the tables of a program that was compiled with counters.
//!
//! The operations' marks contain the counters ([`LineMark`](crate::LineMark)), so that code without counters is not
//! slower.

use crate::{Image, Program};

/// Counters of a program.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Counters {
    /// Number of the program's first counter among the counters of the image.
    pub first: u32,
    /// Number of counters.
    pub count: u32,
    /// Branches in source order.
    pub branches: Vec<Branch>,
}

/// A statement after which execution continues in one of several ways.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Branch {
    /// Line of the condition in the file, from 1.
    pub row: u32,
    /// Ways to continue.
    pub sides: Vec<BranchSide>,
}

/// One way to continue after a branch. A line that begins the side may share the counter.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BranchSide {
    /// Name, for example `true`, `false`, `case 1, 2`.
    pub name: String,
    /// Number of the counter in the program.
    pub counter: u16,
}

impl Program {
    /// Returns the counted lines: line of the file, from 1, and counter.
    pub fn counted_lines(&self) -> impl Iterator<Item = (u32, u16)> {
        self.lines.iter().filter_map(|line| {
            let step = self.code.get(line.op as usize)?;
            step.mark.counter().filter(|_| step.mark.begins_line()).map(|counter| (line.row, counter))
        })
    }
}

impl Image {
    /// Returns the number of counters in all programs.
    #[must_use]
    pub fn counters(&self) -> u32 {
        self.programs.iter().map(|program| program.counters.count).fold(0, u32::saturating_add)
    }

    /// Numbers the programs' counters consecutively.
    pub fn number_counters(&mut self) {
        let mut first = 0u32;
        for program in &mut self.programs {
            program.counters.first = first;
            first = first.saturating_add(program.counters.count);
        }
    }
}
