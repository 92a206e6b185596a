//! The trace of a run: the arm every 4 ms as a table (`--trace`).

use std::fs::File;
use std::io::{self, BufWriter, Write};

use camino::{Utf8Path, Utf8PathBuf};
use val3_geometry::Trsf;
use val3_lang::ports::Time;
use val3_machine::event::seconds;
use val3_motion::{Phase, Sample};
use val3_vm::CYCLE;

use crate::run::file;
use crate::user_error::UserError;

/// A table with commas between its columns.
pub(super) struct Trace {
    out: BufWriter<File>,
    path: Utf8PathBuf,
    axes: usize,
    /// Rows are also written while the arm is at rest.
    at_rest: bool,
    /// The arm was moving in the row before.
    was_moving: bool,
}

impl Trace {
    pub(super) fn open(path: &Utf8Path, axes: usize, at_rest: bool) -> Result<Self, UserError> {
        let out = BufWriter::new(file::create(path, "trace")?);
        let mut trace = Self { out, path: path.to_owned(), axes, at_rest, was_moving: false };
        let joints: Vec<String> = (1..=axes).map(|axis| format!("j{axis}")).collect();
        let written = writeln!(trace.out, "t,id,phase,{},x,y,z,rx,ry,rz,v", joints.join(","));
        trace.judge(written)?;
        Ok(trace)
    }

    /// The rows of the cycles that the run has skipped between two others.
    pub(super) fn rest(&mut self, last: Time, start: Time, sample: &Sample) -> Result<(), UserError> {
        let mut time = last + CYCLE;
        while self.at_rest && time < start {
            self.write(seconds(time), sample)?;
            time += CYCLE;
        }
        Ok(())
    }

    /// The row of a cycle. The first row at rest ends a motion.
    pub(super) fn write(&mut self, t: f64, sample: &Sample) -> Result<(), UserError> {
        let is_moving = sample.phase != Phase::Waiting;
        if !(is_moving || self.was_moving || self.at_rest) {
            return Ok(());
        }
        self.was_moving = is_moving;
        let written = self.row(t, sample);
        self.judge(written)
    }

    fn row(&mut self, t: f64, sample: &Sample) -> io::Result<()> {
        write!(self.out, "{t:.3},{:.6},{}", sample.id, sample.phase.word())?;
        let Trsf { x, y, z, rx, ry, rz } = sample.pose.into();
        let joints = sample.joints.iter().take(self.axes).copied();
        for value in joints.chain([x, y, z, rx, ry, rz]) {
            write!(self.out, ",{value:.7}")?;
        }
        writeln!(self.out, ",{:.4}", sample.speed.0)
    }

    pub(super) fn close(mut self) -> Result<(), UserError> {
        let written = self.out.flush();
        self.judge(written)
    }

    fn judge(&self, written: io::Result<()>) -> Result<(), UserError> {
        written.map_err(|error| file::refused(&self.path, "trace", &error))
    }
}
