//! Motion reports of a run: a trace, a picture and a table of times.

mod blends;
mod cycles;
mod picture;
mod times;
mod trace;

use val3_lang::ports::Time;
use val3_machine::controller::Controller;
use val3_machine::event::{Event, seconds};
use val3_motion::{MotionPhase, Sample, SpeedLimit};
use val3_vm::CYCLE;

use crate::args::RunArgs;
use crate::output::to_stderr;
use crate::run::output_errors::OutputErrors;
use crate::user_error::UserError;
use cycles::Cycles;
use picture::PictureFile;
use times::RunTimes;
pub(super) use times::{TimesReport, TimesRow};
use trace::TraceWriter;

/// Requested motion observers.
pub(super) struct MotionObservers {
    trace: Option<TraceWriter>,
    picture: Option<PictureFile>,
    times: Option<RunTimes>,
    cycles: Option<Cycles>,
    /// Note for readers of the trace and the times, printed if the arm has moved.
    note: Option<String>,
    has_moved: bool,
    /// Last observation of the arm, and its time.
    last: Option<(Time, Sample, SpeedLimit)>,
}

impl MotionObservers {
    /// Opens the files, so that a run does not begin if a file cannot be written.
    pub(super) fn open(args: &RunArgs, controller: &Controller) -> Result<Self, UserError> {
        let arm = controller.arm().model();
        let axes = arm.axes();
        let trace = args.trace.as_deref().or(args.trace_all.as_deref());
        let wants_times = args.times.is_some() || args.summary.is_some() || args.result.is_some();
        let picture = args.plot.as_deref().map(|path| PictureFile::open(path, args.plot_accelerations, controller));
        let cycles = Cycles::open(args, controller)?;
        Ok(Self {
            trace: trace.map(|path| TraceWriter::open(path, axes, args.trace_all.is_some())).transpose()?,
            picture: picture.transpose()?,
            times: wants_times.then(|| RunTimes::open(args.times.as_ref(), arm.times_origin())).transpose()?,
            note: arm.times_note().filter(|_| trace.is_some() || args.times.is_some() || cycles.is_some()),
            cycles,
            has_moved: false,
            last: None,
        })
    }

    /// Observes the end of the cycle that began at `start`.
    pub(super) fn see(&mut self, start: Time, controller: &Controller) -> Result<(), UserError> {
        let has_reports = self.picture.is_some() || self.times.is_some() || self.cycles.is_some();
        let is_idle = self.trace.is_none() && !has_reports;
        if is_idle || self.last.is_some_and(|(last, ..)| start < last + CYCLE) {
            return Ok(());
        }
        let arm = controller.arm();
        let (sample, limit) = (*arm.sample(), arm.speed_limit());
        self.has_moved |= sample.phase != MotionPhase::Waiting;
        if let Some(trace) = &mut self.trace {
            if let Some((last, before, limit)) = self.last {
                trace.rest(last, start, &before, limit)?;
            }
            trace.write(start, &sample, limit)?;
        }
        if let Some(picture) = &mut self.picture {
            picture.see(seconds(start), controller);
        }
        if let Some(times) = &mut self.times {
            times.see(start, controller);
        }
        if let Some(cycles) = &mut self.cycles {
            cycles.see(start, controller);
        }
        self.last = Some((start, sample, limit));
        Ok(())
    }

    /// Observes the recorded events of the cycle that began at `start`.
    pub(super) fn follow(&mut self, start: Time, events: &[Event], controller: &Controller) {
        if let Some(times) = &mut self.times {
            times.follow(events);
        }
        if let Some(cycles) = &mut self.cycles {
            cycles.follow(start, events, controller);
        }
    }

    /// Writes the reports at the end of a run, at this time. Returns the times, if they are observed.
    pub(super) fn close(self, end: Time, errors: &mut OutputErrors) -> Option<TimesReport> {
        if let Some(note) = self.note.filter(|_| self.has_moved) {
            to_stderr(|out| writeln!(out, "note: {note}"));
        }
        errors.collect(self.trace.map_or(Ok(()), TraceWriter::close));
        errors.collect(self.picture.map_or(Ok(()), PictureFile::close));
        let (cycles, table) = self.cycles.map(Cycles::close).unwrap_or_default();
        let times = self.times.map(|times| times.close(end, cycles, errors));
        to_stderr(|out| out.write_all(table.as_bytes()));
        times
    }
}
