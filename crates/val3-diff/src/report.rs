//! The report in words: a list of blocks, which each format lays out.

mod application;
mod block;
mod changes;
mod code;
mod contents;
mod counts;
mod dependents;
mod elements;
mod groups;
mod ignored;
mod others;
mod points;
mod renumbering;
mod settings;
mod statistics;

use crate::model::{Comparison, TreeSide};

pub use block::{Block, ReportItem, ReportMark, ReportRow, TextTable};
pub use counts::DifferenceCounts;
pub use statistics::{DiffStatistics, GreatestMovement, statistics};

use block::{entry, heading};

/// Detail of a report.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Detail {
    /// All differences.
    #[default]
    Full,
    /// A table with numbers for each application.
    Statistics,
}

/// Returns the report of a comparison.
#[must_use]
pub fn blocks(comparison: &Comparison, detail: Detail) -> Vec<Block> {
    let mut blocks = match detail {
        Detail::Full => differences(comparison),
        Detail::Statistics => statistics::table(comparison).into_iter().collect(),
    };
    if !comparison.problems.is_empty() {
        blocks.push(heading(1, "Notes", ""));
    }
    for problem in &comparison.problems {
        let side = if problem.side == TreeSide::Old { "old" } else { "new" };
        let text = format!("in the {side} version {}", problem.message);
        blocks.push(entry(ReportMark::Warning, &problem.path, text));
    }
    blocks
}

fn differences(comparison: &Comparison) -> Vec<Block> {
    let mut blocks = Vec::new();
    for change in &comparison.applications {
        application::add(change, &mut blocks);
    }
    settings::add(&comparison.settings, &mut blocks);
    others::add(&comparison.others, &mut blocks);
    blocks
}

/// Returns the first line of a report: the number of differences and of omitted differences.
#[must_use]
pub fn summary(comparison: &Comparison) -> String {
    let summary = match (comparison.is_empty(), comparison.compared) {
        (false, _) => DifferenceCounts::of(comparison).to_string(),
        (true, 0) => "no differences".to_owned(),
        (true, count) => format!("no differences in {}", counts::counted(count, "application", "applications")),
    };
    let ignored = ignored::ignored(&comparison.ignored);
    ignored.map_or(summary.clone(), |ignored| format!("{summary}; {ignored}"))
}
