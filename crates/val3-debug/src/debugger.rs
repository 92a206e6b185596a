//! The controller under control.

use val3_lang::fault::Fault;
use val3_lang::ports::TaskNumber;
use val3_machine::arm::MotionMode;
use val3_machine::controller::{Controller, MotionFault, Outcome};
use val3_vm::{TaskState, Watch};

use crate::breakpoints::{Arrival, Breakpoint, BreakpointId, Breakpoints, ConditionFault, LoggedMessage, Placed};
use crate::data_breakpoints::{DataBreakpoints, DataStop};
use crate::errors::Errors;
use crate::history::History;
use crate::pause::Pause;
use crate::program_breakpoints::{PlacedProgram, ProgramBreakpoint};
use crate::step::{Step, StepKind};
use crate::travel::{MotionStop, Travel};

/// A controller that stops at breakpoints, after steps and at run-time errors.
///
/// Time, arm, inputs and outputs change only while it advances.
#[derive(Debug)]
pub struct Debugger {
    /// The controller.
    pub controller: Controller,
    pub(crate) breakpoints: Breakpoints,
    pub(crate) errors: Errors,
    pub(crate) step: Option<Step>,
    pub(crate) history: Option<History>,
    pub(crate) data: DataBreakpoints,
    /// The pause that was asked for.
    pub(crate) pause: Option<Pause>,
    /// The task that has executed a line last, as far as known.
    pub(crate) last: Option<TaskNumber>,
    /// The messages of log points that were not taken.
    logged: Vec<LoggedMessage>,
    /// The motion for which all tasks rest.
    pub(crate) travel: Option<Travel>,
    /// The stop that follows it.
    pub(crate) pending: Option<Stop>,
    /// The mode of the motion that was chosen.
    pub(crate) mode: MotionMode,
    /// A stop of a task pauses that task alone.
    stops_alone: bool,
}

/// The result of a call of [`Debugger::advance`].
#[derive(Debug, Clone, PartialEq)]
pub enum Progress {
    /// The controller runs on. After an outcome [within a cycle](Outcome::is_within_cycle) no time passes.
    Ran(Outcome),
    /// The run has stopped.
    Stopped(Stop),
}

/// Why the run has stopped.
#[derive(Debug, Clone, PartialEq)]
pub enum Stop {
    /// A task is before a line with breakpoints.
    Breakpoints {
        /// The task.
        task: TaskNumber,
        /// The breakpoints whose number of hits is reached, and those whose condition cannot be evaluated.
        ids: Vec<BreakpointId>,
        /// The conditions that cannot be evaluated.
        faults: Vec<ConditionFault>,
    },
    /// A step is done.
    Step {
        /// Its task.
        task: TaskNumber,
    },
    /// Watched data have changed.
    Data(Box<DataStop>),
    /// The run is paused.
    Pause {
        /// The task to show; none if no task is left.
        task: Option<TaskNumber>,
    },
    /// The run has gone back to where its past begins.
    Beginning,
    /// A run-time error has stopped a task.
    Error {
        /// The task.
        task: TaskNumber,
        /// The error.
        fault: Fault,
    },
    /// The arm has come to rest before a path that it cannot follow.
    PathFault(Box<MotionFault>),
    /// The arm has arrived where a line in step mode or [`Debugger::step_motion`] has released it to, or does not move.
    Motion(Box<MotionStop>),
}

impl Stop {
    /// The task that stops, where the others could run on.
    #[must_use]
    pub fn task_alone(&self) -> Option<TaskNumber> {
        match self {
            Self::Breakpoints { task, .. } | Self::Step { task } | Self::Error { task, .. } => Some(*task),
            Self::Data(stop) => stop.task,
            Self::Motion(stop) => stop.task,
            Self::Pause { .. } | Self::PathFault(_) | Self::Beginning => None,
        }
    }
}

impl Debugger {
    /// Takes control of a controller.
    #[must_use]
    pub fn new(controller: Controller) -> Self {
        Self {
            mode: controller.motion_mode(),
            controller,
            breakpoints: Breakpoints::default(),
            errors: Errors::default(),
            step: None,
            history: None,
            data: DataBreakpoints::default(),
            pause: None,
            last: None,
            logged: Vec::new(),
            travel: None,
            pending: None,
            stops_alone: false,
        }
    }

    /// Replaces the breakpoints of a file, and says where they are.
    pub fn set_breakpoints(&mut self, file: &str, breakpoints: Vec<Breakpoint>) -> Vec<Placed> {
        self.breakpoints.set(file, breakpoints);
        self.controller.vm.set_stops(file, self.breakpoints.rows(file));
        self.breakpoints.placed(file, &self.controller.vm.space)
    }

    /// Replaces the breakpoints at the beginning of programs, and says where they are.
    pub fn set_program_breakpoints(&mut self, breakpoints: Vec<ProgramBreakpoint>) -> Vec<PlacedProgram> {
        self.breakpoints.set_programs(breakpoints);
        self.controller.vm.set_program_stops(self.breakpoints.programs.names());
        self.placed_programs()
    }

    /// Where the breakpoints at the beginning of programs are now, for example after a library was loaded.
    #[must_use]
    pub fn placed_programs(&self) -> Vec<PlacedProgram> {
        self.breakpoints.programs.placed(&self.controller.vm.space)
    }

    /// Chooses the run-time errors that stop the run.
    pub fn set_errors(&mut self, errors: Errors) {
        self.errors = errors;
    }

    /// Lets a task step, in place of a step that is under way. The other tasks run meanwhile.
    pub fn step(&mut self, task: TaskNumber, kind: StepKind) {
        let found = self.controller.vm.tasks().iter().find(|known| known.id == task);
        self.step = found.map(|task| Step::new(task, kind));
    }

    /// Lets the controller run as without a debugger: gives up breakpoints, steps, pauses and the past. The motion is
    /// continuous.
    pub fn let_go(&mut self) {
        self.stops_alone = false;
        self.history = None;
        self.controller.end_recording();
        if self.travel.take().is_some() {
            self.controller.rest_tasks(false);
        }
        self.resume_tasks();
        self.set_motion_mode(MotionMode::Continuous);
        let files: Vec<String> = self.breakpoints.files().map(str::to_owned).collect();
        for file in files {
            self.set_breakpoints(&file, Vec::new());
        }
        self.set_program_breakpoints(Vec::new());
        self.set_data_breakpoints(Vec::new());
        self.set_errors(Errors::default());
        (self.step, self.pause, self.pending) = (None, None, None);
        self.logged.clear();
    }

    /// Chooses whether a stop of a task pauses that task alone, as [`pause_task`](Self::pause_task) does, while the
    /// others, the clock and the arm continue.
    pub fn stop_tasks_alone(&mut self, alone: bool) {
        self.stops_alone = alone;
    }

    /// Gives up a step that is under way.
    pub fn abandon_step(&mut self) {
        self.step = None;
    }

    /// Runs to the end of the cycle, or to where it stops.
    pub fn advance(&mut self) -> Progress {
        let progress = self.advance_part();
        if let Progress::Stopped(stop) = &progress
            && let Some(task) = stop.task_alone().filter(|_| self.stops_alone)
        {
            self.pause_task(task, true);
        }
        progress
    }

    fn advance_part(&mut self) -> Progress {
        if let Some(stop) = self.take_pause() {
            self.step = None;
            return Progress::Stopped(stop);
        }
        let was_stuck = self.controller.motion_fault().is_some();
        let progress = self.advance_travel().unwrap_or_else(|| {
            let revision = self.controller.motion_revision();
            let progress = self.advance_tasks();
            self.follow_motion(revision, progress)
        });
        match (&progress, self.controller.motion_fault()) {
            (Progress::Ran(Outcome::Busy | Outcome::Waiting(_)), Some(fault))
                if !was_stuck && self.errors.contain_path_faults() =>
            {
                self.step = None;
                Progress::Stopped(Stop::PathFault(Box::new(fault)))
            }
            _ => progress,
        }
    }

    fn advance_tasks(&mut self) -> Progress {
        let sees_lines =
            self.mode == MotionMode::Step || self.pause.is_some() || self.step.is_some() || !self.data.is_empty();
        self.controller.watch(match self.errors.is_none() {
            _ if sees_lines => Watch::Lines,
            true => Watch::Nothing,
            false => Watch::Failures,
        });
        if let Some(stop) = self.begin_watched_cycle() {
            self.step = None;
            return Progress::Stopped(stop);
        }
        let outcome = self.controller.step();
        if outcome == Outcome::Busy {
            self.pass_cycle();
        }
        if let Outcome::AtStop(task) | Outcome::Seen(task) = outcome {
            self.last = Some(task);
        }
        let stop = match outcome {
            Outcome::AtStop(task) => self.at_stop(task),
            Outcome::Seen(task) => self.seen(task),
            _ => None,
        };
        stop.map_or(Progress::Ran(outcome), |stop| {
            // A task that stops alone leaves the steps of others.
            self.step = self.step.filter(|step| self.stops_alone && stop.task_alone() != Some(step.task));
            Progress::Stopped(stop)
        })
    }

    fn at_stop(&mut self, task: TaskNumber) -> Option<Stop> {
        self.hit(task)
    }

    fn seen(&mut self, task: TaskNumber) -> Option<Stop> {
        let data = self.follow_data(Some(task), false);
        if let Some(fault) = self.failure(task).filter(|fault| self.errors.contain(&self.controller.vm, task, *fault)) {
            return Some(Stop::Error { task, fault });
        }
        if data.is_some() {
            return data;
        }
        let vm = &self.controller.vm;
        if !vm.tasks().iter().any(|known| known.id == task) {
            // The run goes on after a step over the end of a task.
            self.step = self.step.filter(|step| step.task != task);
        }
        let step = self.step.filter(|step| step.task == task && step.is_done(vm))?;
        let task = match step.kind {
            // The line has created the last one.
            StepKind::IntoTask => vm.tasks().iter().map(|known| known.id).max().unwrap_or(task),
            StepKind::In | StepKind::Over | StepKind::Out => task,
        };
        // A breakpoint at the line where the step ends has its hit now, not once more when the task continues.
        let stop = self.hit(task);
        self.controller.vm.pass_stop(task);
        Some(stop.unwrap_or(Stop::Step { task }))
    }

    /// The messages of log points since the last call.
    pub fn take_logged(&mut self) -> Vec<LoggedMessage> {
        std::mem::take(&mut self.logged)
    }

    fn failure(&self, task: TaskNumber) -> Option<Fault> {
        let found = self.controller.vm.tasks().iter().find(|known| known.id == task)?;
        match found.state {
            TaskState::Failed(fault) => Some(fault),
            TaskState::Running | TaskState::Halted | TaskState::Killed => None,
        }
    }

    /// Gives the programs the marks of the present breakpoints, which a snapshot may lack.
    pub(crate) fn restore_marks(&mut self) {
        for file in self.breakpoints.files() {
            self.controller.vm.set_stops(file, self.breakpoints.rows(file));
        }
        self.controller.vm.set_program_stops(self.breakpoints.programs.names());
    }

    /// The stop at the breakpoints of the line that a task begins next, whatever their numbers of hits.
    pub(crate) fn stop_before(&mut self, task: TaskNumber) -> Option<Stop> {
        stop(task, self.breakpoints.at(&mut self.controller, task))
    }

    /// A task has arrived at the line that it begins next: the stop at breakpoints whose hit it is.
    pub(crate) fn hit(&mut self, task: TaskNumber) -> Option<Stop> {
        let mut arrival = self.breakpoints.hit(&mut self.controller, task);
        self.logged.append(&mut arrival.logged);
        stop(task, arrival)
    }

    /// Counts the hits of a task that arrives at its next line again. Its messages are known.
    pub(crate) fn hit_again(&mut self, task: TaskNumber) {
        let known = std::mem::take(&mut self.logged);
        self.hit(task);
        self.logged = known;
    }
}

fn stop(task: TaskNumber, Arrival { ids, faults, .. }: Arrival) -> Option<Stop> {
    (!ids.is_empty()).then_some(Stop::Breakpoints { task, ids, faults })
}
