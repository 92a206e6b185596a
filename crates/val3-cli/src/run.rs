//! `val3 run`: an application on the embedded controller.

mod console;
mod debug;
mod end;
mod ending;
mod failures;
mod live;
mod missing;
mod motion;
mod observers;
mod opening;
mod outside;
mod record;
mod replay;
mod signals;
mod source_line;

use std::process::ExitCode;
use std::time::Instant;

use val3_lang::ports::nanoseconds;
use val3_machine::controller::{Controller, Outcome};
use val3_machine::event::{EndReason, Event, EventKind};
use val3_session::{Delay, Pace};

use crate::args::RunArgs;
use crate::color::Color;
use crate::output::to_stderr_in_color;
use crate::user_error::UserError;
use crate::wall_clock;
pub(crate) use debug::{DebugSettings, debug};
pub(crate) use opening::{OpenedApplication, ReadyApplication, open};

use end::End;
use motion::MotionObservers;
use observers::Observers;
use record::Record;
use replay::Recording;
use signals::Signals;

/// Exit code of a run that `--until` has ended.
const EXIT_LIMIT: u8 = 3;

/// Exit code of a run that the operator has broken off, as shells give it for Ctrl-C.
const EXIT_BROKEN_OFF: u8 = 130;

/// Runs the command.
pub(crate) fn run(args: &RunArgs, color: Color) -> Result<ExitCode, UserError> {
    if args.interactive {
        live::check_terminal(args.events.as_ref().is_some_and(|events| events == "-"))?;
    }
    let recording = args.replay.as_deref().map(Recording::open).transpose()?;
    let mut controller = match open(args, &mut |write| to_stderr_in_color(color, write))? {
        OpenedApplication::Ready(opened) => opened.controller,
        OpenedApplication::Faulty(code) => return refuse(args, code),
    };
    let mut observers = Observers::open(args, recording, color)?;
    let mut motion = MotionObservers::open(args, &controller)?;
    let end = until_the_end(args, &mut controller, &mut observers, &mut motion)?;
    let exit_code = exit_code(args, end, &controller, &observers);
    let console = observers.close()?;
    if args.screen {
        console.page(&controller.devices.state.pendant)?;
    }
    console.explain(end, args, &controller);
    motion.close()?;
    Ok(exit_code)
}

/// The record of a run that has not begun consists of its end.
fn refuse(args: &RunArgs, code: ExitCode) -> Result<ExitCode, UserError> {
    let mut record = Record::open(args.events.as_deref())?;
    record.write(&Event { t: 0.0, task: None, kind: EventKind::End { reason: Outcome::Refused.into() } })?;
    record.flush()?;
    Ok(code)
}

fn exit_code(args: &RunArgs, end: End, controller: &Controller, observers: &Observers) -> ExitCode {
    let has_failed = observers.has_unhandled_errors() || observers.has_diverged();
    match end {
        End::BrokenOff(code) => ExitCode::from(code),
        End::Unread => ExitCode::SUCCESS,
        End::Controller(Outcome::Stuck | Outcome::Lacking) => ExitCode::FAILURE,
        _ if has_failed => ExitCode::FAILURE,
        End::Controller(Outcome::Limit) | End::Recorded(_) if controller.has_failed_tasks() => ExitCode::FAILURE,
        End::Controller(Outcome::Limit) if !args.until_ok => ExitCode::from(EXIT_LIMIT),
        End::Controller(_) | End::Recorded(_) => ExitCode::SUCCESS,
    }
}

/// Runs the controller until the run ends, and passes all events to the observers.
fn until_the_end(
    args: &RunArgs,
    controller: &mut Controller,
    observers: &mut Observers,
    motion: &mut MotionObservers,
) -> Result<End, UserError> {
    let (pace, signals) = (pace(args, observers), Signals::catch()?);
    let started = pace.real_time.then(Instant::now);
    controller.devices.interrupt = signals.flag();
    controller.set_limit(pace.until);
    let end = loop {
        let start = controller.now();
        let outcome = controller.step();
        motion.see(start, controller)?;
        observers.notify(&controller.devices.take_events())?;
        let wish = observers.attend(controller)?;
        let end = match outcome {
            Outcome::Finished | Outcome::Stopped | Outcome::Lacking => Some(End::Controller(outcome)),
            _ if wish.is_break() => Some(End::BrokenOff(EXIT_BROKEN_OFF)),
            _ if observers.has_left() => Some(End::Unread),
            _ => signals.exit_code().map(End::BrokenOff),
        };
        if pace.keeps_time(controller) {
            observers.flush(controller.now())?;
        }
        if let Some(end) = end {
            break end;
        }
        let delay = next(&pace, controller, outcome);
        if let Some(delay) = delay {
            wall_clock::wait(delay, started);
        }
        if let Some(end) = end_after(args, delay, controller, observers) {
            break end;
        }
    };
    controller.break_off();
    if end == End::Controller(Outcome::Stuck) {
        controller.record_stuck_tasks();
    }
    controller.devices.record_outside(controller.now(), EventKind::End { reason: reason(end) });
    observers.notify_end(end, &controller.devices.take_events())?;
    Ok(end)
}

/// The reason of the end for the record.
fn reason(end: End) -> EndReason {
    match end {
        End::Controller(outcome) => outcome.into(),
        End::Recorded(reason) => reason,
        End::Unread | End::BrokenOff(_) => Outcome::Stopped.into(),
    }
}

/// The pace that the arguments ask for. An operator needs real time.
fn pace(args: &RunArgs, observers: &Observers) -> Pace {
    let recorded = observers.recording().and_then(Recording::limit);
    let until = args.until.map(nanoseconds).into_iter().chain(recorded).min();
    Pace { real_time: args.follows_wall(), until, attended: args.interactive }
}

/// Advances the clock until something can happen. `None` if nothing can.
fn next(pace: &Pace, controller: &mut Controller, outcome: Outcome) -> Option<Delay> {
    match outcome {
        Outcome::Waiting(wake) => pace.wait(controller, wake),
        Outcome::Stuck => pace.wait_for_operator(controller),
        _ => Some(pace.follow(controller)),
    }
}

/// The end of the run after a wait, if it ends.
fn end_after(args: &RunArgs, delay: Option<Delay>, controller: &Controller, observers: &Observers) -> Option<End> {
    let now = controller.now();
    match observers.recording() {
        _ if delay.is_none() => Some(End::Controller(Outcome::Stuck)),
        _ if args.until.is_some_and(|until| now >= nanoseconds(until)) => Some(End::Controller(Outcome::Limit)),
        Some(recording) if recording.is_over(now) => Some(End::Recorded(recording.reason())),
        _ => None,
    }
}
