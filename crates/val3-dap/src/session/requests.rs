//! The answers to requests.

use serde_json::{Value, json};
use val3_debug::{Goal, StepKind};
use val3_lang::ports::TaskNumber;
use val3_lang::runtime_errors;
use val3_machine::arm::MotionMode;
use val3_machine::controller::Operation;
use val3_machine::event::seconds;
use val3_vm::TaskState;

use super::{DebugSession, Demand, Phase, Refusal, Target, execution};
use crate::assertions;
use crate::breakpoints;
use crate::custom;
use crate::inspection::{self, FrameHandle};
use crate::notices::{self, module};
use crate::protocol::{
    BreakpointLocationsResponse, ContinueResponse, Event, ExceptionBreakMode, ExceptionDetails, ExceptionInfoResponse,
    GotoArguments, InvalidatedAreas, InvalidatedEvent, LoadedSourcesResponse, ModulesArguments, ModulesResponse,
    OutputEvent, OutputEventCategory, Request, Response, ScopesResponse, SetBreakpointsResponse,
    SetDataBreakpointsResponse, SetExceptionBreakpointsResponse, SetFunctionBreakpointsResponse, StepInTarget,
    StepInTargetsResponse, StoppedEvent, StoppedEventReason, ThreadsResponse, VariablesResponse,
};

impl DebugSession {
    /// Answers a request of the specification with this number.
    pub(super) fn answer(&mut self, seq: i64, request: Request, target: &mut Target<'_>) -> Result<Response, Refusal> {
        if self.start.is_plain_run
            && let Some(response) = breakpoints::of_plain_run(&request)
        {
            return Ok(response);
        }
        match request {
            Request::ConfigurationDone(_) => {
                if !self.is_configured {
                    self.configured(target);
                }
                Ok(Response::ConfigurationDone)
            }
            Request::SetBreakpoints(arguments) => {
                let breakpoints = self.breakpoints.set(arguments, target, &self.conventions);
                Ok(Response::SetBreakpoints(SetBreakpointsResponse { breakpoints }))
            }
            Request::SetExceptionBreakpoints(arguments) => {
                let breakpoints = Some(self.breakpoints.set_errors(&arguments, target, &self.conventions));
                Ok(Response::SetExceptionBreakpoints(SetExceptionBreakpointsResponse { breakpoints }))
            }
            Request::SetFunctionBreakpoints(arguments) => {
                let breakpoints = self.breakpoints.set_programs(arguments.breakpoints, target, &self.conventions);
                Ok(Response::SetFunctionBreakpoints(SetFunctionBreakpointsResponse { breakpoints }))
            }
            Request::SetDataBreakpoints(arguments) => {
                let breakpoints = self.breakpoints.set_data(&arguments.breakpoints, target);
                Ok(Response::SetDataBreakpoints(SetDataBreakpointsResponse { breakpoints }))
            }
            Request::DataBreakpointInfo(arguments) => {
                self.data_breakpoint_info(&arguments, target).map(Response::DataBreakpointInfo)
            }
            Request::Evaluate(arguments) => self.evaluate(seq, &arguments, target).map(Response::Evaluate),
            Request::SetVariable(arguments) => self.set_variable(&arguments, target).map(Response::SetVariable),
            Request::SetExpression(arguments) => self.set_expression(&arguments, target).map(Response::SetExpression),
            Request::Completions(arguments) => self.completions(&arguments, target).map(Response::Completions),
            Request::GotoTargets(arguments) => self.goto_targets(&arguments, target).map(Response::GotoTargets),
            Request::Goto(arguments) => self.goto(&arguments, target).map(|()| Response::Goto),
            Request::RestartFrame(arguments) => {
                let frame = self.handles.frame(arguments.frame_id).ok_or_else(gone)?;
                let stop = target.debugger.restart_frame(frame.task, frame.depth).map_err(|fault| fault.to_string())?;
                self.stopped_elsewhere(execution::stopped(&stop, &mut target.debugger.controller));
                Ok(Response::RestartFrame)
            }
            Request::BreakpointLocations(arguments) => {
                let breakpoints = breakpoints::locations(&arguments, &target.debugger.controller, &self.conventions);
                Ok(Response::BreakpointLocations(BreakpointLocationsResponse { breakpoints }))
            }
            Request::Threads => {
                Ok(Response::Threads(ThreadsResponse { threads: inspection::threads(&target.debugger.controller) }))
            }
            Request::StackTrace(arguments) => {
                let trace = self.handles.stack_trace(&arguments, &target.debugger.controller, &self.conventions);
                trace.map(Response::StackTrace).ok_or_else(|| "there is no such task any more".to_owned())
            }
            Request::Scopes(arguments) => {
                let frame = self.handles.frame(arguments.frame_id).ok_or_else(gone)?;
                let scopes = self.handles.scopes(frame, &mut target.debugger.controller);
                Ok(Response::Scopes(ScopesResponse { scopes }))
            }
            Request::Variables(arguments) => {
                let format = self.format(arguments.format.as_ref());
                let controller = &mut target.debugger.controller;
                let variables = self.handles.variables(&arguments, controller, format).ok_or_else(gone)?;
                Ok(Response::Variables(VariablesResponse { variables }))
            }
            Request::Continue(arguments) => {
                let is_one = self.release(arguments.thread_id, arguments.single_thread, target)?;
                let all_threads_continued = Some(!is_one);
                Ok(Response::Continue(ContinueResponse { all_threads_continued }))
            }
            Request::Next(arguments) => {
                let step = (arguments.thread_id, arguments.single_thread);
                self.step(step, StepKind::Over, target).map(|()| Response::Next)
            }
            Request::StepIn(arguments) => {
                let step = (arguments.thread_id, arguments.single_thread);
                let task = Self::task(arguments.thread_id, target)?;
                let chosen = arguments.target_id.and_then(|_| target.debugger.step_in_target(task));
                let kind = chosen.map_or(StepKind::In, |chosen| chosen.kind);
                self.step(step, kind, target).map(|()| Response::StepIn)
            }
            Request::StepInTargets(arguments) => {
                let frame = self.handles.frame(arguments.frame_id).ok_or_else(gone)?;
                let targets = step_in_targets(frame, target);
                Ok(Response::StepInTargets(StepInTargetsResponse { targets }))
            }
            Request::StepOut(arguments) => {
                let step = (arguments.thread_id, arguments.single_thread);
                self.step(step, StepKind::Out, target).map(|()| Response::StepOut)
            }
            Request::StepBack(arguments) => {
                let task = Self::task(arguments.thread_id, target)?;
                self.go_back(seq, Goal::Line(task, StepKind::Over), target).map(|()| Response::StepBack)
            }
            Request::ReverseContinue(_) => {
                self.go_back(seq, Goal::Breakpoint, target).map(|()| Response::ReverseContinue)
            }
            Request::Pause(arguments) => {
                self.pause(arguments.thread_id, target);
                Ok(Response::Pause)
            }
            Request::ExceptionInfo(arguments) => {
                exception_info(arguments.thread_id, target).map(Response::ExceptionInfo)
            }
            Request::TerminateThreads(arguments) => {
                let threads = arguments.thread_ids.unwrap_or_default();
                self.kill(&threads, target).map(|()| Response::TerminateThreads)
            }
            Request::LoadedSources(_) => {
                let images = target.debugger.controller.vm.space.loaded().map(|(_, instance)| &instance.image);
                let sources = images.flat_map(|image| &image.files).map(|file| self.conventions.source(file)).collect();
                Ok(Response::LoadedSources(LoadedSourcesResponse { sources }))
            }
            Request::Modules(arguments) => Ok(Response::Modules(modules(&arguments, target))),
            Request::Restart(_) if self.start.is_attach => {
                Err("a run that a client has attached to cannot be restarted: start it again".to_owned())
            }
            Request::Restart(_) => {
                self.demand = Some(Demand::Restart);
                Ok(Response::Restart)
            }
            Request::Terminate(_) => {
                // The program `stop` runs, as when an operator stops the application.
                target.debugger.controller.operate(Operation::Stop);
                target.debugger.resume_tasks();
                self.run_on();
                Ok(Response::Terminate)
            }
            Request::Disconnect(arguments) => {
                let is_end = arguments.terminate_debuggee == Some(true);
                let is_suspended = arguments.suspend_debuggee == Some(true);
                self.demand = Some(if is_end { Demand::End } else { self.farewell(is_suspended) });
                Ok(Response::Disconnect)
            }
            // A request that it cancels is over: cancelled requests are refused before.
            Request::Cancel(_) => Ok(Response::Cancel),
            Request::Initialize(_) | Request::Launch(_) | Request::Attach(_) => {
                Err(format!("the session has begun, so that `{}` comes too late", request.command()))
            }
            _ => Err(format!("this adapter does not have the request `{}`", request.command())),
        }
    }

    /// Lets a task continue at another line.
    fn goto(&mut self, arguments: &GotoArguments, target: &mut Target<'_>) -> Result<(), Refusal> {
        let task = Self::task(arguments.thread_id, target)?;
        let (file, row) = self.goto_targets.get(&arguments.target_id).cloned().ok_or_else(gone)?;
        let is_alone = self.check_task_stopped(task, target)?;
        let found = target.debugger.goto_target(task, &file, row).map_err(|fault| fault.to_string())?;
        self.tell_of_new_future(target);
        target.debugger.goto(task, found).map_err(|fault| fault.to_string())?;
        let event = execution::event(StoppedEventReason::Goto, Some(task));
        self.stopped_elsewhere(StoppedEvent { all_threads_stopped: Some(!is_alone), ..event });
        Ok(())
    }

    /// Begins a step of a task, alone or with the others.
    fn step(
        &mut self,
        (thread, is_single): (i32, Option<bool>),
        kind: StepKind,
        target: &mut Target<'_>,
    ) -> Result<(), Refusal> {
        let task = Self::task(thread, target)?;
        self.release(thread, is_single, target)?;
        target.debugger.step(task, kind);
        Ok(())
    }

    /// Kills tasks; none of them if one does not exist.
    fn kill(&mut self, threads: &[i32], target: &mut Target<'_>) -> Result<(), Refusal> {
        let tasks = threads.iter().map(|thread| Self::task(*thread, target)).collect::<Result<Vec<_>, Refusal>>()?;
        self.tell_of_new_future(target);
        tasks.into_iter().for_each(|task| target.debugger.controller.kill(task));
        target.debugger.begin_new_future();
        self.changed_by_hand(target);
        Ok(())
    }

    /// Answers a request `val3/…`.
    pub(super) fn answer_custom(
        &mut self,
        command: &str,
        arguments: Option<Value>,
        target: &mut Target<'_>,
    ) -> Result<Value, Refusal> {
        let arguments = match arguments {
            Some(Value::Object(arguments)) => arguments,
            None | Some(Value::Null) => serde_json::Map::new(),
            Some(_) => return Err(format!("the arguments of `{command}` are an object")),
        };
        match command {
            "val3/subscribe" => return self.subscriptions.subscribe(&arguments, &target.debugger.controller),
            "val3/motionStep" => return self.step_motion(target),
            "val3/past" => return past(target),
            _ => {}
        }
        let answer = custom::answer(command, arguments, &mut self.subscriptions.operator, target.debugger)?;
        if answer.changes {
            self.tell_of_new_future(target);
            target.debugger.begin_new_future();
            self.changed_by_hand(target);
        }
        Ok(answer.body)
    }

    /// Lets the arm advance by one piece in step mode, while all tasks rest.
    fn step_motion(&mut self, target: &mut Target<'_>) -> Result<Value, Refusal> {
        self.check_stopped()?;
        if target.debugger.motion_mode() != MotionMode::Step {
            return Err("the motion is not in step mode: change it with `val3/motionMode`".to_owned());
        }
        let status = target.debugger.controller.motion_status();
        let Some(next) = status.next else {
            return Err("no further motion is determined: execute the next line".to_owned());
        };
        target.debugger.step_motion();
        self.run_on();
        Ok(json!({ "piece": custom::piece(&next) }))
    }

    pub(super) fn check_stopped(&self) -> Result<(), Refusal> {
        // Clients know this word.
        if self.phase == Phase::Stopped { Ok(()) } else { Err("notStopped".to_owned()) }
    }

    /// Whether a task is stopped alone. An error if it runs.
    fn check_task_stopped(&self, task: TaskNumber, target: &Target<'_>) -> Result<bool, Refusal> {
        let is_alone = self.phase == Phase::Running && target.debugger.is_task_paused(task);
        if is_alone { Ok(true) } else { self.check_stopped().map(|()| false) }
    }

    /// Lets all tasks continue, or one alone. Returns whether it is one.
    fn release(&mut self, thread: i32, is_single: Option<bool>, target: &mut Target<'_>) -> Result<bool, Refusal> {
        if let Ok(task) = Self::task(thread, target)
            && self.check_task_stopped(task, target)?
        {
            self.handles.forget_frames(task);
            target.debugger.pause_task(task, false);
            return Ok(true);
        }
        self.check_stopped()?;
        let is_single = is_single == Some(true);
        if is_single {
            let task = Self::task(thread, target)?;
            self.tell_of_new_future(target);
            target.debugger.pause_others(task);
        } else {
            target.debugger.resume_tasks();
        }
        self.run_on();
        Ok(is_single)
    }

    /// Pauses the run, or the task alone where tasks stop alone.
    fn pause(&mut self, thread: i32, target: &mut Target<'_>) {
        if !self.is_running() {
            return;
        }
        match Self::task(thread, target) {
            Ok(task) if self.start.settings.stops_one_task => {
                target.debugger.pause_task(task, true);
                let event = execution::event(StoppedEventReason::Pause, Some(task));
                self.following.push(Event::Stopped(StoppedEvent { all_threads_stopped: Some(false), ..event }));
            }
            _ => target.debugger.pause(notices::task(thread)),
        }
    }

    /// The run is about to be changed by hand. If it has gone back, the user learns that what followed is gone.
    pub(super) fn tell_of_new_future(&mut self, target: &Target<'_>) {
        if target.debugger.is_in_past() {
            let output = "note: the run continues from here with a change: a new future begins\n".to_owned();
            let category = Some(OutputEventCategory::Console);
            self.following.push(Event::Output(OutputEvent { output, category, ..OutputEvent::default() }));
        }
    }

    /// The run continues with the next cycle.
    pub(super) fn run_on(&mut self) {
        self.handles.clear();
        self.goto_targets.clear();
        self.phase = Phase::Running;
    }

    /// The run is at another moment, or a task is at another line, without having run there. Clients ask for everything
    /// again after a stop: with `invalidated` as well, VS Code would ask for values of the stop before.
    pub(super) fn stopped_elsewhere(&mut self, event: StoppedEvent) {
        self.handles.clear();
        self.following.push(Event::Stopped(event));
    }

    /// The user has changed something: the values that the client shows are stale.
    pub(super) fn changed_by_hand(&mut self, target: &mut Target<'_>) {
        let events = target.debugger.controller.devices.take_events();
        let notices = self.notices.of(&events, &target.debugger.controller, &self.conventions);
        self.following.extend(notices);
        if self.phase == Phase::Stopped {
            self.invalidate();
        }
    }

    fn invalidate(&mut self) {
        if self.conventions.knows_invalidated {
            let areas = Some(vec![InvalidatedAreas::All]);
            self.following.push(Event::Invalidated(InvalidatedEvent { areas, ..InvalidatedEvent::default() }));
        }
    }
}

pub(super) fn gone() -> Refusal {
    "this belongs to a stop that is over".to_owned()
}

/// Where the next line of a frame leads. Only the innermost program has a next line.
fn step_in_targets(FrameHandle { task, depth }: FrameHandle, target: &Target<'_>) -> Vec<StepInTarget> {
    let found = target.debugger.step_in_target(task).filter(|_| depth == 0);
    let shown = found.map(|found| {
        let label = format!("{}:{}()", found.application, found.program);
        let label = if found.kind == StepKind::IntoTask { format!("the task of {label}") } else { label };
        StepInTarget { id: 1, label, ..StepInTarget::default() }
    });
    shown.into_iter().collect()
}

/// The run-time error that has stopped a task, with what to do about it, or the assertion that has failed.
fn exception_info(thread: i32, target: &mut Target<'_>) -> Result<ExceptionInfoResponse, Refusal> {
    let task = DebugSession::task(thread, target)?;
    if let Some(message) = assertions::message(&mut target.debugger.controller, task) {
        return Ok(ExceptionInfoResponse {
            exception_id: "failed assertion".to_owned(),
            description: Some(message),
            break_mode: ExceptionBreakMode::Always,
            details: None,
        });
    }
    let found = target.debugger.controller.vm.tasks().iter().find(|known| known.id == task);
    let Some(TaskState::Failed(fault)) = found.map(|task| task.state) else {
        return Err("no run-time error has stopped this task".to_owned());
    };
    let error = runtime_errors::find(fault.0);
    let (short, long) = error.map_or(("unknown run-time error", ""), |error| (error.short, error.long));
    Ok(ExceptionInfoResponse {
        exception_id: format!("error {}", fault.0),
        description: Some(format!("{short}\n{long}\n`val3 explain {}` has its page", fault.0)),
        break_mode: ExceptionBreakMode::Always,
        details: Some(ExceptionDetails {
            message: Some(short.to_owned()),
            type_name: Some(fault.0.to_string()),
            ..ExceptionDetails::default()
        }),
    })
}

/// How far the run can go back.
fn past(target: &Target<'_>) -> Result<Value, Refusal> {
    let reach = target.debugger.reach().ok_or("the run is not recorded")?;
    Ok(json!({
        "first": seconds(reach.first.time),
        "time": seconds(reach.time),
        "cycles": reach.cycles,
        "isWhole": reach.is_whole,
        "snapshots": reach.snapshots,
        "bytes": reach.bytes,
    }))
}

fn modules(arguments: &ModulesArguments, target: &Target<'_>) -> ModulesResponse {
    let images = target.debugger.controller.vm.space.loaded().map(|(_, instance)| &instance.image);
    let all: Vec<_> = images.map(|image| module(&image.name, &image.path)).collect();
    let start = arguments.start_module.and_then(|start| usize::try_from(start).ok()).unwrap_or_default();
    let most = arguments.module_count.filter(|count| *count > 0).map_or(usize::MAX, |count| count as usize);
    let total_modules = u64::try_from(all.len()).ok();
    ModulesResponse { modules: all.into_iter().skip(start).take(most).collect(), total_modules }
}
