//! A run that a client debugs.

use std::process::ExitCode;
use std::time::{Duration, Instant};

use val3_dap::{DebugSession, Demand, Target};
use val3_debug::{Debugger, PastLimits, Progress};
use val3_lang::ports::{Time, nanoseconds};
use val3_machine::arm::MotionMode;
use val3_machine::controller::{Controller, Outcome};
use val3_machine::event::{Event, EventKind};
use val3_session::{Delay, FrameEvaluator, Pace};

use super::EXIT_LIMIT;
use super::failures::Failures;
use super::motion::MotionObservers;
use super::opening::{OpenedApplication, ReadyApplication, open};
use super::record::Record;
use crate::args::RunArgs;
use crate::dap::text;
use crate::user_error::{EXIT_USAGE, UserError};

/// The time to wait for the client while every task is paused by hand.
const IDLE: Duration = Duration::from_millis(10);

/// The settings of a launch configuration that `val3 run` does not have.
#[derive(Debug, Clone, Copy)]
pub(crate) struct DebugSettings {
    /// The mode of the motion at the beginning.
    pub(crate) motion_mode: MotionMode,
    /// Nothing stops the run, and it has no past.
    pub(crate) is_plain_run: bool,
}

/// How a debugged run has ended.
enum DebugEnd {
    /// By itself, with this exit code.
    Over(u8),
    /// The client has ended it.
    Ended,
    /// The client wants it from the beginning.
    Restart,
}

/// Runs an application until it has ended and the client has left; again if the client wants to.
pub(crate) fn debug(
    mut session: DebugSession,
    args: &RunArgs,
    settings: DebugSettings,
    ready: ReadyApplication,
) -> ExitCode {
    let mut end = run(&mut session, args, settings, ready, true);
    loop {
        match end.unwrap_or_else(|error| refused(&mut session, &error)) {
            DebugEnd::Ended => return ExitCode::SUCCESS,
            DebugEnd::Over(code) if !session.finish(code) => return ExitCode::from(code),
            DebugEnd::Over(_) | DebugEnd::Restart => {}
        }
        end = match reopen(&mut session, args) {
            Some(ready) => run(&mut session, args, settings, ready, false),
            None => Ok(DebugEnd::Over(1)),
        };
    }
}

fn refused(session: &mut DebugSession, error: &UserError) -> DebugEnd {
    session.say(&format!("{error}\n"));
    DebugEnd::Over(EXIT_USAGE)
}

/// Opens the application again, with its files as they are now. The client learns why that fails.
fn reopen(session: &mut DebugSession, args: &RunArgs) -> Option<ReadyApplication> {
    let mut shown = String::new();
    let opened = open(args, &mut |write| shown.push_str(&text(write)));
    if !shown.is_empty() {
        session.say(&shown);
    }
    match opened {
        Ok(OpenedApplication::Ready(ready)) => Some(*ready),
        Ok(OpenedApplication::Faulty(_)) => None,
        Err(error) => {
            session.say(&format!("{error}\n"));
            None
        }
    }
}

fn run(
    session: &mut DebugSession,
    args: &RunArgs,
    settings: DebugSettings,
    ready: ReadyApplication,
    is_first: bool,
) -> Result<DebugEnd, UserError> {
    let mut debugger = Debugger::new(ready.controller);
    let mut evaluator = FrameEvaluator::new(ready.application);
    if !settings.is_plain_run {
        debugger.record(PastLimits::default());
        debugger.set_motion_mode(settings.motion_mode);
    }
    let mut files = Files::open(args, &debugger.controller)?;
    if !is_first {
        session.restarted(&mut Target { debugger: &mut debugger, evaluator: &mut evaluator });
    }
    let pace = Pace { real_time: args.follows_wall(), until: args.until.map(nanoseconds), attended: false };
    let mut started = Instant::now();
    let end = loop {
        let mut target = Target { debugger: &mut debugger, evaluator: &mut evaluator };
        match session.attend(&mut target) {
            Demand::Run => {}
            Demand::Wait => {
                session.wait();
                // The clock of the controller stands still while the run is stopped.
                let elapsed = Duration::from_nanos(debugger.controller.now());
                started = Instant::now().checked_sub(elapsed).unwrap_or_else(Instant::now);
                continue;
            }
            Demand::Restart => break DebugEnd::Restart,
            Demand::End => break DebugEnd::Ended,
        }
        // Going back has removed the limit.
        target.debugger.controller.set_limit(pace.until);
        let start = target.debugger.controller.now();
        let progress = target.debugger.advance();
        let events = target.debugger.controller.devices.take_events();
        files.see(start, &events, &target.debugger.controller)?;
        session.report(&events, &mut target);
        session.see(start, &target);
        let outcome = match progress {
            Progress::Stopped(stop) => {
                session.stop(&stop, &target);
                continue;
            }
            Progress::Ran(outcome) if outcome.is_within_cycle() && outcome != Outcome::Limit => continue,
            Progress::Ran(outcome) => outcome,
        };
        match delay(&pace, &mut debugger, outcome) {
            None => break DebugEnd::Over(files.exit_code(args, outcome)),
            Some(_) if pace.until.is_some_and(|until| debugger.controller.now() >= until) => {
                break DebugEnd::Over(files.exit_code(args, Outcome::Limit));
            }
            Some(Delay::None) => {}
            Some(Delay::For(time)) => session.wait_for(time),
            Some(Delay::Until(time)) => {
                let due = started + Duration::from_nanos(time);
                session.wait_for(due.saturating_duration_since(Instant::now()));
            }
        }
    };
    files.close(&mut debugger.controller)?;
    Ok(end)
}

/// The wait after a cycle; none if the run is over.
fn delay(pace: &Pace, debugger: &mut Debugger, outcome: Outcome) -> Option<Delay> {
    match outcome {
        Outcome::Finished | Outcome::Stopped | Outcome::Lacking | Outcome::Limit => None,
        // Only the client lets paused tasks continue.
        Outcome::Waiting(None) | Outcome::Stuck if !debugger.paused_tasks().is_empty() => Some(Delay::For(IDLE)),
        Outcome::Waiting(wake) => pace.wait(&mut debugger.controller, wake),
        Outcome::Stuck => pace.wait_for_operator(&mut debugger.controller),
        _ => Some(pace.follow(&debugger.controller)),
    }
}

/// The files that the arguments ask for, and the errors that decide about the exit code.
struct Files {
    record: Record,
    motion: MotionObservers,
    failures: Failures,
    /// The outcome with which the run has ended by itself.
    outcome: Option<Outcome>,
}

impl Files {
    fn open(args: &RunArgs, controller: &Controller) -> Result<Self, UserError> {
        let record = Record::open(args.events.as_deref())?;
        let motion = MotionObservers::open(args, controller)?;
        Ok(Self { record, motion, failures: Failures::default(), outcome: None })
    }

    /// A cycle that began at `start` is over.
    fn see(&mut self, start: Time, events: &[Event], controller: &Controller) -> Result<(), UserError> {
        self.motion.see(start, controller)?;
        events.iter().try_for_each(|event| {
            self.failures.follow(event);
            self.record.write(event)
        })
    }

    /// The run has ended by itself: the exit code that `val3 run` has for this end.
    fn exit_code(&mut self, args: &RunArgs, outcome: Outcome) -> u8 {
        self.outcome = Some(outcome);
        match outcome {
            Outcome::Finished | Outcome::Stopped if self.failures.is_empty() => 0,
            Outcome::Limit if self.failures.is_empty() && args.until_ok => 0,
            Outcome::Limit if self.failures.is_empty() => EXIT_LIMIT,
            _ => 1,
        }
    }

    /// Writes the end of the run.
    fn close(mut self, controller: &mut Controller) -> Result<(), UserError> {
        controller.break_off();
        if self.outcome == Some(Outcome::Stuck) {
            controller.record_stuck_tasks();
        }
        let reason = self.outcome.unwrap_or(Outcome::Stopped).into();
        controller.devices.record_outside(controller.now(), EventKind::End { reason });
        controller.devices.take_events().iter().try_for_each(|event| self.record.write(event))?;
        self.record.flush()?;
        self.motion.close()
    }
}
