//! Trace of a run: the arm's state every 4 ms as a table (`--trace`).

use std::io::{self, BufWriter, Write};

use camino::{Utf8Path, Utf8PathBuf};
use val3_files::OutputFile;
use val3_lang::ports::Time;
use val3_motion::{Sample, SpeedLimit};
use val3_trace::{Precision, RowSelection, TraceRow, head_with_limit};
use val3_vm::CYCLE;

use crate::output::file;
use crate::output::file_kind::OutputFileKind;
use crate::user_error::UserError;

/// Output in comma-separated columns.
pub(super) struct TraceWriter {
    out: BufWriter<OutputFile>,
    path: Utf8PathBuf,
    axes: usize,
    /// Whether rows are also written while the arm is stopped.
    at_rest: bool,
    selection: RowSelection,
}

impl TraceWriter {
    pub(super) fn open(path: &Utf8Path, axes: usize, at_rest: bool) -> Result<Self, UserError> {
        let out = BufWriter::new(file::create(path, OutputFileKind::Text, "trace")?);
        let mut trace = Self { out, path: path.to_owned(), axes, at_rest, selection: RowSelection::default() };
        let written = writeln!(trace.out, "{}", head_with_limit(axes));
        trace.judge(written)?;
        Ok(trace)
    }

    /// Writes rows for cycles that the run has skipped.
    pub(super) fn rest(
        &mut self,
        last: Time,
        start: Time,
        sample: &Sample,
        limit: SpeedLimit,
    ) -> Result<(), UserError> {
        let mut time = last + CYCLE;
        while self.at_rest && time < start {
            self.write(time, sample, limit)?;
            time += CYCLE;
        }
        Ok(())
    }

    /// Writes the row of a cycle. The first row at rest ends a motion.
    pub(super) fn write(&mut self, time: Time, sample: &Sample, limit: SpeedLimit) -> Result<(), UserError> {
        if !self.selection.takes(sample.phase) && !self.at_rest {
            return Ok(());
        }
        let written = writeln!(self.out, "{},{limit}", TraceRow::new(time, sample).line(self.axes, Precision::Exact));
        self.judge(written)
    }

    pub(super) fn close(self) -> Result<(), UserError> {
        let file = self.out.into_inner().map_err(|error| file::refused(&self.path, "trace", error.error()))?;
        file.commit().map_err(|reason| file::refused(&self.path, "trace", &reason))
    }

    fn judge(&self, written: io::Result<()>) -> Result<(), UserError> {
        written.map_err(|error| file::refused(&self.path, "trace", &error))
    }
}
