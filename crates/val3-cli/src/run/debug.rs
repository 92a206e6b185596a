//! A run that a client debugs.

use std::process::ExitCode;
use std::time::{Duration, Instant};

use val3_dap::{DebugSession, Demand, Target};
use val3_debug::{Debugger, PastLimits, Progress};
use val3_lang::ports::nanoseconds;
use val3_machine::controller::Outcome;
use val3_machine::event::EventKind;
use val3_session::{Delay, FrameEvaluator, Pace};

use super::EXIT_LIMIT;
use super::failures::Failures;
use super::motion::MotionObservers;
use super::opening::{OpenedApplication, ReadyApplication, open};
use super::record::Record;
use crate::args::RunArgs;
use crate::dap::text;
use crate::user_error::{EXIT_USAGE, UserError};

/// How long the client is waited for while every task is paused by hand.
const IDLE: Duration = Duration::from_millis(10);

/// How a debugged run has ended.
enum DebugEnd {
    /// By itself, with this exit code.
    Over(u8),
    /// The client has ended it.
    Ended,
    /// The client wants it from the beginning.
    Restart,
}

/// Runs an application until it has ended or the client leaves; again if the client wants to.
pub(crate) fn debug(
    mut session: DebugSession,
    args: &RunArgs,
    ready: ReadyApplication,
    is_plain_run: bool,
) -> ExitCode {
    let mut next = Some(ready);
    let mut is_first = true;
    while let Some(ready) = next.take() {
        let end = run(&mut session, args, ready, (is_plain_run, is_first)).unwrap_or_else(|error| {
            session.say(&format!("{error}\n"));
            DebugEnd::Over(EXIT_USAGE)
        });
        is_first = false;
        match end {
            DebugEnd::Ended => return ExitCode::SUCCESS,
            DebugEnd::Over(code) if !session.finish(code) => return ExitCode::from(code),
            DebugEnd::Over(_) | DebugEnd::Restart => {}
        }
        let mut shown = String::new();
        match open(args, &mut |write| shown.push_str(&text(write))) {
            Ok(OpenedApplication::Ready(ready)) => next = Some(*ready),
            Ok(OpenedApplication::Faulty(_)) => {}
            Err(error) => shown.push_str(&format!("{error}\n")),
        }
        if !shown.is_empty() {
            session.say(&shown);
        }
    }
    session.finish(1);
    ExitCode::FAILURE
}

fn run(
    session: &mut DebugSession,
    args: &RunArgs,
    ready: ReadyApplication,
    (is_plain_run, is_first): (bool, bool),
) -> Result<DebugEnd, UserError> {
    let mut debugger = Debugger::new(ready.controller);
    let mut evaluator = FrameEvaluator::new(ready.application);
    if !is_plain_run {
        debugger.record(PastLimits::default());
    }
    if let Some(mode) = session.motion_mode().filter(|_| !is_plain_run) {
        debugger.set_motion_mode(mode);
    }
    let mut record = Record::open(args.events.as_deref())?;
    let mut motion = MotionObservers::open(args, &debugger.controller)?;
    let mut failures = Failures::default();
    let pace = Pace { real_time: args.follows_wall(), until: args.until.map(nanoseconds), attended: false };
    if !is_first {
        session.restarted(&mut Target { debugger: &mut debugger, evaluator: &mut evaluator });
    }
    let mut started = Instant::now();
    let mut is_attended = true;
    let end = loop {
        let mut target = Target { debugger: &mut debugger, evaluator: &mut evaluator };
        if is_attended {
            match session.attend(&mut target) {
                Demand::Run => {}
                Demand::Wait => {
                    session.wait();
                    // Time has stood still.
                    let elapsed = Duration::from_nanos(debugger.controller.now());
                    started = Instant::now().checked_sub(elapsed).unwrap_or_else(Instant::now);
                    continue;
                }
                Demand::Restart => break DebugEnd::Restart,
                Demand::End => break DebugEnd::Ended,
                Demand::Release => is_attended = false,
            }
        }
        target.debugger.controller.set_limit(pace.until);
        let start = target.debugger.controller.now();
        let progress = target.debugger.advance();
        motion.see(start, &target.debugger.controller)?;
        let events = target.debugger.controller.devices.take_events();
        for event in &events {
            record.write(event)?;
            failures.follow(event);
        }
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
        let delay = match outcome {
            Outcome::Finished | Outcome::Stopped | Outcome::Lacking | Outcome::Limit => None,
            // Only the client lets paused tasks continue.
            Outcome::Waiting(None) | Outcome::Stuck if !debugger.paused_tasks().is_empty() => Some(Delay::For(IDLE)),
            Outcome::Waiting(wake) => pace.wait(&mut debugger.controller, wake),
            Outcome::Stuck => pace.wait_for_operator(&mut debugger.controller),
            _ => Some(pace.follow(&debugger.controller)),
        };
        let is_late = args.until.is_some_and(|until| debugger.controller.now() >= nanoseconds(until));
        match delay {
            None => break DebugEnd::Over(exit_code(args, outcome, &failures)),
            Some(_) if is_late => break DebugEnd::Over(exit_code(args, Outcome::Limit, &failures)),
            Some(Delay::None) => {}
            Some(Delay::For(time)) => session.wait_for(time),
            Some(Delay::Until(time)) => {
                let due = started + Duration::from_nanos(time);
                session.wait_for(due.saturating_duration_since(Instant::now()));
            }
        }
    };
    debugger.controller.break_off();
    let reason = if matches!(end, DebugEnd::Over(0)) { Outcome::Finished } else { Outcome::Stopped };
    debugger.controller.devices.record_outside(debugger.controller.now(), EventKind::End { reason: reason.into() });
    for event in debugger.controller.devices.take_events() {
        record.write(&event)?;
    }
    record.flush()?;
    motion.close()?;
    Ok(end)
}

/// The exit code of `val3 run` for the same end.
fn exit_code(args: &RunArgs, outcome: Outcome, failures: &Failures) -> u8 {
    match outcome {
        Outcome::Finished | Outcome::Stopped if failures.is_empty() => 0,
        Outcome::Limit if failures.is_empty() && args.until_ok => 0,
        Outcome::Limit if failures.is_empty() => EXIT_LIMIT,
        _ => 1,
    }
}
