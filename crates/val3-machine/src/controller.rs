//! The controller: an application with its tasks, cycle by cycle (5.2, 5.4 to 5.7).

mod applications;
mod clicks;
mod client_moves;
mod evaluate;
mod frames;
mod handling;
mod motion;
mod operator;
mod positions;
mod snapshot;
mod surroundings;

use std::sync::Arc;

use serde_json::{Map, json};
use val3_bytecode::Image;
use val3_lang::fault::Fault;
use val3_lang::ports::{CodePlace, Origin, Ports, TaskNumber, Time};
use val3_vm::{
    CYCLE, CycleEnd, CycleWatch, Host as _, InstanceId, LineReplacement, ProgramId, Schedule, TaskState, Vm,
};

use crate::devices::Devices;
use crate::event::EventKind;
use crate::script::Script;

pub use crate::run_status::RunStatus;

pub use applications::{ApplicationState, PreparedProject};
pub use handling::PartState;
pub use motion::{BlendPoint, CodeSource, MotionFault, MotionPiece, MotionStatus, RecordedMove};
pub use operator::OperatorAction;
pub use positions::{Activity, TaskPosition, WaitCause};
pub use snapshot::Snapshot;

use operator::Operations;

/// The priority of the tasks that execute `start` and `stop` (5.2).
const PRIORITY: u32 = 10;

/// An application on the controller.
#[derive(Debug)]
pub struct Controller {
    /// Programs and data.
    pub vm: Vm,
    /// Everything else.
    pub devices: Devices,
    schedule: Schedule,
    application: InstanceId,
    phase: RunPhase,
    /// Task that executes `start` and later `stop`.
    lead: Option<TaskNumber>,
    stopped: bool,
    /// Whether the application continues when its tasks have ended.
    outlives_tasks: bool,
    /// Script of the external events.
    pub(crate) script: Script,
    operations: Operations,
    /// Projects that the operator can load, by number.
    prepared: Vec<PreparedProject>,
}

/// Phase of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum RunPhase {
    /// The tasks run.
    Running,
    /// `stop` runs; after a stop from outside together with other tasks.
    Stopping,
    /// No task exists.
    Stopped,
}

/// Reason why a program cannot be started.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NotStarted {
    /// The application has no program with this name.
    NoProgram,
    /// The program has more or fewer parameters than values.
    HasParameters,
    /// The run-time error with which its task would begin.
    Fault(Fault),
}

impl Controller {
    /// Loads an application into memory with its libraries; no task runs yet. `path` is its folder on the media
    /// (`Disk://app`).
    ///
    /// # Errors
    /// 40 if the application needs more memory than a controller has.
    pub fn new(mut devices: Devices, image: Arc<Image>, path: String, line_cost: Time) -> Result<Self, Fault> {
        let mut vm = Vm::default();
        let application = vm.space.load(image, path.clone(), &mut devices)?;
        devices.keep_files(application, &path);
        vm.space.load_with(application, &mut devices);
        // The clock starts when everything is in memory.
        devices.take_elapsed();
        Ok(Self {
            vm,
            devices,
            schedule: Schedule::new(line_cost),
            application,
            phase: RunPhase::Running,
            lead: None,
            stopped: false,
            outlives_tasks: false,
            script: Script::default(),
            operations: Operations::default(),
            prepared: Vec::new(),
        })
    }

    /// Name of the application.
    #[must_use]
    pub fn name(&self) -> &str {
        self.vm.space.instance(self.application).map_or("", |instance| &instance.image.name)
    }

    /// Whether a cycle has begun and is not over.
    #[must_use]
    pub fn is_within_cycle(&self) -> bool {
        self.schedule.is_within_cycle()
    }

    /// The controller's clock, in nanoseconds.
    #[must_use]
    pub fn now(&self) -> Time {
        self.schedule.now
    }

    /// Starts a program without parameters in the task `application~` (5.2).
    ///
    /// # Errors
    /// The program cannot be started.
    pub fn start(&mut self, program: &str) -> Result<TaskNumber, NotStarted> {
        self.start_with(program, &[])
    }

    /// Like [`start`](Self::start), for a program with parameters of type `num` by value, which receive `numbers`.
    ///
    /// # Errors
    /// The program cannot be started.
    pub fn start_with(&mut self, program: &str, numbers: &[f64]) -> Result<TaskNumber, NotStarted> {
        self.start_leading_task(program, numbers, |application| format!("{application}~"))
    }

    /// Starts a program in the task of `start` or `stop`, whose name derives from the application's name.
    fn start_leading_task(
        &mut self,
        program: &str,
        numbers: &[f64],
        task: impl Fn(&str) -> String,
    ) -> Result<TaskNumber, NotStarted> {
        let image = self.vm.space.instance(self.application).map(|instance| Arc::clone(&instance.image));
        let image = image.ok_or(NotStarted::NoProgram)?;
        let number = image.program(program).ok_or(NotStarted::NoProgram)?;
        if image.programs.get(usize::from(number)).is_some_and(|program| program.params.len() != numbers.len()) {
            return Err(NotStarted::HasParameters);
        }
        self.devices.origin(self.outside());
        let program = ProgramId { instance: self.application, number };
        let started = self.vm.start_with(&task(&image.name), program, numbers, PRIORITY, &mut self.devices);
        self.lead = started.ok();
        started.map_err(NotStarted::Fault)
    }

    /// Stops the application as the operator does: `stop` runs, then all tasks are killed in the reverse order of
    /// their creation (5.2).
    pub fn stop(&mut self) {
        if self.phase == RunPhase::Running {
            self.stopped = true;
            if let Some(start) = self.lead {
                self.kill(start);
            }
            self.begin_stop();
        }
    }

    /// Kills a task from outside, without effect if the task does not exist.
    pub fn kill(&mut self, id: TaskNumber) {
        self.devices.origin(self.outside());
        self.vm.kill(id, &mut self.devices);
    }

    /// Continues a task from outside at the line that begins with operation `op` in the innermost program, or at the
    /// end of the program. Returns whether the task and the line exist.
    pub fn continue_at(&mut self, id: TaskNumber, op: u32) -> bool {
        self.devices.origin(self.outside());
        self.vm.continue_at(id, op, &mut self.devices)
    }

    /// The origin of events that belong to no task.
    fn outside(&self) -> Origin {
        Origin { time: self.schedule.now, task: TaskNumber::default(), at: CodePlace::default() }
    }

    /// Starts `stop` in the task `~application` (5.2).
    fn begin_stop(&mut self) {
        self.phase = RunPhase::Stopping;
        if self.start_leading_task("stop", &[], |application| format!("~{application}")).is_err() {
            self.end();
        }
    }

    /// Whether the program `stop` of the application runs.
    #[must_use]
    pub fn is_stopping(&self) -> bool {
        matches!(self.phase, RunPhase::Stopping)
    }

    fn end(&mut self) {
        self.kill_tasks();
        self.devices.lines.shut_down();
        self.phase = RunPhase::Stopped;
    }

    /// Replaces the image of the application in memory. Data that both images declare alike keep their values.
    ///
    /// # Errors
    /// 40 without memory. The image in memory is then unchanged.
    pub fn exchange(&mut self, image: Arc<Image>) -> Result<(), Fault> {
        self.vm.space.exchange(self.application, image, &mut self.devices)
    }

    /// Replaces a line of a program in memory, which tasks may execute. The files stay unchanged. `code` is the new line for
    /// the event record.
    ///
    /// # Errors
    /// 40 without memory, 61 without the program. The program in memory is then unchanged.
    pub fn replace_line(&mut self, replacement: LineReplacement, code: &str) -> Result<(), Fault> {
        let LineReplacement { program, row, .. } = replacement;
        let files = self.devices.loaded_files(program.instance);
        let mut replaced = self.devices.replaced_lines(program.instance);
        let moved = self.vm.replace_line(replacement, &mut self.devices)?;
        self.devices.keep_loaded_files(program.instance, files);
        self.devices.state.arm.move_code(|at| moved.place(at));
        let image = self.vm.space.instance(program.instance).map(|instance| &instance.image);
        let named = image.and_then(|image| Some((&image.name, image.programs.get(usize::from(program.number))?)));
        let file = image.zip(named).and_then(|(image, (_, program))| image.files.get(program.file as usize));
        if let Some(file) = file {
            replaced.insert((file.clone(), row), code.to_owned());
        }
        let (project, name) = named.map_or(("", ""), |(project, program)| (project.as_str(), program.name.as_str()));
        let action = json!({ "project": project, "program": name, "line": row, "code": code });
        let keys = Map::from_iter([("replaceLine".to_owned(), action)]);
        self.devices.keep_replaced_lines(program.instance, replaced);
        self.devices.record_outside(self.schedule.now, EventKind::Act { keys });
        Ok(())
    }

    /// Kills all tasks, the newest first.
    pub fn kill_tasks(&mut self) {
        while let Some(task) = self.vm.tasks().last().map(|task| task.id) {
            self.kill(task);
        }
    }

    /// Keeps the application running when its tasks have ended, so that other programs can be started.
    pub fn outlive_tasks(&mut self) {
        self.outlives_tasks = true;
    }

    /// Runs a cycle of 4 ms: inputs, synchronous tasks, asynchronous tasks, outputs.
    ///
    /// After a status [within the cycle](RunStatus::is_within_cycle) the next call resumes it.
    pub fn step(&mut self) -> RunStatus {
        if self.outlives_tasks {
            return self.step_tasks();
        }
        let end = self.cycle();
        if end.is_within_cycle() {
            return end.into();
        }
        self.advance_phase();
        let is_over = (self.phase == RunPhase::Stopped).then_some(self.end_of_application());
        self.status(end, is_over)
    }

    /// Like [`step`](Self::step), but the application continues when its tasks have ended.
    pub fn step_tasks(&mut self) -> RunStatus {
        let end = self.cycle();
        if end.is_within_cycle() {
            return end.into();
        }
        let is_over = self.vm.tasks().is_empty().then_some(RunStatus::Finished);
        self.status(end, is_over)
    }

    /// Returns the status of the run after a complete cycle.
    fn status(&mut self, cycle: CycleEnd, is_over: Option<RunStatus>) -> RunStatus {
        match is_over {
            _ if self.devices.take_missing_instruction() => RunStatus::Unsupported,
            Some(status) => status,
            None if self.is_stuck() => RunStatus::Stuck,
            None => cycle.into(),
        }
    }

    fn end_of_application(&self) -> RunStatus {
        if self.stopped { RunStatus::Stopped } else { RunStatus::Finished }
    }

    /// Begins a cycle, or resumes the cycle that is not complete.
    fn cycle(&mut self) -> CycleEnd {
        if !self.schedule.is_within_cycle() {
            let start = self.schedule.now;
            self.begin_handling(start);
            self.follow_operator(start);
            self.devices.apply_received(start);
            self.begin_reactions(start);
            self.follow_script(start);
            self.devices.begin_cycle(start);
            self.watch_surroundings(start);
        }
        let end = self.schedule.cycle_end();
        let cycle_end = self.schedule.cycle(&mut self.vm, &mut self.devices);
        if !self.schedule.is_within_cycle() {
            self.devices.end_cycle(end);
            self.handle_parts(end);
            self.react(end);
        }
        cycle_end
    }

    /// Ends the run in the middle of a cycle: outputs and results of lines up to now are recorded.
    pub fn break_off(&mut self) {
        if self.schedule.is_within_cycle() {
            self.devices.end_cycle(self.schedule.now);
        }
    }

    /// Sets the condition under which a cycle stops so that the caller can inspect a task.
    pub fn watch(&mut self, watch: CycleWatch) {
        self.schedule.watch = watch;
    }

    /// The time at which the run stops.
    #[must_use]
    pub fn limit(&self) -> Option<Time> {
        self.schedule.limit
    }

    /// Sets the time at which the run stops, also in the middle of a cycle.
    pub fn set_limit(&mut self, limit: Option<Time>) {
        self.schedule.limit = limit;
    }

    /// Skips the time until the cycle of `time`, if nothing can happen before.
    pub fn jump(&mut self, time: Time) {
        self.schedule.now = self.schedule.now.max(time / CYCLE * CYCLE);
    }

    /// Instance of the application in the run time.
    #[must_use]
    pub fn application(&self) -> InstanceId {
        self.application
    }

    /// The time of the next event outside of tasks: a key is released, the power changes, a script entry is due.
    #[must_use]
    pub fn next_due(&self) -> Option<Time> {
        let now = self.schedule.now;
        let outside = self.script.next_due().into_iter().chain(self.operations.next_due()).chain(self.next_handling());
        self.devices.next_due(now).into_iter().chain(outside).min()
    }

    /// Time of the next script entry or action of the operator, the only events that can still occur if no task can run.
    #[must_use]
    pub fn next_action(&self) -> Option<Time> {
        self.script.next_due().into_iter().chain(self.operations.next_due()).min()
    }

    /// Whether a task is still stopped by an error.
    #[must_use]
    pub fn has_failed_tasks(&self) -> bool {
        self.vm.tasks().iter().any(|task| matches!(task.state, TaskState::Failed(_)))
    }

    /// Whether an error has stopped all remaining tasks.
    #[must_use]
    pub fn has_only_failed_tasks(&self) -> bool {
        self.vm.tasks().iter().all(|task| matches!(task.state, TaskState::Failed(_)))
    }

    fn advance_phase(&mut self) {
        match self.phase {
            RunPhase::Running if !self.has_tasks() => self.begin_stop(),
            RunPhase::Stopping if !self.leads() => self.end(),
            _ => {}
        }
    }

    /// Whether the task that executes `start` or `stop` exists.
    fn leads(&self) -> bool {
        self.vm.tasks().iter().any(|task| Some(task.id) == self.lead)
    }

    /// Whether the application has tasks. Library tasks do not keep it running: they are killed after `stop` (2.1.3).
    fn has_tasks(&self) -> bool {
        self.vm.tasks().iter().any(|task| task.owner == self.application)
    }

    fn is_stuck(&self) -> bool {
        !self.vm.tasks().iter().any(|task| task.state == TaskState::Running)
    }
}
