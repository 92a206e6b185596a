//! `val3 run`: an application on the embedded controller.

mod arm;
mod console;
mod images;
mod lines;
mod opening;
mod outside;
mod pace;
mod record;

use std::process::ExitCode;

use val3_machine::controller::{Controller, Step};
use val3_machine::event::{EndReason, What};

use crate::args::{Color, RunArgs};
use crate::user_error::UserError;
use console::Console;
use opening::Opened;
use pace::Pace;
use record::Record;

pub(crate) use console::lacking;
pub(crate) use images::{Images, Laid};
pub(crate) use lines::LineArg;
pub(crate) use opening::only_application;

/// Exit code of a run that `--until` has ended.
const EXIT_LIMIT: u8 = 3;

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
}

/// Runs the command.
pub(crate) fn run(args: &RunArgs, color: Color) -> Result<ExitCode, UserError> {
    let mut controller = match opening::open(args, color)? {
        Opened::Ready(controller) => *controller,
        Opened::Faulty(code) => return Ok(code),
    };
    let mut record = Record::open(args.events.as_deref())?;
    let mut console = Console::new(color, !record.takes_stdout())?;
    let end = until_the_end(args, &mut controller, &mut |what| {
        record.write(what)?;
        console.show(what)
    })?;
    record.close()?;
    if args.screen {
        console.page(&controller.devices.pendant)?;
    }
    Ok(exit_code(end, &controller, &console))
}

fn exit_code(end: End, controller: &Controller, console: &Console) -> ExitCode {
    match end {
        End::Finished if console.has_unhandled_errors() => ExitCode::FAILURE,
        End::Finished => ExitCode::SUCCESS,
        End::Stuck | End::Lacking => ExitCode::FAILURE,
        End::Limit if controller.has_failed_tasks() => ExitCode::FAILURE,
        End::Limit => ExitCode::from(EXIT_LIMIT),
    }
}

/// Gives `tell` everything that happens until the run ends.
fn until_the_end(
    args: &RunArgs,
    controller: &mut Controller,
    tell: &mut dyn FnMut(&val3_machine::event::Event) -> Result<(), UserError>,
) -> Result<End, UserError> {
    let mut pace = Pace::new(args.time, args.until);
    let end = loop {
        let step = controller.step();
        controller.devices.take_events().iter().try_for_each(&mut *tell)?;
        match step {
            Step::Finished => break End::Finished,
            Step::Lacking => break End::Lacking,
            _ if pace.is_over(controller.now()) => break End::Limit,
            Step::Busy => pace.follow(controller.now()),
            Step::Idle(wake) if !pace.wait(controller, wake) => break End::Stuck,
            Step::Stuck if !pace.wait(controller, None) => break End::Stuck,
            Step::Idle(_) | Step::Stuck => {}
        }
    };
    let reason = match end {
        End::Finished if controller.was_stopped() => EndReason::Stopped,
        End::Finished => EndReason::Finished,
        End::Stuck | End::Lacking => EndReason::Error,
        End::Limit => EndReason::Limit,
    };
    controller.devices.record_outside(controller.now(), What::End { reason });
    controller.devices.take_events().iter().try_for_each(tell)?;
    Ok(end)
}
