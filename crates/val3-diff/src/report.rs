//! The report in words: one list of blocks, which each format for people lays out in its way.

mod application;
mod block;
mod changes;
mod code;
mod counts;
mod dependents;
mod elements;
mod groups;
mod others;
mod points;
mod renumbering;
mod settings;

use crate::model::{Comparison, Side};

pub use block::{Block, Entry, Mark, Row, Table};
pub use counts::Counts;

use block::{entry, heading};

/// The report of a comparison.
#[must_use]
pub fn blocks(comparison: &Comparison) -> Vec<Block> {
    let mut blocks = Vec::new();
    for change in &comparison.applications {
        application::add(change, &mut blocks);
    }
    settings::add(&comparison.settings, &mut blocks);
    others::add(&comparison.others, &mut blocks);
    if !comparison.problems.is_empty() {
        blocks.push(heading(1, "Notes", ""));
    }
    for problem in &comparison.problems {
        let side = if problem.side == Side::Old { "old" } else { "new" };
        let text = format!("in the {side} version {}", problem.message);
        blocks.push(entry(Mark::Warning, &problem.path, text));
    }
    blocks
}

/// The first line of a report: how much differs.
#[must_use]
pub fn summary(comparison: &Comparison) -> String {
    if comparison.is_empty() {
        return match comparison.compared {
            0 => "no differences".to_owned(),
            count => format!("no differences in {}", counts::counted(count, "application", "applications")),
        };
    }
    Counts::of(comparison).to_string()
}
