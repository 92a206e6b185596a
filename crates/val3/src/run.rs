//! `val3 run`: runs an application on the embedded controller.

mod again;
mod clients;
mod console;
mod course;
mod debug;
mod default_run;
mod encounters;
mod end;
mod ending;
mod export;
mod failures;
mod guide;
mod live;
mod missing;
mod motion;
mod observers;
mod opening;
mod output_errors;
mod outside;
mod record;
mod recorded_actions;
mod recorded_options;
mod recorder;
mod replay;
mod result;
mod silence;
mod standby;
mod tempo;
mod unpacked;
mod viewers;

use std::process::ExitCode;

use val3_machine::event::{EndReason, Event, EventKind};
use val3_view::wire::Role;

use crate::args::RunArgs;
use crate::color::Color;
use crate::output::{OutputContent, to_stderr, to_stderr_in_color, to_stdout_as};
use crate::signals::Signals;
use crate::sockets::AnnouncementReader;
use crate::user_error::UserError;
pub(crate) use debug::{DebugSettings, debug, open_debugged};
pub(crate) use opening::{OpenedApplication, ReadyApplication, open};
pub(crate) use outside::{check_script, read_script, unusable_script};
pub(crate) use replay::complete as complete_by_recording;

use clients::Clients;
use course::Course;
use debug::{open_port, run_attended};
use guide::NoDebugger;
use observers::Observers;
use record::Record;
use replay::RunRecording;
use result::ResultRecorder;
use viewers::Viewers;

/// Exit code of a run that reached the limit of `--until`.
const EXIT_LIMIT: u8 = 3;

/// Exit code of a run that the operator has aborted, as shells report Ctrl-C.
const EXIT_BROKEN_OFF: u8 = 130;

/// Runs the command.
pub(crate) fn run(args: &RunArgs, color: Color) -> Result<ExitCode, UserError> {
    let mut args = args.clone();
    let written = default_run::complete(&mut args)?;
    replay::complete(&mut args)?;
    let args = &args;
    if args.interactive {
        live::check_terminal(args.events.as_ref().is_some_and(|events| events == "-"))?;
    }
    let recording = args.replay.as_deref().map(RunRecording::open).transpose()?;
    let ready = match open(args, AnnouncementReader::Terminal, &mut |write| to_stderr_in_color(color, write))? {
        OpenedApplication::Ready(ready) => *ready,
        OpenedApplication::Faulty { code, errors } => return refuse(args, code, &errors),
    };
    if let (Some(_), Some(checked)) = (&written, &ready.checked) {
        to_stderr(|out| writeln!(out, "note: {checked}"));
    }
    if args.scene {
        let scene = val3_view::scene(&ready.controller, Role::Preview);
        let message = serde_json::json!(val3_view::wire::Message::Scene(Box::new(scene)));
        to_stdout_as(OutputContent::Json, Color::Never, |out| writeln!(out, "{message}"))?;
        return Ok(ExitCode::SUCCESS);
    }
    let clients = args.soap.map(|address| Clients::open(address, &ready)).transpose()?;
    let mut course = Course::open(args, ready, Observers::open(args, recording, color)?)?;
    if let Some(clients) = clients {
        course.attend_clients(clients);
    }
    if let Some(address) = args.serve {
        let viewers = Viewers::open(address, args, &course.debugger.controller)?;
        course.serve(viewers);
    }
    let code = run_to_end(course, color)?;
    if let Some(written) = written {
        written.report();
    }
    Ok(ExitCode::from(code))
}

/// Runs an application, and runs it again whenever an operator starts it on the page. Returns the exit code of the
/// last run.
fn run_to_end(mut course: Course<'_>, color: Color) -> Result<u8, UserError> {
    let args = course.args;
    let signals = Signals::catch()?;
    let mut port = args.debug_port.map(|port| open_port(args, port)).transpose()?;
    loop {
        let end = match &mut port {
            Some(server) => run_attended(&mut course, server, &signals),
            None => course.run(&mut NoDebugger, &signals),
        };
        let code = course.exit_code(end);
        let Some(ended) = course.close(end)? else { return Ok(code) };
        match ended.wait_for_start(args, color, &signals) {
            Some(again) => course = again,
            None => return Ok(code),
        }
    }
}

/// Ends a run that cannot begin. Its event record and its result contain only the end.
fn refuse(args: &RunArgs, code: u8, errors: &[String]) -> Result<ExitCode, UserError> {
    let mut record = Record::open(args.events.as_deref())?;
    record.write(&Event { t: 0.0, task: None, at: None, kind: EventKind::End { reason: EndReason::Refused } })?;
    record.flush()?;
    if let Some(result) = ResultRecorder::open(args)? {
        result.refuse(code, errors)?;
    }
    Ok(ExitCode::from(code))
}
