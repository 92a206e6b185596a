//! Time of a run by program line (`--times`), in cycles of 4 ms, and the limits of the arm's speed.

mod limits;
mod nearest;

use std::collections::BTreeMap;
use std::fmt::Display;
use std::io::Write as _;

use camino::{Utf8Path, Utf8PathBuf};
use serde::Serialize;
use val3_files::OutputFile;
use val3_lang::ports::{CodePlace, Time};
use val3_machine::controller::{Activity, Controller, TaskPosition};
use val3_machine::event::{Event, seconds};
use val3_motion::{MotionPhase, MoveStage, SpeedLimit};
use val3_vm::CYCLE;

use super::blends::{self, CutBlend, CutBlends};
use super::cycles::CyclesReport;
use crate::output::file;
use crate::output::file_kind::OutputFileKind;
use crate::output::to_stderr;
use crate::run::output_errors::OutputErrors;
use crate::user_error::UserError;
use limits::{LimitShare, LimitTimes, cell};
use nearest::{Nearest, NearestRow};

/// Activity of the arm while no move is recorded.
const NO_MOVE: &str = "no move";

/// Times of a run.
pub(super) struct RunTimes {
    output: TimesOutput,
    /// Origin of the arm's times: `measured` or `model`.
    origin: &'static str,
    arm: BTreeMap<TimeKey, LimitTimes>,
    tasks: BTreeMap<TimeKey, Time>,
    blends: CutBlends,
    last: Time,
    arm_before: Option<(TimeKey, SpeedLimit)>,
    tasks_before: Vec<TimeKey>,
    /// Line of the current move, or of the last move.
    present: Option<CodePlace>,
    /// Smallest distances, if there are things around the arm.
    nearest: Option<Nearest>,
}

/// Destination of the times.
enum TimesOutput {
    /// None. The times are only part of the run's result.
    None,
    /// A table on the console.
    Console,
    /// A JSON file with this path.
    File(Box<OutputFile>, Utf8PathBuf),
}

/// A line and an activity.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
struct TimeKey {
    /// Task name; empty for the arm.
    task: String,
    program: String,
    line: u32,
    what: String,
    /// Whether the arm moves.
    is_moving: bool,
}

impl TimeKey {
    fn no_move() -> Self {
        Self { task: String::new(), program: String::new(), line: 0, what: NO_MOVE.to_owned(), is_moving: false }
    }

    fn of_task(position: TaskPosition) -> Self {
        let what = match &position.activity {
            Activity::Running => "computing".to_owned(),
            activity => activity.awaited().unwrap_or_else(|| activity.word().to_owned()),
        };
        Self { task: position.name, program: position.program, line: position.line, what, is_moving: false }
    }
}

/// The times as JSON.
#[derive(Serialize)]
pub(crate) struct TimesReport {
    /// Duration in seconds.
    pub(crate) duration: f64,
    /// Origin of the arm's times: `measured` or `model`.
    times: &'static str,
    /// Lines of the moves, longest time first.
    pub(crate) arm: Vec<TimesRow>,
    /// Lines of the tasks, longest time first.
    pub(crate) tasks: Vec<TimesRow>,
    /// Limit that applied for most of the time with a move, and a suggestion.
    #[serde(skip_serializing_if = "Option::is_none")]
    advice: Option<String>,
    /// Blends that are shorter than requested, by line.
    blends: Vec<CutBlend>,
    /// Smallest distances of all pairs of things that came within 500 mm, smallest first.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    nearest: Vec<NearestRow>,
    /// Cycles, if `--cycles` names their event.
    #[serde(skip_serializing_if = "Option::is_none")]
    cycles: Option<CyclesReport>,
}

/// Time of an activity at a program line.
#[derive(Serialize)]
pub(crate) struct TimesRow {
    /// Task name; empty for the arm.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub(crate) task: String,
    pub(crate) program: String,
    pub(crate) line: u32,
    /// The activity, such as `computing`, or the awaited condition.
    pub(crate) what: String,
    /// Whether the arm moves.
    #[serde(skip)]
    pub(crate) is_moving: bool,
    pub(crate) seconds: f64,
    /// Smallest distance while the arm executed this line.
    #[serde(skip_serializing_if = "Option::is_none")]
    nearest: Option<NearestRow>,
    /// Limits of the arm's speed, longest time first; empty for a task.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    limits: Vec<LimitShare>,
}

impl TimesRow {
    /// Program and line; empty without a move.
    fn location(&self) -> String {
        match self.line {
            0 => String::new(),
            line => format!("{}:{line}", self.program),
        }
    }
}

impl RunTimes {
    /// Opens the output that `--times` requests: a table, or a file.
    pub(super) fn open(times: Option<&Option<Utf8PathBuf>>, origin: &'static str) -> Result<Self, UserError> {
        let output = match times {
            None => TimesOutput::None,
            Some(None) => TimesOutput::Console,
            Some(Some(path)) => {
                let file = file::create(path, OutputFileKind::Json, "times")?;
                TimesOutput::File(Box::new(file), path.clone())
            }
        };
        Ok(Self {
            output,
            origin,
            arm: BTreeMap::new(),
            tasks: BTreeMap::new(),
            blends: CutBlends::default(),
            last: 0,
            arm_before: None,
            tasks_before: Vec::new(),
            present: None,
            nearest: None,
        })
    }

    /// Adds the time since the last call. Tasks are counted at their last lines; the arm's motion belongs to the last
    /// cycle.
    pub(super) fn see(&mut self, start: Time, controller: &Controller) {
        let passed = start.saturating_sub(self.last);
        self.last = start;
        let (arm, limit) = (self.of_arm(controller), controller.arm().speed_limit());
        if let Some(nearest) = Nearest::of(&mut self.nearest, controller) {
            nearest.see(start, controller, &arm);
        }
        let moving = passed.min(CYCLE);
        let before = self.arm_before.replace((arm.clone(), limit));
        self.arm.entry(arm).or_default().add(limit, moving);
        let (arm, limit) = before.unwrap_or_else(|| (TimeKey::no_move(), SpeedLimit::End));
        self.arm.entry(arm).or_default().add(limit, passed - moving);
        for entry in std::mem::take(&mut self.tasks_before) {
            *self.tasks.entry(entry).or_default() += passed;
        }
        self.tasks_before = controller.task_positions().into_iter().map(TimeKey::of_task).collect();
    }

    /// Adds the time after the last observed cycle, in which nothing happens.
    fn rest(&mut self, end: Time) {
        let passed = end.saturating_sub(self.last);
        self.last = self.last.max(end);
        let (arm, limit) = self.arm_before.take().unwrap_or_else(|| (TimeKey::no_move(), SpeedLimit::End));
        self.arm.entry(arm).or_default().add(limit, passed);
        for entry in std::mem::take(&mut self.tasks_before) {
            *self.tasks.entry(entry).or_default() += passed;
        }
    }

    /// Adds the blends in the events.
    pub(super) fn follow(&mut self, events: &[Event]) {
        self.blends.follow(events);
    }

    /// Current move of the arm, and its activity.
    fn of_arm(&mut self, controller: &Controller) -> TimeKey {
        let arm = controller.arm();
        let present = arm.moves().filter(|(queued, _)| queued.stage >= MoveStage::Started).last();
        if let Some((_, Some(origin))) = present {
            self.present = origin.at;
        }
        let (place, what) = match arm.sample().phase {
            MotionPhase::Waiting if present.is_none() => (None, NO_MOVE),
            MotionPhase::Waiting if let Some(fault) = controller.motion_fault() => {
                (fault.source.map(|source| source.at), "resting before a path that the arm cannot follow")
            }
            MotionPhase::Waiting => (self.present, "waiting for the next move"),
            // A move that has ended in this cycle is not in the queue any more.
            phase => (self.present, phase.word()),
        };
        let (program, line, _) = place.map(|at| controller.devices.place(at)).unwrap_or_default();
        let is_moving = arm.sample().phase != MotionPhase::Waiting;
        TimeKey { task: String::new(), program, line, what: what.to_owned(), is_moving }
    }

    /// Writes the times up to the end of the run, and returns them.
    pub(super) fn close(mut self, end: Time, cycles: Option<CyclesReport>, errors: &mut OutputErrors) -> TimesReport {
        self.rest(end);
        let output = std::mem::replace(&mut self.output, TimesOutput::None);
        let report = TimesReport { cycles, ..self.into_report() };
        match output {
            TimesOutput::None => {}
            TimesOutput::Console => to_stderr(|out| out.write_all(report.table().as_bytes())),
            TimesOutput::File(file, path) => {
                errors.collect(write(*file, &path, &report));
            }
        }
        report
    }

    fn into_report(self) -> TimesReport {
        let mut all = LimitTimes::default();
        self.arm.values().for_each(|limits| all.extend(limits));
        let arm = self.arm.into_iter().map(|(entry, limits)| (entry, limits.total(), limits.shares()));
        let tasks = self.tasks.into_iter().map(|(entry, time)| (entry, time, Vec::new()));
        let (mut arm, tasks) = (rows(arm), rows(tasks));
        if let Some(nearest) = &self.nearest {
            arm.iter_mut().for_each(|row| row.nearest = nearest.of_line(&row.program, row.line));
        }
        TimesReport {
            duration: seconds(self.last),
            times: self.origin,
            arm,
            tasks,
            advice: all.advice(),
            blends: self.blends.into_lines(),
            nearest: self.nearest.map(|nearest| nearest.of_pairs()).unwrap_or_default(),
            cycles: None,
        }
    }
}

fn write(mut file: OutputFile, path: &Utf8Path, report: &TimesReport) -> Result<(), UserError> {
    let refused = |reason: &dyn Display| file::refused(path, "times", reason);
    let text = serde_json::to_string_pretty(report).map_err(|error| refused(&error))?;
    file.write_all(text.as_bytes()).map_err(|error| refused(&error))?;
    file.commit().map_err(|reason| refused(&reason))
}

/// Rows of a table, longest times first.
fn rows(table: impl Iterator<Item = (TimeKey, Time, Vec<LimitShare>)>) -> Vec<TimesRow> {
    let mut rows: Vec<_> = table.filter(|(_, time, _)| *time > 0).collect();
    rows.sort_by(|(left, left_time, _), (right, right_time, _)| {
        right_time.cmp(left_time).then_with(|| left.cmp(right))
    });
    rows.into_iter().map(|(key, time, limits)| row(key, time, limits)).collect()
}

fn row(TimeKey { task, program, line, what, is_moving }: TimeKey, time: Time, limits: Vec<LimitShare>) -> TimesRow {
    TimesRow { task, program, line, what, is_moving, seconds: seconds(time), nearest: None, limits }
}

impl TimesReport {
    fn table(&self) -> String {
        let mut table = format!("times of {:.3} s\n", self.duration);
        self.part(&mut table, "arm", &self.arm);
        self.part(&mut table, "tasks", &self.tasks);
        table.extend(self.advice.iter().map(|advice| format!("  {advice}\n")));
        table += &blends::table(&self.blends);
        table += &nearest::table(&self.arm, &self.nearest);
        table
    }

    fn part(&self, table: &mut String, name: &str, rows: &[TimesRow]) {
        let width = |text: fn(&TimesRow) -> &str| rows.iter().map(|row| text(row).chars().count()).max().unwrap_or(0);
        let (tasks, whats) = (width(|row| &row.task), width(|row| &row.what));
        let places = rows.iter().map(|row| row.location().chars().count()).max().unwrap_or(0);
        *table += &format!("  {name}\n");
        for row in rows {
            let share = if self.duration > 0.0 { row.seconds / self.duration * 100.0 } else { 0.0 };
            let gap = if tasks > 0 { "  " } else { "" };
            let (seconds, what, task, place) = (row.seconds, &row.what, &row.task, row.location());
            let limits = cell(&row.limits);
            let line = format!(
                "  {seconds:>10.3} s {share:>5.1} %  {task:tasks$}{gap}{place:places$}  {what:whats$}  {limits}"
            );
            *table += &format!("{}\n", line.trim_end());
        }
    }
}
