//! A session: a client that debugs a run.
//!
//! The loop of the run calls [`DebugSession::attend`] between two cycles. Requests are handled there, one after the other
//! and on the thread of the run, so that they see the controller between two operations. While the run is stopped, the
//! loop waits for the client, and the controller's clock is stopped.

mod at_end;
mod control;
mod evaluation;
mod named_data;
mod search;
mod step_wait;

use std::collections::BTreeMap;
use std::time::Duration;

use val3_debug::{Goal, Stop};
use val3_lang::ports::Time;
use val3_machine::event::Event as MachineEvent;

use crate::breakpoint_hits::ShownHits;
use crate::breakpoints::BreakpointTable;
use crate::client::{Client, Incoming};
use crate::conventions::Conventions;
use crate::debugged_run::DebuggedRun;
use crate::inspection::Handles;
use crate::live::Subscriptions;
use crate::message::{MessageContent, ProtocolMessage};
use crate::notices::Notices;
use crate::protocol::{
    self, BreakpointEvent, BreakpointEventReason, ExitedEvent, OutputEvent, OutputEventCategory, Response,
    StandardEvent, StoppedEvent, StoppedEventReason, TerminatedEvent,
};
use crate::session_start::SessionStart;
use crate::stop_event;

use step_wait::StepWait;

pub(crate) use named_data::NamedData;

/// Next action of the run's loop.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NextAction {
    /// The next cycle.
    Run,
    /// Nothing, until the client has another request: see [`DebugSession::wait`].
    Wait,
    /// Open the application again and run it from its beginning.
    Restart,
    /// End the run.
    End,
    /// Go on without the client, which has left the run that it had attached to.
    Detach {
        /// The run stays stopped until another client comes.
        is_suspended: bool,
    },
}

/// The state of a run when its client comes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RunState {
    /// Before its first line.
    Fresh,
    /// It runs, also while the client sets its breakpoints.
    Running,
    /// A client that has left has stopped it.
    Suspended,
}

/// The state of a session.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum SessionState {
    /// The client sets its breakpoints.
    Configuring,
    Running,
    Stopped,
    /// The run is over.
    Over,
}

/// A client that debugs a run.
#[derive(Debug)]
pub struct DebugSession {
    pub(crate) client: Client,
    pub(crate) conventions: Conventions,
    phase: SessionState,
    pub(crate) start: SessionStart,
    run: RunState,
    is_configured: bool,
    /// Whether the run goes to its end without stops (`startAtEnd`).
    runs_to_end: bool,
    /// Whether the run has stopped at the end of its recording, and was at no other moment since.
    is_at_recorded_end: bool,
    /// Number of the present request.
    pub(crate) request: i64,
    /// Next action that the last request requires.
    pub(crate) action: Option<NextAction>,
    pub(crate) breakpoints: BreakpointTable,
    /// Hit counts that the client has.
    pub(crate) shown_hits: ShownHits,
    pub(crate) handles: Handles,
    notices: Notices,
    pub(crate) subscriptions: Subscriptions,
    /// Lines to which a task can go, by their numbers for the client.
    pub(crate) goto_targets: BTreeMap<i32, (String, u32)>,
    /// Moment of the past to which the run goes after the response to the present request.
    pub(crate) goal: Option<Goal>,
    /// Wait of the current step.
    step_wait: Option<StepWait>,
    /// Events that follow the response to the present request.
    pub(crate) following: Vec<StandardEvent>,
}

impl DebugSession {
    /// Creates a session. The client has received `initialized`.
    pub(crate) fn new(client: Client, conventions: Conventions, start: &SessionStart, run: RunState) -> Self {
        let mut notices = Notices::default();
        notices.show_screen_output(start.settings.shows_screen_output);
        Self {
            client,
            conventions,
            phase: SessionState::Configuring,
            start: start.clone(),
            run,
            is_configured: false,
            runs_to_end: false,
            is_at_recorded_end: false,
            request: 0,
            action: None,
            breakpoints: match start.is_plain_run {
                true => BreakpointTable::default(),
                false => BreakpointTable::with_default_filters(),
            },
            shown_hits: ShownHits::default(),
            handles: Handles::default(),
            notices,
            subscriptions: Subscriptions::default(),
            goto_targets: BTreeMap::new(),
            goal: None,
            step_wait: None,
            following: Vec::new(),
        }
    }

    /// Waits for a message, at most for this time.
    pub fn wait(&mut self, time: Duration) {
        self.client.wait(time);
    }

    /// Whether the run continues, also while a client that attaches sets its breakpoints.
    pub(crate) fn is_running(&self) -> bool {
        self.phase == SessionState::Running
            || (self.phase == SessionState::Configuring && self.run == RunState::Running)
    }

    /// The client has left: a run that it has launched ends with it.
    pub(crate) fn action_after_disconnect(&self, is_suspended: bool) -> NextAction {
        if self.start.is_attach { NextAction::Detach { is_suspended } } else { NextAction::End }
    }

    /// Sends new messages for a page that shows the run.
    pub(crate) fn refresh_view(&mut self, run: &DebuggedRun<'_>) {
        if let Some(messages) = self.subscriptions.refreshed_view(&run.debugger.controller) {
            self.client.custom_event("val3/view", messages);
        }
    }

    /// Sends the events of the run.
    pub fn report(&mut self, events: &[MachineEvent], run: &mut DebuggedRun<'_>) {
        let notices = self.notices.of(events, &run.debugger.controller, &self.conventions);
        let has_new_files = notices.iter().any(|notice| matches!(notice, StandardEvent::LoadedSource(_)));
        notices.iter().for_each(|notice| self.client.event(notice));
        if has_new_files {
            self.place_again(run);
        }
        let ended = self.breakpoints.ended_data(run.debugger);
        self.shown_hits.update(&ended);
        ended.into_iter().for_each(|breakpoint| self.breakpoint_changed(breakpoint));
        for message in run.debugger.take_logged() {
            let category = Some(OutputEventCategory::Console);
            let output = message.text + "\n";
            self.client.event(&StandardEvent::Output(OutputEvent { output, category, ..OutputEvent::default() }));
        }
        self.note_step_wait(run);
        self.subscriptions.note(events, &run.debugger.controller);
        for (name, body) in self.subscriptions.changes(events, &run.debugger.controller) {
            self.client.custom_event(name, body);
        }
    }

    /// A cycle that began at `start` is over.
    pub fn see(&mut self, start: Time, run: &DebuggedRun<'_>) {
        if let Some(batch) = self.subscriptions.see(start, &run.debugger.controller) {
            self.client.custom_event("val3/motion", batch);
        }
        if let Some(messages) = self.subscriptions.view(start, &run.debugger.controller) {
            self.client.custom_event("val3/view", messages);
        }
    }

    /// Tells the client where its breakpoints are now.
    fn place_again(&mut self, run: &mut DebuggedRun<'_>) {
        let placed = self.breakpoints.place_all(run, &self.conventions);
        self.shown_hits.update(&placed);
        placed.into_iter().for_each(|breakpoint| self.breakpoint_changed(breakpoint));
    }

    /// Sends the hit counts that have changed.
    pub(crate) fn report_hits(&mut self, run: &DebuggedRun<'_>) {
        let changes = self.shown_hits.changes(run.debugger);
        changes.into_iter().for_each(|breakpoint| self.breakpoint_changed(breakpoint));
    }

    fn breakpoint_changed(&mut self, breakpoint: protocol::Breakpoint) {
        let reason = BreakpointEventReason::Changed;
        self.client.event(&StandardEvent::Breakpoint(BreakpointEvent { breakpoint, reason }));
    }

    /// The run, or only one task, has stopped by itself.
    pub fn stop(&mut self, stop: &Stop, run: &mut DebuggedRun<'_>) {
        if self.passes(stop, run) {
            return;
        }
        self.end_run_to_end(run);
        let is_alone = stop.task_alone().is_some_and(|task| run.debugger.is_task_paused(task));
        let event = stop_event::stopped(stop, &mut run.debugger.controller);
        self.report_stop(StoppedEvent { all_threads_stopped: Some(!is_alone), ..event }, run);
    }

    /// Reports a stop of the whole run, or of a task alone.
    pub(crate) fn report_stop(&mut self, event: StoppedEvent, run: &mut DebuggedRun<'_>) {
        if event.all_threads_stopped == Some(true) {
            self.phase = SessionState::Stopped;
            self.handles.clear();
        }
        if let Some(batch) = self.subscriptions.flush() {
            self.client.custom_event("val3/motion", batch);
        }
        self.refresh_view(run);
        self.report_hits(run);
        self.client.event(&StandardEvent::Stopped(event));
    }

    /// The client has set its breakpoints. Does nothing in later calls.
    pub(crate) fn finish_configuration(&mut self, run: &mut DebuggedRun<'_>) {
        if !self.is_configured {
            self.configured(run);
        }
    }

    /// The client has set its breakpoints: the run begins, stops before its first line, or continues.
    fn configured(&mut self, run: &mut DebuggedRun<'_>) {
        self.is_configured = true;
        self.breakpoints.apply_errors(run, &self.conventions);
        let controller = &run.debugger.controller;
        let mut notices = self.notices.source_changes(controller, &self.conventions);
        notices.extend(self.notices.task_changes(controller));
        self.following.push(StandardEvent::Process(stop_event::process(controller, self.start.is_attach)));
        self.following.extend(notices);
        if self.phase != SessionState::Configuring {
            return;
        }
        self.phase = SessionState::Running;
        self.is_at_recorded_end = false;
        self.runs_to_end = self.start.settings.starts_at_end && self.run == RunState::Fresh;
        let task = controller.vm.tasks().first().map(|task| task.id);
        match self.run {
            RunState::Fresh if self.start.settings.stops_on_entry && !self.runs_to_end => {
                self.phase = SessionState::Stopped;
                if let Some(task) = task {
                    // A breakpoint at the first line does not stop the task there once more.
                    run.debugger.controller.vm.pass_stop(task);
                }
                self.following.push(StandardEvent::Stopped(stop_event::event(StoppedEventReason::Entry, task)));
            }
            RunState::Running if self.start.settings.stops_on_entry => run.debugger.pause(None),
            RunState::Fresh | RunState::Running => {}
            RunState::Suspended => {
                self.phase = SessionState::Stopped;
                self.following.push(StandardEvent::Stopped(stop_event::event(StoppedEventReason::Pause, task)));
            }
        }
    }

    /// The application is in memory and has not begun. After a restart, the client has its breakpoints again.
    pub fn begin(&mut self, run: &mut DebuggedRun<'_>) {
        for notice in self.notices.forget_tasks() {
            self.client.event(&notice);
        }
        self.handles.clear();
        self.breakpoints.apply_errors(run, &self.conventions);
        let removed = self.breakpoints.remove_data();
        self.shown_hits.update(&removed);
        removed.into_iter().for_each(|breakpoint| self.breakpoint_changed(breakpoint));
        self.place_again(run);
        self.phase = SessionState::Configuring;
        if self.is_configured {
            self.configured(run);
        }
        for event in std::mem::take(&mut self.following) {
            self.client.event(&event);
        }
    }

    /// Shows a text of the standard error output to the user.
    pub fn say(&mut self, text: &str) {
        self.client.say(text);
    }

    /// Sends an event that is not part of the protocol.
    pub fn tell(&mut self, event: &str, body: serde_json::Value) {
        self.client.custom_event(event, body);
    }

    /// Whether the client shows colours that ANSI escape sequences set.
    #[must_use]
    pub const fn shows_colors(&self) -> bool {
        self.conventions.shows_colors
    }

    /// The run is over.
    pub fn end(&mut self, exit_code: u8) {
        for notice in self.notices.forget_tasks() {
            self.client.event(&notice);
        }
        self.client.event(&StandardEvent::Exited(ExitedEvent { exit_code: exit_code.into() }));
        self.client.event(&StandardEvent::Terminated(TerminatedEvent::default()));
        self.phase = SessionState::Over;
    }

    /// Handles requests after the end of the run: `disconnect`, `restart` and a few others.
    pub fn attend_end(&mut self) -> NextAction {
        while let Some(incoming) = self.client.poll() {
            match incoming {
                Incoming::Message(ProtocolMessage { seq, content: MessageContent::Request { command, .. } }) => {
                    if let Some(action) = self.answer_after_end(seq, &command) {
                        return action;
                    }
                }
                Incoming::Message(_) | Incoming::Garbage(_) => {}
                Incoming::End => self.client.disconnect(),
            }
        }
        if self.client.is_connected() { NextAction::Wait } else { NextAction::End }
    }

    fn answer_after_end(&mut self, seq: i64, command: &str) -> Option<NextAction> {
        let (response, action) = match command {
            "disconnect" => (Response::Disconnect, Some(NextAction::End)),
            "terminate" => (Response::Terminate, None),
            "restart" => (Response::Restart, Some(NextAction::Restart)),
            "threads" => (Response::Threads(protocol::ThreadsResponse::default()), None),
            _ => {
                self.client.refuse(seq, command, "the run is over");
                return None;
            }
        };
        self.client.send(MessageContent::success(seq, &response));
        action
    }
}
