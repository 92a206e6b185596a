//! Smallest distances of a run: by line with moves, and by pair of things.

use std::fmt::Write as _;
use std::sync::Arc;

use serde::Serialize;
use val3_cell::{Minima, Minimum};
use val3_lang::ports::Time;
use val3_machine::controller::Controller;
use val3_machine::event::seconds;

use super::{TimeKey, TimesRow};

/// Largest number of pairs in the table.
const SHOWN_PAIRS: usize = 8;

/// Smallest distances of a run.
pub(super) struct Nearest {
    minima: Minima<(String, u32)>,
}

/// A smallest distance as JSON.
#[derive(Serialize)]
pub(super) struct NearestRow {
    a: String,
    b: String,
    /// Distance in mm; negative if the things overlap.
    distance: f64,
    /// Time of the distance, in seconds.
    at: f64,
}

impl NearestRow {
    fn of(minimum: &Minimum) -> Self {
        let [a, b] = minimum.names.clone();
        Self { a, b, distance: minimum.measured.distance, at: minimum.time }
    }
}

impl Nearest {
    /// Returns the recorder, and creates it in the first cycle; `None` if nothing is around the arm.
    pub(super) fn of<'n>(nearest: &'n mut Option<Self>, controller: &Controller) -> Option<&'n mut Self> {
        let watch = controller.devices.state.watch.as_ref()?;
        Some(nearest.get_or_insert_with(|| Self { minima: Minima::new(Arc::clone(watch.scene())) }))
    }

    /// Observes a cycle in which the arm executes a line.
    pub(super) fn see(&mut self, start: Time, controller: &Controller, arm: &TimeKey) {
        let sight = controller.sight(self.minima.scene(), seconds(start));
        let line = (arm.line > 0).then(|| (arm.program.clone(), arm.line));
        self.minima.see(&sight, line.as_ref());
    }

    /// Smallest distance while the arm executed a line.
    pub(super) fn of_line(&self, program: &str, line: u32) -> Option<NearestRow> {
        self.minima.of(&(program.to_owned(), line)).map(NearestRow::of)
    }

    /// Smallest distances of all pairs.
    pub(super) fn of_pairs(&self) -> Vec<NearestRow> {
        self.minima.of_pairs().into_iter().map(NearestRow::of).collect()
    }
}

/// Tables of the smallest distances: by line, and by pair.
pub(super) fn table(arm: &[TimesRow], pairs: &[NearestRow]) -> String {
    let mut table = String::new();
    let mut lines: Vec<(String, &NearestRow)> = Vec::new();
    for row in arm {
        if let Some(nearest) = &row.nearest
            && lines.iter().all(|(line, _)| *line != row.location())
        {
            lines.push((row.location(), nearest));
        }
    }
    lines.sort_by(|(_, one), (_, other)| one.distance.total_cmp(&other.distance));
    part(&mut table, "nearest by line", lines.into_iter());
    part(&mut table, "nearest by pair", pairs.iter().take(SHOWN_PAIRS).map(|pair| (String::new(), pair)));
    if pairs.len() > SHOWN_PAIRS {
        let _ = writeln!(table, "  and {} more: `--times FILE` writes all", pairs.len() - SHOWN_PAIRS);
    }
    table
}

fn part<'r>(table: &mut String, title: &str, rows: impl Iterator<Item = (String, &'r NearestRow)>) {
    let rows: Vec<(String, &NearestRow)> = rows.collect();
    let width = rows.iter().map(|(line, _)| line.chars().count()).max().unwrap_or(0);
    let gap = if width > 0 { "  " } else { "" };
    for (number, (line, NearestRow { a, b, distance, at })) in rows.iter().enumerate() {
        if number == 0 {
            let _ = writeln!(table, "  {title}");
        }
        let _ = writeln!(table, "  {distance:>10.2} mm at {at:>8.3} s  {line:width$}{gap}{a} - {b}");
    }
}
