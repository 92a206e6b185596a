//! Counters of executed lines and of the sides of branches: the tables of a program that was compiled with them.
//!
//! The marks of operations name the counters ([`LineMark`](crate::LineMark)), so that code without them is not slower.

use crate::{Image, Program};

/// The counters of a program.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Counters {
    /// The number of its first counter among those of the image.
    pub first: u32,
    /// The number of counters.
    pub count: u32,
    /// The branches in the order of the text.
    pub branches: Vec<Branch>,
}

/// A statement that continues in one of several ways.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Branch {
    /// The line of the file with its condition, from 1.
    pub row: u32,
    /// The ways.
    pub sides: Vec<Side>,
}

/// A way in which a statement can continue. A line that begins it may share its counter.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Side {
    /// `true`, `false`, `case 1, 2` and so on.
    pub name: String,
    /// Its counter, by its number among those of the program.
    pub counter: u16,
}

impl Program {
    /// The counted lines: the line of the file, from 1, and the counter.
    pub fn counted_lines(&self) -> impl Iterator<Item = (u32, u16)> {
        self.lines.iter().filter_map(|line| {
            let step = self.code.get(line.op as usize)?;
            step.mark.counter().filter(|_| step.mark.begins_line()).map(|counter| (line.row, counter))
        })
    }
}

impl Image {
    /// The number of counters of its programs.
    #[must_use]
    pub fn counters(&self) -> u32 {
        self.programs.iter().map(|program| program.counters.count).fold(0, u32::saturating_add)
    }

    /// Numbers the counters of its programs one after the other.
    pub fn number_counters(&mut self) {
        let mut first = 0u32;
        for program in &mut self.programs {
            program.counters.first = first;
            first = first.saturating_add(program.counters.count);
        }
    }
}
