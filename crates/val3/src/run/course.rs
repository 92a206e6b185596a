//! Main loop of a run, from its first cycle to its end.

use std::rc::Rc;
use std::time::{Duration, Instant};

use val3_dap::{DebuggedRun, NextAction, TimeEnd};
use val3_debug::{AdvanceResult, Debugger};
use val3_lang::ports::nanoseconds;
use val3_machine::controller::RunStatus;
use val3_machine::event::{EndReason, EventKind};
use val3_service::ServiceTarget;
use val3_session::{Delay, FrameEvaluator, Pace};
use val3_suite::{Stages, Transition};
use val3_view::wire::Pace as NewPace;

use super::clients::Clients;
use super::end::{End, EndedRun};
use super::export::Export;
use super::guide::{ATTENTION, Guide};
use super::missing::program_text;
use super::motion::MotionObservers;
use super::observers::Observers;
use super::opening::ReadyApplication;
use super::output_errors::OutputErrors;
use super::replay::RunRecording;
use super::result::{ResultRecorder, RunEnd};
use super::silence::Silence;
use super::standby::Standby;
use super::tempo::Tempo;
use super::viewers::Viewers;
use super::{EXIT_BROKEN_OFF, EXIT_LIMIT};
use crate::args::RunArgs;
use crate::modbus::ModbusRun;
use crate::signals::Signals;
use crate::sockets::Announcements;
use crate::test::{DebuggedTest, report};
use crate::user_error::{EXIT_USAGE, UserError};

/// Polling interval for viewers while a debugger is also polled.
const SHARED_ATTENTION: Duration = Duration::from_millis(20);

/// A run with its devices, observers and clients.
pub(super) struct Course<'a> {
    pub(super) args: &'a RunArgs,
    pub(super) debugger: Debugger,
    pub(super) evaluator: FrameEvaluator,
    pub(super) observers: Observers,
    motion: MotionObservers,
    viewers: Option<Viewers>,
    modbus: Option<ModbusRun>,
    clients: Option<Clients>,
    export: Option<Export>,
    result: Option<ResultRecorder>,
    tempo: Tempo,
    silence: Silence,
    announcements: Rc<Announcements>,
    /// Errors of outputs, which [`close`](Self::close) returns.
    errors: OutputErrors,
    /// Debugged test.
    test: Option<Stages>,
    /// Whether the finished test has failed; `None` before its end.
    has_failed_test: Option<bool>,
}

impl<'a> Course<'a> {
    /// Opens the files that the arguments name, so that a run does not begin if a file cannot be written.
    pub(super) fn open(
        args: &'a RunArgs,
        ready: ReadyApplication,
        mut observers: Observers,
    ) -> Result<Self, UserError> {
        if let Some(options) = &ready.options {
            observers.begin(options)?;
        }
        let motion = MotionObservers::open(args, &ready.controller)?;
        let export = args.export.as_deref().map(|path| Export::open(path, &ready.controller)).transpose()?;
        let result = ResultRecorder::open(args)?;
        let modbus = ModbusRun::open(args, &ready.application, &ready.controller)?;
        let tempo = Tempo::new(pace(args, &observers), ready.controller.now());
        let debugger = Debugger::new(ready.controller);
        let evaluator = FrameEvaluator::new(ready.application);
        Ok(Self {
            args,
            debugger,
            evaluator,
            observers,
            motion,
            viewers: None,
            modbus,
            clients: None,
            export,
            result,
            tempo,
            silence: Silence::new(Instant::now()),
            announcements: ready.announcements,
            errors: OutputErrors::default(),
            test: ready.test,
            has_failed_test: None,
        })
    }

    /// Adds viewers, which may have chosen a pace in an earlier run.
    pub(super) fn serve(&mut self, viewers: Viewers) {
        let pace = NewPace { is_paused: None, speed: viewers.speed() };
        self.tempo.change(&pace, self.debugger.controller.now());
        self.viewers = Some(viewers);
    }

    /// Adds clients of the controller. Then the run continues after the end of its application.
    pub(super) fn attend_clients(&mut self, clients: Clients) {
        self.clients = Some(clients);
    }

    /// Runs the controller until the run ends, and sends all events to the observers and the debug client.
    pub(super) fn run(&mut self, guide: &mut dyn Guide, signals: &Signals) -> End {
        self.debugger.controller.devices.interrupt = signals.flag();
        let end = self.run_cycles(guide, signals);
        let end = self.errors.collect(end).unwrap_or(End::Unwritten);
        self.debugger.controller.break_off();
        if self.test.is_none() {
            self.debugger.controller.write_files();
        }
        self.record_end(end, guide);
        end
    }

    fn run_cycles(&mut self, guide: &mut dyn Guide, signals: &Signals) -> Result<End, UserError> {
        self.tempo.restart_clock(self.debugger.controller.now());
        loop {
            let action = guide.attend(&mut self.target());
            self.tempo.set_debugger_stop(action == NextAction::Wait);
            match action {
                NextAction::Run | NextAction::Detach { .. } => {}
                NextAction::Wait => {
                    if let Some(end) = self.broken_off(signals)? {
                        break Ok(end);
                    }
                    self.wait_for_outside(guide);
                    continue;
                }
                NextAction::Restart => break Ok(End::Restart),
                NextAction::End => break Ok(End::Left),
            }
            if self.tempo.is_stopped() {
                if let Some(end) = self.broken_off(signals)? {
                    break Ok(end);
                }
                self.wait_for_outside(guide);
                continue;
            }
            let Some(status) = self.advance(guide)? else { continue };
            self.tempo.end_cycle();
            match self.follow_test() {
                Transition::None => {}
                Transition::Started => continue,
                Transition::Over => break Ok(End::Controller(RunStatus::Finished)),
            }
            if self.ends_with(status) {
                if self.stop_at_end(status, guide) {
                    continue;
                }
                break Ok(End::Controller(status));
            }
            if let Some(end) = self.broken_off(signals)? {
                break Ok(end);
            }
            if self.tempo.pace.keeps_time(&self.debugger.controller) {
                self.observers.flush(self.debugger.controller.now())?;
            }
            let Some(delay) = self.next(status) else {
                if self.stop_at_end(RunStatus::Stuck, guide) {
                    continue;
                }
                break Ok(End::Controller(RunStatus::Stuck));
            };
            self.note_waits(guide);
            let time = self.tempo.wait_time(delay);
            self.wait(time, guide);
            if let Some(end) = self.end_of_time() {
                let time = if matches!(end, End::Recorded(_)) { TimeEnd::Recording } else { TimeEnd::Limit };
                if guide.session().is_some_and(|session| session.stop_at_time(time, &mut self.target())) {
                    continue;
                }
                break Ok(end);
            }
        }
    }

    /// Whether a status ends the run. A controller with clients remains after the end of its application.
    fn ends_with(&self, status: RunStatus) -> bool {
        match status {
            RunStatus::Finished | RunStatus::Stopped => self.clients.is_none(),
            RunStatus::Unsupported => true,
            _ => false,
        }
    }

    /// Waits for this time, or until a debugger or a client sends a request.
    fn wait(&mut self, time: Duration, guide: &mut dyn Guide) {
        match &mut self.clients {
            _ if time.is_zero() => {}
            Some(clients) => {
                let (debugger, evaluator) = (&mut self.debugger, &mut self.evaluator);
                clients.wait(time, ServiceTarget { debugger, evaluator });
            }
            None => guide.wait(time),
        }
    }

    /// Lets the debugger stop a run that would end with this status. Returns `false` if the run ends.
    fn stop_at_end(&mut self, status: RunStatus, guide: &mut dyn Guide) -> bool {
        if let (RunStatus::Stuck, Some(session)) = (status, guide.session()) {
            self.observers.compare_stuck();
            self.observers.take_difference().into_iter().for_each(|difference| session.say(&format!("{difference}\n")));
        }
        guide.session().is_some_and(|session| session.stop_at_end(status, &mut self.target()))
    }

    /// Explains why time is real and where tasks wait, unless the controller or a debugger is visible to the user.
    fn note_waits(&mut self, guide: &mut dyn Guide) {
        let has_clients = self.viewers.is_some() || self.clients.is_some();
        if self.observers.is_live() || has_clients || guide.session().is_some() {
            return;
        }
        let controller = &self.debugger.controller;
        if !self.tempo.pace.real_time
            && let Some(note) = self.silence.note_on_time(controller)
        {
            self.observers.console().note(&note);
        }
        if let Some(head) = self.silence.note_on_waits(Instant::now(), controller) {
            self.observers.console().list_waits(&head, controller);
        }
    }

    /// Starts the next program of a debugged test when the current program has ended.
    fn follow_test(&mut self) -> Transition {
        let Some(test) = &mut self.test else { return Transition::None };
        let transition = test.follow(&mut self.debugger.controller);
        if transition == Transition::Started {
            // Replaying an earlier state would not start the program.
            self.debugger.forget_past();
        }
        transition
    }

    /// Advances the clock to the next possible event, or to a cycle that a debugged test must process. `None` if no
    /// event is possible.
    fn next(&mut self, status: RunStatus) -> Option<Delay> {
        let due = self.test.as_ref().and_then(Stages::next_due);
        let pace = Pace { until: self.tempo.pace.until.into_iter().chain(due).min(), ..self.tempo.pace };
        let debugger = &mut self.debugger;
        match status {
            // Only the client can continue individually paused tasks.
            RunStatus::Waiting(None) | RunStatus::Stuck if !debugger.paused_tasks().is_empty() => {
                Some(Delay::For(ATTENTION))
            }
            RunStatus::Waiting(wake) => pace.wait(&mut debugger.controller, wake),
            RunStatus::Stuck | RunStatus::Finished | RunStatus::Stopped => {
                pace.wait_for_operator(&mut debugger.controller)
            }
            _ => Some(pace.follow(&debugger.controller)),
        }
    }

    /// Returns the run for a debug session.
    pub(super) fn target(&mut self) -> DebuggedRun<'_> {
        DebuggedRun { debugger: &mut self.debugger, evaluator: &mut self.evaluator, files: program_text }
    }

    /// Runs to the end of a cycle; `None` if the debugger has stopped the run or if the cycle is not complete.
    fn advance(&mut self, guide: &mut dyn Guide) -> Result<Option<RunStatus>, UserError> {
        let start = self.debugger.controller.now();
        if guide.session().is_some_and(|session| !session.is_running_to_end()) {
            self.observers.end_comparison();
        }
        // Stepping back removes the limit.
        self.debugger.controller.set_limit(self.tempo.pace.until);
        if let Some(modbus) = &mut self.modbus {
            modbus.deliver(&mut self.debugger.controller);
        }
        let progress = self.debugger.advance();
        self.motion.see(start, &self.debugger.controller)?;
        let events = self.debugger.controller.devices.take_events();
        self.motion.follow(start, &events, &self.debugger.controller);
        if let Some(result) = &mut self.result {
            result.follow(&events);
        }
        self.observers.notify(&events)?;
        self.observers.find_causes(&events, &mut self.debugger.controller);
        if events.iter().any(|event| is_shown(&event.kind)) {
            self.silence.see_output(Instant::now());
        }
        if let Some(test) = &mut self.test {
            test.see_part(start, &events, &self.debugger.controller);
        }
        if let Some(viewers) = &mut self.viewers {
            viewers.see(start, &events, &self.debugger.controller);
        }
        if let Some(export) = &mut self.export {
            export.see(start, &events, &self.debugger.controller)?;
        }
        if let Some(session) = guide.session() {
            self.announcements.take_texts().iter().for_each(|text| session.say(text));
            session.report(&events, &mut self.target());
            session.see(start, &self.target());
            if let Some(difference) = self.observers.take_difference() {
                session.say(&format!("{difference}\n"));
                self.debugger.pause(None);
            }
        }
        match progress {
            AdvanceResult::Stopped(stop) => {
                if let Some(viewers) = &mut self.viewers {
                    viewers.see_rest(&self.debugger.controller);
                }
                if let Some(session) = guide.session() {
                    session.stop(&stop, &mut self.target());
                }
                self.observers.flush(self.debugger.controller.now())?;
                Ok(None)
            }
            AdvanceResult::Ran(status) if status.is_within_cycle() && status != RunStatus::Limit => Ok(None),
            AdvanceResult::Ran(status) => {
                if let Some(modbus) = &self.modbus {
                    modbus.publish(&self.debugger.controller);
                }
                Ok(Some(status))
            }
        }
    }

    /// Waits for a request or a command while the controller's clock is stopped.
    fn wait_for_outside(&mut self, guide: &mut dyn Guide) {
        match &mut self.viewers {
            _ if self.clients.is_some() => self.wait(SHARED_ATTENTION, guide),
            Some(viewers) if self.args.debug_port.is_none() => viewers.wait(ATTENTION),
            Some(_) => guide.wait(SHARED_ATTENTION),
            None => guide.wait(ATTENTION),
        }
        self.tempo.restart_clock(self.debugger.controller.now());
    }

    /// Executes viewer commands. Returns the end caused by the operator, by a signal, or by a closed output.
    fn broken_off(&mut self, signals: &Signals) -> Result<Option<End>, UserError> {
        if let Some(viewers) = &mut self.viewers {
            viewers.attend(&mut self.debugger.controller, &mut self.tempo);
        }
        if let Some(clients) = &mut self.clients {
            clients.attend(ServiceTarget { debugger: &mut self.debugger, evaluator: &mut self.evaluator });
        }
        let wish = self.observers.attend(&mut self.debugger.controller)?;
        Ok(match () {
            () if wish.is_break() => Some(End::BrokenOff(EXIT_BROKEN_OFF)),
            () if self.observers.has_left() => Some(End::Unread),
            () => signals.exit_code().map(End::BrokenOff),
        })
    }

    /// Returns the end of a run that has reached its time limit.
    fn end_of_time(&self) -> Option<End> {
        let now = self.debugger.controller.now();
        match self.observers.recording() {
            _ if self.args.until.is_some_and(|until| now >= nanoseconds(until)) => {
                Some(End::Controller(RunStatus::Limit))
            }
            Some(recording) if recording.is_over(now) => Some(End::Recorded(recording.reason())),
            _ => None,
        }
    }

    /// Sends the last events to all observers.
    fn record_end(&mut self, end: End, guide: &mut dyn Guide) {
        let controller = &mut self.debugger.controller;
        controller.report_unmet_reactions();
        controller.end_encounters();
        match end {
            End::Controller(RunStatus::Stuck) => controller.record_stuck_tasks(),
            End::Controller(RunStatus::Finished) if self.test.is_none() && self.has_failed_test.is_none() => {
                controller.record_dropped_moves();
            }
            _ => {}
        }
        controller.devices.record_outside(controller.now(), EventKind::End { reason: reason(end) });
        let events = controller.devices.take_events();
        if let Some(session) = guide.session() {
            session.report(&events, &mut self.target());
        }
        let reported = self.report_test(end, guide);
        self.errors.collect(reported);
        self.errors.collect(self.observers.notify_end(end, &events));
        if let Some(result) = &mut self.result {
            result.follow(&events);
        }
        let code = self.exit_code(end);
        if let Some(viewers) = &mut self.viewers {
            viewers.see_end(&events, reason(end), code, &self.debugger.controller);
        }
        if let Some(export) = &mut self.export {
            self.errors.collect(export.see_end(&events, reason(end), code, &self.debugger.controller));
        }
    }

    /// Sends the result of a debugged test to the client, unless the test was aborted.
    fn report_test(&mut self, end: End, guide: &mut dyn Guide) -> Result<(), UserError> {
        let test = self.test.take().filter(|_| matches!(end, End::Controller(_)));
        let (Some(test), Some(session)) = (test, guide.session()) else { return Ok(()) };
        let (case, result) = (test.case.clone(), test.result(&self.debugger.controller));
        let DebuggedTest { has_passed, text, object } = report(&case, result)?;
        self.has_failed_test = Some(!has_passed);
        session.say(&text);
        session.tell("val3/testResult", object);
        Ok(())
    }

    /// Exit code for an end.
    pub(super) fn exit_code(&self, end: End) -> u8 {
        let observers = &self.observers;
        let has_failed = observers.has_unhandled_errors() || observers.has_diverged() || observers.has_contacts();
        match end {
            End::BrokenOff(code) => code,
            End::Unread | End::Left | End::Restart => 0,
            End::Unwritten => EXIT_USAGE,
            End::Controller(_) if let Some(has_failed) = self.has_failed_test => u8::from(has_failed),
            End::Controller(RunStatus::Stuck | RunStatus::Unsupported) => 1,
            _ if has_failed => 1,
            End::Controller(RunStatus::Limit) | End::Recorded(_) if self.debugger.controller.has_failed_tasks() => 1,
            End::Controller(RunStatus::Limit) if !self.args.until_ok => EXIT_LIMIT,
            End::Controller(_) | End::Recorded(_) => 0,
        }
    }

    /// Writes the reports at the end of a run, and explains the end. Returns the served run, unless its server ends with
    /// it. Each output is written even if another one cannot be written.
    pub(super) fn close(self, end: End) -> Result<Option<EndedRun>, UserError> {
        let code = self.exit_code(end);
        let (args, mut controller) = (self.args, self.debugger.controller);
        let mut errors = self.errors;
        let console = self.observers.close(&mut errors);
        let pendant = &controller.devices.state.pendant;
        match args.screen {
            true => errors.collect(console.page(pendant)),
            false if !args.follows_wall() => errors.collect(console.mention_page(pendant)),
            // The page was already visible in a terminal, browser or editor.
            false => None,
        };
        console.explain(end, args, &controller);
        let times = self.motion.close(controller.now(), &mut errors);
        if let Some((result, times)) = self.result.zip(times) {
            let code = if errors.is_empty() { code } else { EXIT_USAGE };
            let run = RunEnd { end, code, controller: &controller, console: &console, times: &times };
            result.close(&run, &mut errors);
        }
        errors.collect(self.export.map_or(Ok(()), Export::close));
        let Some(viewers) = self.viewers else { return errors.into_result().map(|()| None) };
        if matches!(end, End::BrokenOff(_) | End::Left) {
            viewers.rescue(&mut controller);
            return errors.into_result().map(|()| None);
        }
        errors.into_result()?;
        Ok(Some(EndedRun { viewers, standby: Standby::new(controller, self.tempo, end) }))
    }
}

/// Pace according to the arguments. With an operator, time is real.
fn pace(args: &RunArgs, observers: &Observers) -> Pace {
    let recorded = observers.recording().and_then(RunRecording::limit);
    let until = args.until.map(nanoseconds).into_iter().chain(recorded).min();
    Pace { real_time: args.follows_wall(), until, attended: args.is_attended() }
}

/// Whether an event is displayed at a terminal.
fn is_shown(event: &EventKind) -> bool {
    use EventKind::{Log, Notice, Popup, Print};
    matches!(event, Print { .. } | Log { .. } | Popup { .. } | Notice { .. })
}

/// Reason of the end for the event record.
fn reason(end: End) -> EndReason {
    match end {
        End::Controller(status) => status.into(),
        End::Recorded(reason) => reason,
        End::Unread | End::Unwritten | End::Left | End::Restart | End::BrokenOff(_) => RunStatus::Stopped.into(),
    }
}
