//! Parsing of traces, with the location of errors.

use std::error::Error;
use std::fmt;

use val3_geometry::Trsf;
use val3_lang::ports::{Time, nanoseconds};
use val3_machine::event::seconds;
use val3_motion::{MotionPhase, SpeedLimit};

use crate::row::{Trace, TraceRow};
use crate::write::{ARM, head, head_with_limit};

/// Maximum number of axes.
const MOST_AXES: usize = 6;

/// Reason why a file is no trace.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TraceError {
    /// Line number, from 1.
    pub line: usize,
    /// A sentence that describes the fault.
    pub message: String,
}

impl fmt::Display for TraceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {}", self.line, self.message)
    }
}

impl Error for TraceError {}

impl Trace {
    /// Parses a file: comment lines, the column names, and rows sorted by time.
    ///
    /// # Errors
    /// If the columns are no trace's, a row has an invalid value for its column, or the time decreases.
    pub fn parse(text: &str) -> Result<Self, TraceError> {
        let mut trace = Self::default();
        let mut columns: Option<String> = None;
        for (line, text) in (1..).zip(text.lines()) {
            let at = |message: String| TraceError { line, message };
            if let Some(arm) = text.strip_prefix(ARM) {
                trace.arm = Some(arm.trim().to_owned());
            } else if text.starts_with('#') || text.trim().is_empty() {
            } else if let Some(columns) = &columns {
                let before = trace.rows.last().map(|row| row.time);
                trace.rows.push(row(text, columns, trace.axes, before).map_err(at)?);
            } else {
                trace.axes = axes(text).map_err(at)?;
                columns = Some(text.trim_end().to_owned());
            }
        }
        match columns {
            Some(_) => Ok(trace),
            None => Err(TraceError { line: 1, message: no_trace("there are none") }),
        }
    }
}

/// Returns the number of axes for the columns of a table.
fn axes(line: &str) -> Result<usize, String> {
    let columns = line.trim_end();
    let known = (1..=MOST_AXES).find(|axes| columns == head(*axes) || columns == head_with_limit(*axes));
    known.ok_or_else(|| no_trace(&format!("`{line}` are others")))
}

fn no_trace(found: &str) -> String {
    format!("a trace begins with the names of its columns, as in `{}`: {found}", head(MOST_AXES))
}

fn row(line: &str, columns: &str, axes: usize, before: Option<Time>) -> Result<TraceRow, String> {
    let names: Vec<&str> = columns.split(',').collect();
    let texts: Vec<&str> = line.split(',').map(str::trim).collect();
    if texts.len() != names.len() {
        return Err(format!("this row has {} values instead of {}", texts.len(), names.len()));
    }
    let mut columns = UnparsedColumns { cells: names.into_iter().zip(texts) };
    let time = nanoseconds(columns.number()?);
    if let Some(before) = before.filter(|before| time <= *before) {
        return Err(format!("column t: this row is not later than the one before ({:.3} s)", seconds(before)));
    }
    let (id, phase) = (columns.number()?, columns.phase()?);
    let mut joints = [0.0; MOST_AXES];
    for joint in joints.iter_mut().take(axes) {
        *joint = columns.number()?;
    }
    let translation = columns.three_numbers()?;
    let pose = Trsf::new(translation, columns.three_numbers()?).isometry();
    let speed = columns.number()?;
    columns.limit()?;
    Ok(TraceRow { time, id, phase, joints, pose, speed })
}

/// Columns of a row that are not parsed yet.
struct UnparsedColumns<I> {
    cells: I,
}

impl<'a, I: Iterator<Item = (&'a str, &'a str)>> UnparsedColumns<I> {
    fn next(&mut self) -> (&'a str, &'a str) {
        self.cells.next().unwrap_or_default()
    }

    fn number(&mut self) -> Result<f64, String> {
        let (name, text) = self.next();
        let number = text.parse().ok().filter(|number: &f64| number.is_finite());
        number.ok_or_else(|| format!("column {name}: `{text}` is not a number"))
    }

    fn three_numbers(&mut self) -> Result<[f64; 3], String> {
        Ok([self.number()?, self.number()?, self.number()?])
    }

    /// Checks the speed limit, which is no part of a row. The column is optional.
    fn limit(&mut self) -> Result<(), String> {
        let Some((name, text)) = self.cells.next() else { return Ok(()) };
        SpeedLimit::named(text).map(drop).ok_or_else(|| format!("column {name}: `{text}` is no limit of the speed"))
    }

    fn phase(&mut self) -> Result<MotionPhase, String> {
        let (name, text) = self.next();
        let words = MotionPhase::ALL.map(MotionPhase::word);
        let phase = MotionPhase::ALL.into_iter().find(|phase| phase.word() == text);
        phase.ok_or_else(|| format!("column {name}: `{text}` is none of {}", words.join(", ")))
    }
}

#[cfg(test)]
mod tests;
