//! Comparison with the cycles of an earlier run (`--against`).

use std::fmt::Display;

use camino::{Utf8Path, Utf8PathBuf};
use serde::Deserialize;
use val3_files::FileClass;

use super::report::{CycleTimes, CyclesReport, heading};
use crate::user_error::UserError;

/// Cycles in a file of `--times`.
#[derive(Debug)]
pub(super) struct EarlierCycles {
    path: Utf8PathBuf,
    report: CyclesReport,
}

/// The part of the file that contains the cycles.
#[derive(Deserialize)]
struct TimesFile {
    cycles: Option<CyclesReport>,
}

impl EarlierCycles {
    /// Reads the cycles of a run.
    ///
    /// # Errors
    /// The file cannot be read, or contains no complete cycle.
    pub(super) fn open(path: &Utf8Path) -> Result<Self, UserError> {
        let text = val3_files::read_text(path, FileClass::Record).map_err(|error| unusable(path, &error))?;
        let file: TimesFile = serde_json::from_str(&text).map_err(|error| unusable(path, &error))?;
        let report = file.cycles.ok_or_else(|| unusable(path, &"it contains no cycles"))?;
        if report.times.is_none() {
            return Err(unusable(path, &"it contains no complete cycle"));
        }
        Ok(Self { path: path.to_owned(), report })
    }

    /// Event at which each cycle begins.
    pub(super) fn event(&self) -> &str {
        &self.report.event
    }
}

/// Error for a file without the cycles of a run.
fn unusable(path: &Utf8Path, reason: &dyn Display) -> UserError {
    UserError::new(format!("cannot compare with `{path}`: {reason}"))
        .with_help("name a file that `val3 run --cycles=EVENT --times=FILE.json` has written")
}

/// Table with both runs for users.
pub(super) fn table(report: &CyclesReport, EarlierCycles { path, report: earlier }: &EarlierCycles) -> String {
    let (Some(now), Some(before)) = (&report.times, &earlier.times) else { return report.table() };
    let mut table = format!("{}, against {} in {path}\n", heading(&report.event, report.count), earlier.count);
    if report.event != earlier.event {
        table += &format!("  note: the cycles in {path} are those of {}\n", earlier.event);
    }
    table += &format!("  {:>12} {:>12} {:>12}\n", "this run", "before", "change");
    for ((name, now), (_, before)) in rows(now).into_iter().zip(rows(before)) {
        if now > 0.0 || before > 0.0 {
            table += &format!("  {:>12} {:>12} {:>12}  {name}\n", shown(now), shown(before), change(now, before));
        }
    }
    table
}

fn rows(times: &CycleTimes) -> Vec<(&'static str, f64)> {
    let CycleTimes { first, min, mean, max, parts } = *times;
    let cycles = [("first cycle", first), ("shortest", min), ("mean", mean), ("longest", max)];
    cycles.into_iter().chain(parts.named()).collect()
}

fn shown(seconds: f64) -> String {
    format!("{seconds:.3} s")
}

/// Change in per cent; in seconds if there was nothing before.
fn change(now: f64, before: f64) -> String {
    if before > 0.0 { format!("{:+.1} %", (now / before - 1.0) * 100.0) } else { format!("{:+.3} s", now - before) }
}
