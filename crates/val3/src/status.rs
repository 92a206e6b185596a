//! `val3 status`: what has changed here and on the controller since the last pull or push, or what a controller does now.

mod document;
mod live;

use std::process::ExitCode;

use serde_json::Value;
use val3_controller::{ControllerError, FileDifference, ProjectStatus};

use crate::args::{StatusArgs, TransferFormat};
use crate::color::Color;
use crate::controller::soap_client::SoapTarget;
use crate::controller::{ControllerSession, counted_files, note, open_project, status_lines};
use crate::output::{OutputContent, to_stdout_as};
use crate::printable::one_line;
use crate::user_error::{EXIT_USAGE, UserError};

/// Runs the command. The exit code states whether files differ.
///
/// # Errors
/// The controller cannot be reached, is another one, or a file cannot be read.
pub(crate) fn run(args: &StatusArgs, color: Color) -> Result<ExitCode, UserError> {
    if let Some(target) = &args.soap {
        return show_live(target, args.format, color);
    }
    let (project, target) = open_project(&args.folder)?;
    let folders = project.state.as_ref().map(|state| state.folders.clone()).unwrap_or_default();
    let mut session = ControllerSession::open(project, target, false)?;
    note(&session.identity_line());
    let status = ProjectStatus::read(&session.project, &mut *session.files, &folders, &mut session.observer);
    session.observer.end();
    let status = match status {
        Err(ControllerError::Interrupted) => {
            return Ok(ExitCode::from(session.observer.signal_code().unwrap_or(EXIT_USAGE)));
        }
        status => status?,
    };
    write(args.format, color, || status_lines(&status.differences), || document::document(&session, &status))?;
    let count = |wanted: fn(&FileDifference) -> bool| status.differences.values().filter(|one| wanted(one)).count();
    let here = count(|one| matches!(one, FileDifference::Local(_)));
    let there = count(|one| matches!(one, FileDifference::Controller(_)));
    let conflicts = count(|one| matches!(one, FileDifference::Conflict { .. }));
    note(&format!(
        "{} compared: {here} changed here, {there} on the controller, {conflicts} on both sides",
        counted_files(status.controller.len())
    ));
    Ok(if here + there + conflicts == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Shows what a controller does now.
fn show_live(target: &SoapTarget, format: TransferFormat, color: Color) -> Result<ExitCode, UserError> {
    let state = live::LiveState::read(target)?;
    write(format, color, || state.lines(), || live::document(&state))?;
    Ok(ExitCode::SUCCESS)
}

/// Writes a result as lines or as a document.
fn write(
    format: TransferFormat,
    color: Color,
    lines: impl FnOnce() -> Vec<String>,
    document: impl FnOnce() -> Value,
) -> Result<(), UserError> {
    match format {
        TransferFormat::Human => to_stdout_as(OutputContent::Data, color, |out| {
            lines().iter().try_for_each(|line| writeln!(out, "{}", one_line(line)))
        }),
        TransferFormat::Json => to_stdout_as(OutputContent::Json, color, |out| writeln!(out, "{}", document())),
    }
}
