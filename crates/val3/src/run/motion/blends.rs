//! Blends that are shorter than requested by their motion descriptors, by program line (`--times`).

use std::collections::BTreeMap;

use serde::Serialize;
use val3_machine::blend_ends::BlendEnds;
use val3_machine::event::{Event, EventKind};

/// A run's shortened blends, by the moves' program and line.
#[derive(Debug, Default)]
pub(super) struct CutBlends(BTreeMap<(String, u32), CutBlend>);

/// A line's shortened blends.
#[derive(Debug, Serialize)]
pub(super) struct CutBlend {
    program: String,
    line: u32,
    /// Number of moves with a shortened blend.
    moves: u32,
    /// Shortest blend of the line.
    #[serde(flatten)]
    shortest: BlendEnds,
}

impl CutBlends {
    /// Adds the blends in the events.
    pub(super) fn follow(&mut self, events: &[Event]) {
        for event in events {
            let EventKind::Move { phase: "blend" | "done", program, line, blend, .. } = &event.kind else { continue };
            // A move of a client has no program.
            if program.is_empty() || blend.cut().next().is_none() {
                continue;
            }
            let found = self.0.entry((program.clone(), *line)).or_insert_with(|| CutBlend {
                program: program.clone(),
                line: *line,
                moves: 0,
                shortest: blend.clone(),
            });
            found.moves += 1;
            if effective(blend) < effective(&found.shortest) {
                found.shortest = blend.clone();
            }
        }
    }

    pub(super) fn into_lines(self) -> Vec<CutBlend> {
        self.0.into_values().collect()
    }
}

/// Sum of a blend's effective distances, in mm.
fn effective(blend: &BlendEnds) -> f64 {
    [&blend.leave, &blend.reach].into_iter().flatten().map(|end| end.effective).sum()
}

/// Section of the times table; empty if no blend is shortened.
pub(super) fn table(lines: &[CutBlend]) -> String {
    if lines.is_empty() {
        return String::new();
    }
    let width = lines.iter().map(|line| line.location().chars().count()).max().unwrap_or(0);
    format!("  blends cut short\n{}", lines.iter().map(|line| line.row(width)).collect::<String>())
}

impl CutBlend {
    /// Row of the table, with the location padded to `width`.
    fn row(&self, width: usize) -> String {
        let (moves, location) = (self.moves, self.location());
        let unit = if moves == 1 { "move " } else { "moves" };
        format!("  {moves:>10} {unit}  {location:width$}  {}\n", self.shortest.note().unwrap_or_default())
    }

    fn location(&self) -> String {
        format!("{}:{}", self.program, self.line)
    }
}
