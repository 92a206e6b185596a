//! `val3 run`: an application on the embedded controller.

mod audience;
mod console;
mod live;
mod opening;
mod outside;
mod record;
mod signals;

use std::process::ExitCode;
use std::time::Instant;

use val3_lang::ports::nanoseconds;
use val3_machine::controller::{Controller, Step};
use val3_machine::event::{EndReason, What};

use crate::application::Pace;
use crate::args::{Color, RunArgs};
use crate::user_error::UserError;
use audience::Audience;
use console::Console;
use live::Wish;
use opening::Opened;
use signals::Signals;

/// Exit code of a run that `--until` has ended.
const EXIT_LIMIT: u8 = 3;

/// Exit code of a run that the operator has broken off, as shells give it for Ctrl-C.
const EXIT_BROKEN_OFF: u8 = 130;

/// How a run has ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum End {
    /// The application has ended.
    Finished,
    /// No task can go on.
    Stuck,
    /// An instruction is not there.
    Lacking,
    /// `--until`
    Limit,
    /// Nobody reads what it writes any more.
    Unread,
    /// The operator did not want to wait for `stop`, or a signal came. With the exit code.
    BrokenOff(u8),
}

/// Runs the command.
pub(crate) fn run(args: &RunArgs, color: Color) -> Result<ExitCode, UserError> {
    if args.interactive {
        live::check_terminal(args.events.as_ref().is_some_and(|events| events == "-"))?;
    }
    let mut controller = match opening::open(args, color)? {
        Opened::Ready(controller) => *controller,
        Opened::Faulty(code) => return Ok(code),
    };
    let mut audience = Audience::open(args, color)?;
    let end = until_the_end(args, &mut controller, &mut audience)?;
    let console = audience.close()?;
    if args.screen {
        console.page(&controller.devices.pendant)?;
    }
    Ok(exit_code(end, &controller, &console))
}

fn exit_code(end: End, controller: &Controller, console: &Console) -> ExitCode {
    match end {
        End::Finished if console.has_unhandled_errors() => ExitCode::FAILURE,
        End::Finished | End::Unread => ExitCode::SUCCESS,
        End::Stuck | End::Lacking => ExitCode::FAILURE,
        End::Limit if controller.has_failed_tasks() => ExitCode::FAILURE,
        End::Limit => ExitCode::from(EXIT_LIMIT),
        End::BrokenOff(code) => ExitCode::from(code),
    }
}

/// Tells everything that happens until the run ends.
fn until_the_end(args: &RunArgs, controller: &mut Controller, audience: &mut Audience) -> Result<End, UserError> {
    let (pace, signals) = (pace(args), Signals::catch()?);
    let end = loop {
        let step = controller.step();
        audience.tell(&controller.devices.take_events())?;
        let wish = audience.attend(controller)?;
        let end = match step {
            Step::Finished => Some(End::Finished),
            Step::Lacking => Some(End::Lacking),
            _ if wish == Wish::End => Some(End::BrokenOff(EXIT_BROKEN_OFF)),
            _ if audience.has_left() => Some(End::Unread),
            _ => signals.exit_code().map(End::BrokenOff),
        };
        if pace.keeps_time(controller) {
            audience.flush()?;
        }
        if let Some(end) = end.or_else(|| wait(&pace, controller, step)) {
            break end;
        }
    };
    let reason = match end {
        End::Finished if controller.was_stopped() => EndReason::Stopped,
        End::Finished => EndReason::Finished,
        End::Stuck | End::Lacking => EndReason::Error,
        End::Limit => EndReason::Limit,
        End::Unread | End::BrokenOff(_) => EndReason::Stopped,
    };
    controller.devices.record_outside(controller.now(), What::End { reason });
    audience.tell(&controller.devices.take_events())?;
    Ok(end)
}

/// The pace that the arguments ask for; an operator needs the clock on the wall.
fn pace(args: &RunArgs) -> Pace {
    let started = args.follows_wall().then(Instant::now);
    Pace { started, until: args.until.map(nanoseconds), attended: args.interactive }
}

/// Lets the time pass until something can happen; how the run ends, if nothing can.
fn wait(pace: &Pace, controller: &mut Controller, step: Step) -> Option<End> {
    let goes_on = match step {
        Step::Idle(wake) => pace.wait(controller, wake),
        Step::Stuck => pace.wait_for_operator(controller),
        Step::Busy | Step::Finished | Step::Lacking => {
            pace.follow(controller);
            true
        }
    };
    match goes_on {
        false => Some(End::Stuck),
        true => pace.is_over(controller.now()).then_some(End::Limit),
    }
}
