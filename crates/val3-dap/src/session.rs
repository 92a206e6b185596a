//! A session: a client that debugs a run.
//!
//! The loop of the run calls [`DebugSession::attend`] between two cycles. Requests are handled there, one after the
//! other and on the thread of the run, so that they access the controller between two operations. While the run is
//! stopped, the loop waits for the client, and the controller's clock is stopped.

mod arm_wait;
mod at_end;
mod console_call;
mod control;
mod earlier_values;
mod end_progress;
mod evaluation;
mod line_wait;
mod named_data;
mod search;
mod step_wait;

use std::collections::BTreeMap;
use std::time::Duration;

use val3_debug::{Goal, Stop};
use val3_lang::ports::Time;
use val3_machine::event::{Event as MachineEvent, seconds};

use crate::breakpoint_hits::ShownHits;
use crate::breakpoints::BreakpointTable;
use crate::client::{Client, Incoming};
use crate::conventions::Conventions;
use crate::debugged_run::DebuggedRun;
use crate::error::ReadError;
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

use arm_wait::ArmWait;
use end_progress::EndProgress;
use line_wait::LineWait;
use step_wait::StepWait;

pub use at_end::TimeEnd;
pub(crate) use named_data::NamedData;

/// Next action of the run's loop.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NextAction {
    /// Execute the next cycle.
    Run,
    /// Wait for the next request of the client: see [`DebugSession::wait`].
    Wait,
    /// Open the application again and run it from its beginning.
    Restart,
    /// End the run.
    End,
    /// Continue without the client, which has detached from the run.
    Detach {
        /// Whether the run stays stopped until another client attaches.
        is_suspended: bool,
    },
}

/// State of a run when its session begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RunState {
    /// Before its first line.
    Fresh,
    /// Running, also while the client sets its breakpoints.
    Running,
    /// Stopped by a client that has detached.
    Suspended,
}

/// State of a session.
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
    /// Progress on this way.
    end_progress: EndProgress,
    /// Whether the run has stopped at the end of its recording or at its time limit, and is still at this moment.
    is_at_recorded_end: bool,
    /// Whether the run has stopped after the failure of all its tasks, and is still at this moment.
    is_at_failed_end: bool,
    /// Number of the present request.
    pub(crate) request: i64,
    /// Next action that the last request requires.
    pub(crate) action: Option<NextAction>,
    pub(crate) breakpoints: BreakpointTable,
    /// Hit counts that were sent to the client.
    pub(crate) shown_hits: ShownHits,
    pub(crate) handles: Handles,
    notices: Notices,
    pub(crate) subscriptions: Subscriptions,
    /// Targets of `goto` by id: file and row.
    pub(crate) goto_targets: BTreeMap<i32, (String, u32)>,
    /// Goal of the reverse search that begins after the response to the present request.
    pub(crate) goal: Option<Goal>,
    /// Wait of the current step.
    step_wait: Option<StepWait>,
    arm_wait: ArmWait,
    line_wait: LineWait,
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
            end_progress: EndProgress::default(),
            is_at_recorded_end: false,
            is_at_failed_end: false,
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
            arm_wait: ArmWait::default(),
            line_wait: LineWait::default(),
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

    /// Returns the next action after the client has disconnected. A run that the client launched ends.
    pub(crate) fn action_after_disconnect(&self, is_suspended: bool) -> NextAction {
        if self.start.is_attach { NextAction::Detach { is_suspended } } else { NextAction::End }
    }

    /// Sends new messages for a page that shows the run.
    pub(crate) fn refresh_view(&mut self, run: &DebuggedRun<'_>) {
        let is_stopped = self.phase == SessionState::Stopped;
        if let Some(messages) = self.subscriptions.refreshed_view(is_stopped, &run.debugger.controller) {
            self.client.custom_event("val3/view", messages);
        }
    }

    /// Sends the events of the run to the client.
    pub fn report(&mut self, events: &[MachineEvent], run: &mut DebuggedRun<'_>) {
        let notices = self.notices.of(events, &mut run.debugger.controller, &self.conventions);
        self.notices.repeat(run.debugger.is_in_past());
        notices.iter().for_each(|notice| self.client.event(notice));
        if has_new_files(&notices) {
            self.place_again(run);
        }
        self.report_ended_data(run);
        for message in run.debugger.take_logged() {
            self.print(message.text + "\n");
        }
        self.note_step_wait(run);
        self.note_arm_wait(run);
        if let Some(note) = self.line_wait.note(&run.debugger.controller) {
            self.print(note);
        }
        self.subscriptions.note(events, &run.debugger.controller);
        for (name, body) in self.subscriptions.changes(events, &run.debugger.controller) {
            self.client.custom_event(name, body);
        }
    }

    /// Shows a text in the debug console.
    fn print(&mut self, output: String) {
        self.client.event(&console_output(output));
    }

    /// Shows the messages of log points after the response to the present request.
    pub(crate) fn follow_log_points(&mut self, run: &mut DebuggedRun<'_>) {
        let messages = run.debugger.take_logged().into_iter();
        self.following.extend(messages.map(|message| console_output(message.text + "\n")));
    }

    /// Notes whether the next cycle repeats a part of the run that was already reported.
    pub(crate) fn note_repetition(&mut self, run: &DebuggedRun<'_>) {
        self.notices.repeat(run.debugger.is_in_past());
    }

    /// Sends samples and messages at the end of a cycle that began at `start`.
    pub fn see(&mut self, start: Time, run: &DebuggedRun<'_>) {
        if self.conventions.knows_progress && self.is_running_to_end() {
            self.end_progress.pass(seconds(start), &mut self.client);
        }
        if let Some(batch) = self.subscriptions.see(start, &run.debugger.controller) {
            self.client.custom_event("val3/motion", batch);
        }
        if let Some(messages) = self.subscriptions.view(start, &run.debugger.controller) {
            self.client.custom_event("val3/view", messages);
        }
    }

    /// Sends the present lines of the breakpoints.
    fn place_again(&mut self, run: &mut DebuggedRun<'_>) {
        self.placed_again(run).into_iter().for_each(|breakpoint| self.breakpoint_changed(breakpoint));
    }

    /// Places all breakpoints once more, and returns them.
    fn placed_again(&mut self, run: &mut DebuggedRun<'_>) -> Vec<protocol::Breakpoint> {
        let placed = self.breakpoints.place_all(run, &self.conventions);
        self.shown_hits.update(&placed);
        placed
    }

    /// Sends the data breakpoints on local variables whose program has ended, or exists again.
    fn report_ended_data(&mut self, run: &DebuggedRun<'_>) {
        let ended = self.breakpoints.ended_data(run.debugger);
        self.shown_hits.update(&ended);
        ended.into_iter().for_each(|breakpoint| self.breakpoint_changed(breakpoint));
    }

    /// Sends the changes of breakpoints at a stop: hit counts, and data that have ended or exist again.
    pub(crate) fn report_hits(&mut self, run: &DebuggedRun<'_>) {
        self.hit_changes(run).iter().for_each(|event| self.client.event(event));
    }

    /// Returns the changes of breakpoints at a stop, like [`report_hits`](Self::report_hits).
    fn hit_changes(&mut self, run: &DebuggedRun<'_>) -> Vec<StandardEvent> {
        let ended = self.breakpoints.ended_data(run.debugger);
        self.shown_hits.update(&ended);
        ended.into_iter().chain(self.shown_hits.changes(run.debugger)).map(changed).collect()
    }

    fn breakpoint_changed(&mut self, breakpoint: protocol::Breakpoint) {
        self.client.event(&changed(breakpoint));
    }

    /// Handles a stop of the run, or of only one task.
    pub fn stop(&mut self, stop: &Stop, run: &mut DebuggedRun<'_>) {
        if self.passes(stop, run) {
            return;
        }
        self.end_run_to_end(run);
        let is_alone = stop.task_alone().is_some_and(|task| run.debugger.is_task_paused(task));
        let event = stop_event::stopped(stop, &mut run.debugger.controller);
        if let Some(text) = event.text.as_ref().filter(|_| matches!(stop, Stop::CallEnded { .. })) {
            self.print(format!("{text}\n"));
        }
        self.report_stop(StoppedEvent { all_threads_stopped: Some(!is_alone), ..event }, run);
    }

    /// Reports a stop of the entire run, or of only one task.
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

    /// Handles the end of the configuration by the client. Later calls have no effect.
    pub(crate) fn finish_configuration(&mut self, run: &mut DebuggedRun<'_>) {
        if !self.is_configured {
            self.configured(run);
        }
    }

    /// Starts the run after its configuration, stops it before its first line, or continues it.
    fn configured(&mut self, run: &mut DebuggedRun<'_>) {
        self.is_configured = true;
        self.breakpoints.apply_errors(run, &self.conventions);
        let controller = &run.debugger.controller;
        let mut notices = self.notices.source_changes(controller, &self.conventions);
        notices.extend(self.notices.task_changes(controller));
        self.following.push(StandardEvent::Process(stop_event::process(controller, self.start.is_attach)));
        self.following.extend(notices);
        self.note_unused_skips(run);
        self.note_variable_filter();
        if self.phase != SessionState::Configuring {
            return;
        }
        self.phase = SessionState::Running;
        (self.is_at_recorded_end, self.is_at_failed_end) = (false, false);
        self.runs_to_end = self.start.settings.starts_at_end && self.run == RunState::Fresh;
        let task = controller.vm.tasks().first().map(|task| task.id);
        match self.run {
            RunState::Fresh if self.start.settings.stops_on_entry && !self.runs_to_end => {
                self.phase = SessionState::Stopped;
                if let Some(task) = task {
                    // A breakpoint on the first line must not stop the task there a second time.
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

    /// Begins to debug an application that was loaded and has not started. After a restart, the client's breakpoints
    /// are placed once more, and the run starts without another `configurationDone`.
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

    /// Shows a text in the debug console as standard error output.
    pub fn say(&mut self, text: &str) {
        self.client.say(text);
    }

    /// Sends an event that is not part of the protocol.
    pub fn tell(&mut self, event: &str, body: serde_json::Value) {
        self.client.custom_event(event, body);
    }

    /// Returns the error that has ended the connection to the client.
    #[must_use]
    pub const fn fault(&self) -> Option<&ReadError> {
        self.client.fault()
    }

    /// Whether the client shows colours that ANSI escape sequences set.
    #[must_use]
    pub const fn shows_colors(&self) -> bool {
        self.conventions.shows_colors
    }

    /// Reports the end of the run.
    pub fn end(&mut self, exit_code: u8) {
        for notice in self.notices.forget_tasks() {
            self.client.event(&notice);
        }
        self.end_progress.end(&mut self.client);
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
                Incoming::End(fault) => self.client.disconnect(fault),
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

fn console_output(output: String) -> StandardEvent {
    let category = Some(OutputEventCategory::Console);
    StandardEvent::Output(OutputEvent { output, category, ..OutputEvent::default() })
}

/// Whether programs were loaded, in which breakpoints may have a line now.
fn has_new_files(notices: &[StandardEvent]) -> bool {
    notices.iter().any(|notice| matches!(notice, StandardEvent::LoadedSource(_)))
}

fn changed(breakpoint: protocol::Breakpoint) -> StandardEvent {
    StandardEvent::Breakpoint(BreakpointEvent { breakpoint, reason: BreakpointEventReason::Changed })
}
