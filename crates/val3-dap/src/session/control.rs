//! Control of the run, for several requests.

use val3_debug::{Goal, StepKind, VariableFilter};
use val3_lang::ports::TaskNumber;

use super::{DebugSession, SessionState, changed, has_new_files};
use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::notices;
use crate::protocol::{
    InvalidatedAreas, InvalidatedEvent, OutputEvent, OutputEventCategory, StandardEvent, StoppedEvent,
    StoppedEventReason,
};
use crate::stop_event;

impl DebugSession {
    /// Returns the task with a thread id.
    ///
    /// # Errors
    /// The task does not exist.
    pub(crate) fn task(thread: i32, run: &DebuggedRun<'_>) -> Result<TaskNumber, RequestFailure> {
        let task = notices::task(thread);
        let known = task.filter(|task| run.debugger.controller.vm.tasks().iter().any(|known| known.id == *task));
        known.ok_or(RequestFailure::NoSuchTask)
    }

    /// Begins a step of a task. If `is_single` is true, all other tasks are paused.
    ///
    /// # Errors
    /// The task does not exist or is not stopped.
    pub(crate) fn step(
        &mut self,
        thread: i32,
        is_single: Option<bool>,
        kind: StepKind,
        run: &mut DebuggedRun<'_>,
    ) -> Result<(), RequestFailure> {
        let task = Self::task(thread, run)?;
        self.release(thread, is_single, run)?;
        run.debugger.step(task, kind);
        Ok(())
    }

    /// Goes back to an earlier line of a task, after the response.
    ///
    /// # Errors
    /// The task does not exist.
    pub(crate) fn step_back(
        &mut self,
        thread: i32,
        kind: StepKind,
        run: &DebuggedRun<'_>,
    ) -> Result<(), RequestFailure> {
        self.goal = Some(Goal::Line(Self::task(thread, run)?, kind));
        Ok(())
    }

    /// Reports that a request has changed data, inputs or the arm, and discards the history after the present.
    pub(crate) fn run_changed(&mut self, run: &mut DebuggedRun<'_>) {
        self.report_new_future(run);
        if self.phase == SessionState::Stopped {
            // Expressions that are evaluated now read a forced input immediately, as do the next lines of programs. A
            // running application reads it in its next cycle.
            run.debugger.controller.devices.state.io.show_inputs();
        }
        run.debugger.begin_new_future();
        self.subscriptions.begin_new_future(&run.debugger.controller);
        self.is_at_failed_end = false;
        let events = run.debugger.controller.devices.take_events();
        self.notices.repeat(false);
        let notices = self.notices.of(&events, &mut run.debugger.controller, &self.conventions);
        let places_again = has_new_files(&notices);
        self.following.extend(notices);
        if places_again {
            let placed = self.placed_again(run);
            self.following.extend(placed.into_iter().map(changed));
        }
        if self.phase == SessionState::Stopped {
            self.invalidate(InvalidatedAreas::All);
        }
    }

    /// Checks that the whole run is stopped.
    pub(crate) fn check_stopped(&self) -> Result<(), RequestFailure> {
        if self.phase == SessionState::Stopped { Ok(()) } else { Err(RequestFailure::NotStopped) }
    }

    /// Returns whether only this task is stopped.
    ///
    /// # Errors
    /// The task runs.
    pub(crate) fn check_task_stopped(&self, task: TaskNumber, run: &DebuggedRun<'_>) -> Result<bool, RequestFailure> {
        let is_alone = self.phase == SessionState::Running && run.debugger.is_task_paused(task);
        if is_alone { Ok(true) } else { self.check_stopped().map(|()| false) }
    }

    /// Resumes all tasks, or only one. Returns whether only one was resumed.
    ///
    /// # Errors
    /// The tasks are not stopped.
    pub(crate) fn release(
        &mut self,
        thread: i32,
        is_single: Option<bool>,
        run: &mut DebuggedRun<'_>,
    ) -> Result<bool, RequestFailure> {
        if let Ok(task) = Self::task(thread, run)
            && self.check_task_stopped(task, run)?
        {
            self.handles.forget_frames(task);
            run.debugger.pause_task(task, false);
            return Ok(true);
        }
        self.check_stopped()?;
        let is_single = is_single == Some(true);
        if is_single {
            let task = Self::task(thread, run)?;
            self.report_new_future(run);
            run.debugger.pause_others(task);
        } else {
            run.debugger.resume_tasks();
        }
        self.run_on();
        Ok(is_single)
    }

    /// Pauses the run; with `"stopScope": "task"` only the task.
    pub(crate) fn pause(&mut self, thread: i32, run: &mut DebuggedRun<'_>) {
        if !self.is_running() {
            return;
        }
        match Self::task(thread, run) {
            Ok(task) if self.start.settings.stops_one_task => {
                run.debugger.pause_task(task, true);
                let event = stop_event::event(StoppedEventReason::Pause, Some(task));
                self.following.push(StandardEvent::Stopped(StoppedEvent { all_threads_stopped: Some(false), ..event }));
            }
            _ => run.debugger.pause(notices::task(thread)),
        }
    }

    /// Reports that the next change discards later recorded events, if the run has gone back.
    pub(crate) fn report_new_future(&mut self, run: &DebuggedRun<'_>) {
        if run.debugger.is_in_past() {
            self.note("the run continues from here with a change: a new future begins");
        }
    }

    /// Reports patterns of `skip` that match no program, for example because of a typing error.
    pub(super) fn note_unused_skips(&mut self, run: &DebuggedRun<'_>) {
        for pattern in run.debugger.unused_skips() {
            self.note(&format!(
                "`skip`: `{pattern}` is no library and no program of this application; write `library` or \
                 `library:program`, or keep it for a library that the program loads later"
            ));
        }
    }

    /// Shows a note in the debug console, after the response to the present request.
    pub(crate) fn note(&mut self, text: &str) {
        let category = Some(OutputEventCategory::Console);
        let output = format!("note: {text}\n");
        self.following.push(StandardEvent::Output(OutputEvent { output, category, ..OutputEvent::default() }));
    }

    /// Invalidates all handles: the run continues with the next cycle.
    pub(crate) fn run_on(&mut self) {
        self.handles.clear();
        self.goto_targets.clear();
        self.phase = SessionState::Running;
    }

    /// Reports that the run is at another moment or line without having run there. Sends no `invalidated`, because
    /// clients request all values after a stop, and VS Code would also request values of the previous stop.
    pub(crate) fn stopped_elsewhere(&mut self, event: StoppedEvent) {
        (self.is_at_recorded_end, self.is_at_failed_end) = (false, false);
        self.handles.clear();
        self.following.push(StandardEvent::Stopped(event));
    }

    /// Changes the filter of the global variables in scopes.
    pub(crate) fn filter_variables(&mut self, filter: Option<VariableFilter>) {
        self.start.settings.variable_filter = filter;
        self.note_variable_filter();
        self.invalidate(InvalidatedAreas::Variables);
    }

    /// Reports that a filter hides global variables. The names of the scopes do not change, because clients expand scopes
    /// again by their names.
    pub(super) fn note_variable_filter(&mut self) {
        if let Some(filter) = &self.start.settings.variable_filter {
            self.note(&format!("only global variables that match `{}` are shown", filter.text()));
        }
    }

    fn invalidate(&mut self, area: InvalidatedAreas) {
        if self.conventions.knows_invalidated {
            let areas = Some(vec![area]);
            self.following.push(StandardEvent::Invalidated(InvalidatedEvent { areas, ..InvalidatedEvent::default() }));
        }
    }
}
