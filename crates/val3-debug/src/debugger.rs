//! The debugger of a controller.

use val3_lang::fault::Fault;
use val3_lang::ports::TaskNumber;
use val3_machine::arm::MotionMode;
use val3_machine::controller::{Controller, MotionFault, RunStatus};
use val3_vm::{CycleWatch, TaskState};

use crate::breakpoints::{Arrival, Breakpoint, BreakpointId, Breakpoints, ConditionFault, LoggedMessage, Placed};
use crate::contacts::Contact;
use crate::data_breakpoints::{DataBreakpoints, DataStop};
use crate::errors::StopErrors;
use crate::frames::TaskFrame;
use crate::history::History;
use crate::pause::Pause;
use crate::program_breakpoints::{PlacedProgram, ProgramBreakpoint};
use crate::skipped_code::SkipPattern;
use crate::step::{Step, StepKind};
use crate::travel::{MotionStop, Travel};

/// A controller that stops at breakpoints, after steps and at run-time errors.
///
/// Time, arm, inputs and outputs change only in [`advance`](Debugger::advance).
#[derive(Debug)]
pub struct Debugger {
    /// Debugged controller.
    pub controller: Controller,
    pub(crate) breakpoints: Breakpoints,
    pub(crate) errors: StopErrors,
    /// Contacts that have not stopped the run yet.
    pub(crate) contacts: Vec<Contact>,
    pub(crate) step: Option<Step>,
    pub(crate) history: Option<History>,
    pub(crate) data: DataBreakpoints,
    /// Requested pause.
    pub(crate) pause: Option<Pause>,
    /// Task that executed the last line; `None` if unknown.
    pub(crate) last: Option<TaskNumber>,
    /// Messages of log points since the last [`take_logged`](Debugger::take_logged).
    logged: Vec<LoggedMessage>,
    /// Motion during which all tasks rest.
    pub(crate) travel: Option<Travel>,
    /// Stop to report after this motion.
    pub(crate) pending: Option<Stop>,
    /// Chosen motion mode.
    pub(crate) mode: MotionMode,
    /// Whether a stop pauses only the stopped task.
    stops_alone: bool,
    /// Whether the run stops before its last task ends.
    stops_at_exit: bool,
    /// Code in which steps into calls do not end.
    skipped: Vec<SkipPattern>,
}

/// Result of [`Debugger::advance`].
#[derive(Debug, Clone, PartialEq)]
pub enum AdvanceResult {
    /// The controller continues. No time passes after a status [within a cycle](RunStatus::is_within_cycle).
    Ran(RunStatus),
    /// The run has stopped.
    Stopped(Stop),
}

/// Reason for a stop of the run.
#[derive(Debug, Clone, PartialEq)]
pub enum Stop {
    /// A task is before a line with breakpoints.
    Breakpoints {
        /// Stopped task.
        task: TaskNumber,
        /// Breakpoints whose hit condition holds or whose condition cannot be evaluated.
        ids: Vec<BreakpointId>,
        /// Conditions that cannot be evaluated.
        faults: Vec<ConditionFault>,
    },
    /// A step has ended.
    Step {
        /// Stopped task.
        task: TaskNumber,
    },
    /// The last running task is before its end.
    Exit {
        /// The task.
        task: TaskNumber,
    },
    /// Watched data were changed or read.
    Data(Box<DataStop>),
    /// The run was paused.
    Pause {
        /// Task to show; `None` if no task exists.
        task: Option<TaskNumber>,
    },
    /// The run has gone back to where the recorded history begins.
    Beginning,
    /// A run-time error has stopped a task.
    Error {
        /// Failed task.
        task: TaskNumber,
        /// Run-time error.
        fault: Fault,
    },
    /// [Statements](Debugger::execute) of the debugger have ended, and the task is where it was before.
    CallEnded {
        /// The task.
        task: TaskNumber,
        /// Run-time error that has ended the statements.
        fault: Option<Fault>,
        /// Line of the error.
        line: Option<Box<TaskFrame>>,
    },
    /// The arm has come to rest before a path that it cannot follow.
    PathFault(Box<MotionFault>),
    /// Contacts have begun in a cycle.
    Contacts(Vec<Contact>),
    /// The arm has arrived at the end of the motion that a line in step mode or [`Debugger::step_motion`] released, or
    /// does not move.
    Motion(Box<MotionStop>),
}

impl Stop {
    /// Returns the stopped task if the reason for the stop affects only this task, so that the other tasks could
    /// continue.
    #[must_use]
    pub fn task_alone(&self) -> Option<TaskNumber> {
        match self {
            Self::Breakpoints { task, .. }
            | Self::Step { task }
            | Self::Error { task, .. }
            | Self::CallEnded { task, .. } => Some(*task),
            Self::Data(stop) => stop.task,
            Self::Motion(stop) => stop.task,
            Self::Pause { .. } | Self::Exit { .. } | Self::PathFault(_) | Self::Contacts(_) | Self::Beginning => None,
        }
    }
}

/// Largest number of lines without a stop that [`Debugger::advance`] inspects in one call.
const INSPECTED_LINES: usize = 1000;

impl Debugger {
    /// Creates a debugger for the controller.
    #[must_use]
    pub fn new(controller: Controller) -> Self {
        Self {
            mode: controller.arm().motion().mode(),
            controller,
            breakpoints: Breakpoints::default(),
            errors: StopErrors::default(),
            contacts: Vec::new(),
            step: None,
            history: None,
            data: DataBreakpoints::default(),
            pause: None,
            last: None,
            logged: Vec::new(),
            travel: None,
            pending: None,
            stops_alone: false,
            stops_at_exit: false,
            skipped: Vec::new(),
        }
    }

    /// Replaces the breakpoints of a file, and returns their resolved lines.
    pub fn set_breakpoints(&mut self, file: &str, breakpoints: Vec<Breakpoint>) -> Vec<Placed> {
        self.breakpoints.set(file, breakpoints);
        self.controller.vm.set_stops(file, self.breakpoints.rows(file));
        self.set_guards();
        self.breakpoints.placed(file, &self.controller.vm.space)
    }

    /// Replaces the breakpoints on programs, and returns their resolved lines.
    pub fn set_program_breakpoints(&mut self, breakpoints: Vec<ProgramBreakpoint>) -> Vec<PlacedProgram> {
        self.breakpoints.set_programs(breakpoints);
        self.controller.vm.set_program_stops(self.breakpoints.programs.names());
        self.set_guards();
        self.placed_programs()
    }

    /// Returns the resolved lines of the breakpoints on programs, which change for example when a library is loaded.
    #[must_use]
    pub fn placed_programs(&self) -> Vec<PlacedProgram> {
        self.breakpoints.programs.placed(&self.controller.vm.space)
    }

    /// Sets the run-time errors that stop the run.
    pub fn set_errors(&mut self, errors: StopErrors) {
        self.errors = errors;
    }

    /// Starts a step of a task. It replaces the current step. The other tasks run meanwhile.
    pub fn step(&mut self, task: TaskNumber, kind: StepKind) {
        let found = self.controller.vm.tasks().iter().find(|known| known.id == task);
        self.step = found.map(|task| Step::new(task, kind));
    }

    /// Removes breakpoints, the current step and pauses, discards the history, and returns to continuous motion.
    pub fn detach(&mut self) {
        self.stops_alone = false;
        self.stop_at_exit(false);
        self.skip(Vec::new());
        self.history = None;
        self.controller.end_recording();
        if self.travel.take().is_some() {
            self.controller.rest_tasks(false);
        }
        self.leave_calls();
        self.resume_tasks();
        self.set_motion_mode(MotionMode::Continuous);
        let files: Vec<String> = self.breakpoints.files().map(str::to_owned).collect();
        for file in files {
            self.set_breakpoints(&file, Vec::new());
        }
        self.set_program_breakpoints(Vec::new());
        self.set_data_breakpoints(Vec::new());
        self.set_errors(StopErrors::default());
        (self.step, self.pause, self.pending) = (None, None, None);
        self.logged.clear();
    }

    /// Sets whether a stop of a task pauses only this task, like [`pause_task`](Self::pause_task), while the other
    /// tasks, the clock and the arm continue.
    pub fn stop_tasks_alone(&mut self, alone: bool) {
        self.stops_alone = alone;
    }

    /// Sets whether the run stops before its last task ends.
    pub fn stop_at_exit(&mut self, is_wanted: bool) {
        self.stops_at_exit = is_wanted;
        self.controller.vm.stop_at_ends(is_wanted);
    }

    /// Sets the code in which steps into calls do not end. Such a step ends at the next line of other code.
    pub fn skip(&mut self, code: Vec<SkipPattern>) {
        self.skipped = code;
    }

    /// Returns the [skipped](Self::skip) patterns that no program in memory matches.
    #[must_use]
    pub fn unused_skips(&self) -> Vec<String> {
        let space = &self.controller.vm.space;
        let unused = self.skipped.iter().filter(|code| !code.has_code(space));
        unused.map(|code| code.text().to_owned()).collect()
    }

    /// Returns the task of the current step while it waits within a line.
    #[must_use]
    pub fn waiting_step(&self) -> Option<TaskNumber> {
        let step = self.step?;
        let mut tasks = self.controller.vm.tasks().iter();
        tasks.find(|task| task.id == step.task && task.thread.wait.is_some()).map(|task| task.id)
    }

    /// Task of the current step.
    #[must_use]
    pub fn stepped_task(&self) -> Option<TaskNumber> {
        self.step.map(|step| step.task)
    }

    /// Cancels the current step.
    pub fn abandon_step(&mut self) {
        self.step = None;
    }

    /// Runs to the end of the cycle or to the next stop.
    pub fn advance(&mut self) -> AdvanceResult {
        let progress = self.advance_part();
        if let AdvanceResult::Stopped(stop) = &progress
            && let Some(task) = stop.task_alone().filter(|_| self.stops_alone)
        {
            self.pause_task(task, true);
        }
        progress
    }

    fn advance_part(&mut self) -> AdvanceResult {
        if let Some(stop) = self.take_pause() {
            self.step = None;
            return AdvanceResult::Stopped(stop);
        }
        if let Some(stop) = self.take_contacts().or_else(|| self.leave_failed_call()) {
            self.step = None;
            return AdvanceResult::Stopped(stop);
        }
        let was_stuck = self.controller.motion_fault().is_some();
        let reported = self.controller.devices.pending_events().len();
        let progress = self.advance_travel().unwrap_or_else(|| {
            let revision = self.controller.arm().motion().revision();
            let progress = self.advance_tasks();
            self.follow_motion(revision, progress)
        });
        self.follow_contacts(reported);
        if matches!(progress, AdvanceResult::Ran(_))
            && let Some(stop) = self.take_contacts()
        {
            self.step = None;
            return AdvanceResult::Stopped(stop);
        }
        match (&progress, self.controller.motion_fault()) {
            (AdvanceResult::Ran(RunStatus::Busy | RunStatus::Waiting(_)), Some(fault))
                if !was_stuck && self.errors.contain_path_faults() =>
            {
                self.step = None;
                AdvanceResult::Stopped(Stop::PathFault(Box::new(fault)))
            }
            _ => progress,
        }
    }

    /// Stores the contacts among the pending events, without the first `reported` events. If the cycle has stopped at a
    /// breakpoint, they stop the run afterwards.
    fn follow_contacts(&mut self, reported: usize) {
        if self.errors.contacts {
            let events = self.controller.devices.pending_events().get(reported..).unwrap_or_default();
            self.contacts.extend(Contact::all(events));
        }
    }

    fn take_contacts(&mut self) -> Option<Stop> {
        (!self.contacts.is_empty()).then(|| Stop::Contacts(std::mem::take(&mut self.contacts)))
    }

    /// Runs to the end of the cycle, to a stop, or past many lines that the debugger inspects without a stop, so that
    /// the caller can handle requests in between.
    fn advance_tasks(&mut self) -> AdvanceResult {
        let mut progress = self.advance_to_line();
        for _ in 1..INSPECTED_LINES {
            let is_inspected = matches!(progress, AdvanceResult::Ran(RunStatus::AtStop(_) | RunStatus::Seen(_)));
            // Motion in step mode begins between two lines, and messages of log points keep their order among the
            // events of the run.
            let is_plain = self.mode == MotionMode::Continuous && self.pause.is_none() && self.step.is_none();
            if !is_inspected || !is_plain || !self.logged.is_empty() {
                break;
            }
            progress = self.advance_to_line();
        }
        progress
    }

    /// Runs to the end of the cycle, or to the next line that the debugger inspects.
    fn advance_to_line(&mut self) -> AdvanceResult {
        let sees_lines = self.mode == MotionMode::Step || self.pause.is_some() || self.step.is_some();
        self.controller.watch(match self.watch_of_data() {
            _ if sees_lines => CycleWatch::Lines,
            CycleWatch::Nothing if !self.errors.is_none() || self.has_calls() => CycleWatch::Failures,
            watch => watch,
        });
        if let Some(stop) = self.begin_watched_cycle() {
            self.step = None;
            return AdvanceResult::Stopped(stop);
        }
        let status = self.step_controller();
        if status == RunStatus::Busy {
            self.pass_cycle();
        }
        // The run continues after the end of the stepped task.
        let tasks = self.controller.vm.tasks();
        self.step = self.step.filter(|step| tasks.iter().any(|task| task.id == step.task));
        if let RunStatus::AtStop(task) | RunStatus::Seen(task) = status {
            self.last = Some(task);
        }
        let stop = match status {
            RunStatus::AtStop(task) => self.at_stop(task),
            RunStatus::Seen(task) => self.seen(task),
            _ => None,
        };
        stop.map_or(AdvanceResult::Ran(status), |stop| {
            // If a stop pauses only one task, the steps of other tasks continue.
            self.step = self.step.filter(|step| self.stops_alone && stop.task_alone() != Some(step.task));
            AdvanceResult::Stopped(stop)
        })
    }

    /// Executes the controller up to its next status. The virtual machine counts the hits at which tasks do not stop. A
    /// replay does not use its counters, because each hit is a possible end of a reverse search.
    fn step_controller(&mut self) -> RunStatus {
        self.controller.vm.count_hits(self.breakpoints.passes());
        let status = self.controller.step();
        self.breakpoints.add_hits(self.controller.vm.take_hits());
        status
    }

    fn at_stop(&mut self, task: TaskNumber) -> Option<Stop> {
        if self.controller.vm.is_after_line(task)
            && let Some(data) = self.follow_data(Some(task), false)
        {
            self.controller.vm.meet_stop_again(task);
            return Some(data);
        }
        if self.controller.vm.is_at_fragment_end(task) {
            return Some(self.leave_call(task, None));
        }
        if self.controller.vm.is_at_end(task) {
            return self.exit(task);
        }
        if self.controller.vm.is_at_return(task) {
            return None;
        }
        let stop = self.hit(task)?;
        // A breakpoint on the last `end` has already stopped the run before its end.
        if self.stops_at_exit && self.exit(task).is_some() {
            self.controller.vm.pass_end(task);
        }
        Some(stop)
    }

    /// Returns the stop before the end of a task if no other task runs. The program `stop`, which runs afterwards, has
    /// no such stop.
    fn exit(&self, task: TaskNumber) -> Option<Stop> {
        if self.controller.is_stopping() {
            return None;
        }
        let tasks = self.controller.vm.tasks();
        let is_last = tasks.iter().all(|known| known.id == task || !known.is_running());
        is_last.then_some(Stop::Exit { task })
    }

    fn seen(&mut self, task: TaskNumber) -> Option<Stop> {
        let data = self.follow_data(Some(task), false);
        if let Some(fault) = self.failure(task) {
            if self.errors.contain(&self.controller.vm, task, fault) {
                return Some(Stop::Error { task, fault });
            }
            if self.is_in_call(task) {
                return Some(self.leave_call(task, Some(fault)));
            }
        }
        if data.is_some() {
            return data;
        }
        let vm = &self.controller.vm;
        let step = self.step.filter(|step| step.task == task && step.is_done(vm, &self.skipped))?;
        let task = match step.kind {
            // The line has created the newest task.
            StepKind::IntoTask => vm.tasks().iter().map(|known| known.id).max().unwrap_or(task),
            StepKind::In | StepKind::Over | StepKind::Out => task,
        };
        // A breakpoint on the line where the step ends counts its hit now, not when the task continues.
        let stop = self.hit(task);
        self.controller.vm.pass_stop(task);
        Some(stop.unwrap_or(Stop::Step { task }))
    }

    /// Returns the breakpoint's hit count so far; after going back, up to the present moment.
    #[must_use]
    pub fn hits(&self, id: BreakpointId) -> u64 {
        self.breakpoints.hits.get(&id).copied().unwrap_or_default()
    }

    /// Returns the log point messages since the last call.
    pub fn take_logged(&mut self) -> Vec<LoggedMessage> {
        std::mem::take(&mut self.logged)
    }

    /// Returns the run-time error that has stopped a task.
    pub(crate) fn failure(&self, task: TaskNumber) -> Option<Fault> {
        let found = self.controller.vm.tasks().iter().find(|known| known.id == task)?;
        match found.state {
            TaskState::Failed(fault) => Some(fault),
            TaskState::Running | TaskState::Halted | TaskState::Killed => None,
        }
    }

    /// Sets the marks of the present breakpoints in the programs, because a restored snapshot may have other marks.
    pub(crate) fn restore_marks(&mut self) {
        for file in self.breakpoints.files() {
            self.controller.vm.set_stops(file, self.breakpoints.rows(file));
        }
        self.controller.vm.set_program_stops(self.breakpoints.programs.names());
        self.controller.vm.stop_at_ends(self.stops_at_exit);
        self.set_guards();
    }

    fn set_guards(&mut self) {
        let guards = self.breakpoints.guards(&self.controller.vm.space);
        self.controller.vm.set_guards(guards);
    }

    /// Returns the stop at the breakpoints on the task's next line, ignoring hit conditions.
    pub(crate) fn stop_before(&mut self, task: TaskNumber) -> Option<Stop> {
        stop(task, self.breakpoints.at(&mut self.controller, task))
    }

    /// Counts the task's arrival at its next line, and returns the stop at the breakpoints whose hit condition holds.
    pub(crate) fn hit(&mut self, task: TaskNumber) -> Option<Stop> {
        let mut arrival = self.breakpoints.hit(&mut self.controller, task);
        self.logged.append(&mut arrival.logged);
        stop(task, arrival)
    }

    /// Counts the hits of a replayed arrival, and discards its messages, which were already logged.
    pub(crate) fn hit_again(&mut self, task: TaskNumber) {
        let known = std::mem::take(&mut self.logged);
        self.hit(task);
        self.logged = known;
    }
}

fn stop(task: TaskNumber, Arrival { ids, faults, .. }: Arrival) -> Option<Stop> {
    (!ids.is_empty()).then_some(Stop::Breakpoints { task, ids, faults })
}
