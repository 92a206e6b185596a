//! `val3 push`: uploads local changes after a check and a backup.

mod contents;
mod document;
mod loaded;
mod logs;
mod outcome;
mod removal;

use std::ops::ControlFlow;
use std::process::ExitCode;

use chrono::DateTime;
use val3_controller::{
    ControllerError, ControllerPath, ControllerProject, FileDifference, LockOwner, ProjectStatus, PushPlan,
    PushRequest, is_protected, push,
};

use self::loaded::LoadEvidence;
use self::removal::Removal;
use crate::args::{PushArgs, TransferFormat};
use crate::color::Color;
use crate::controller::{
    CheckOutcome, ControllerSession, check_new_tree, counted_files, listed_files, note, now, open_project,
    planned_lines, report_error,
};
use crate::output::{OutputContent, to_stdout_as};
use crate::printable::one_line;
use crate::user_error::{EXIT_USAGE, UserError};

/// Runs the command.
///
/// # Errors
/// The controller cannot be reached, is another one, or a file cannot be read or written.
pub(crate) fn run(args: &PushArgs, color: Color) -> Result<ExitCode, UserError> {
    let (project, target) = open_project(".".into())?;
    if let Some(soap) = &args.soap {
        loaded::check_host(soap, &target.address)?;
    }
    let selection = selection(&args.selection)?;
    let folders = folders(&project.state.as_ref().map(|state| state.folders.clone()).unwrap_or_default(), &selection)?;
    let mut session = ControllerSession::open(project, target, args.new_controller)?;
    note(&session.identity_line());
    if session.identity.serial.is_empty() && !args.new_controller {
        return Err(ControllerError::NoSerial.into());
    }
    let (plan, status) = match plan_push(&mut session, &folders, &selection)? {
        ControlFlow::Continue(planned) => planned,
        ControlFlow::Break(code) => return Ok(code),
    };
    check_selection(&selection, &status)?;
    note_omitted(&plan, &status);
    let removal = Removal::new(&plan, &args.remove)?;
    if plan.changes.is_empty() {
        print(&plan, args.format, color)?;
        note("nothing to push");
        return Ok(ExitCode::SUCCESS);
    }
    if let Some(code) = content_refusal(args, &session.project, &status, &plan, color)? {
        return Ok(code);
    }
    print(&plan, args.format, color)?;
    if args.dry_run {
        removal.note().iter().for_each(|line| note(line));
        return Ok(ExitCode::SUCCESS);
    }
    if let Some(reason) = removal.refusal()? {
        return Ok(refused(&reason));
    }
    if let Some(reason) = load_refusal(args, &mut session, &plan)? {
        return Ok(refused(&reason));
    }
    // The check and the question may have taken longer than an idle connection lasts.
    session.files.reconnect().map_err(ControllerError::from)?;
    execute(&mut session, &plan)
}

/// Compares the project with the controller, and plans the push. Breaks with the exit code if the push is refused.
fn plan_push(
    session: &mut ControllerSession,
    folders: &[ControllerPath],
    selection: &[ControllerPath],
) -> Result<ControlFlow<ExitCode, (PushPlan, ProjectStatus)>, UserError> {
    let status = ProjectStatus::read(&session.project, &mut *session.files, folders, &mut session.observer);
    let plan = status.and_then(|status| Ok((PushPlan::new(&session.project, &status, selection)?, status)));
    session.observer.end();
    match plan {
        Ok(planned) => Ok(ControlFlow::Continue(planned)),
        Err(
            error @ (ControllerError::Conflicts(_)
            | ControllerError::Outdated(_)
            | ControllerError::NoApplicationLeft(_)
            | ControllerError::RemovesSettings(_)),
        ) => Ok(ControlFlow::Break(refused(&UserError::from(error)))),
        Err(ControllerError::Interrupted) => Ok(ControlFlow::Break(interrupted(session))),
        Err(error) => Err(error.into()),
    }
}

/// Prints notes on files that the push does not transfer, and that differ from those on the controller.
fn note_omitted(plan: &PushPlan, status: &ProjectStatus) {
    if !plan.unselected.is_empty() {
        note(&format!("note: local changes that are not selected stay here: {}", counted_files(plan.unselected.len())));
    }
    let newer = newer_on_controller(status);
    if !newer.is_empty() {
        note(&format!(
            "note: changed on the controller, and not pulled, so that the check uses the versions here: {}",
            listed_files(&newer)
        ));
    }
}

/// Checks the planned files, and the applications as they will be on the controller. Returns the exit code if there are
/// errors, which are printed.
fn content_refusal(
    args: &PushArgs,
    project: &ControllerProject,
    status: &ProjectStatus,
    plan: &PushPlan,
    color: Color,
) -> Result<Option<ExitCode>, UserError> {
    let faults = contents::faults(project, plan)?;
    if !faults.is_empty() {
        faults.iter().for_each(report_error);
        note("nothing was pushed");
        return Ok(Some(ExitCode::FAILURE));
    }
    if check_new_tree(project, status, plan, &args.ignore, color)? == CheckOutcome::Errors {
        return Ok(Some(refused(
            &UserError::new("the check has found errors, so nothing was pushed")
                .with_help("repair them, or name rules whose errors do not matter with --ignore"),
        )));
    }
    Ok(None)
}

/// Returns the reason for a refusal if a planned application is loaded on the controller.
fn load_refusal(
    args: &PushArgs,
    session: &mut ControllerSession,
    plan: &PushPlan,
) -> Result<Option<UserError>, UserError> {
    let evidence = match &args.soap {
        _ if args.unloaded || plan.applications().is_empty() => LoadEvidence::Statement,
        Some(target) => LoadEvidence::Interface(target),
        None => LoadEvidence::Log,
    };
    let refusal = loaded::refusal(&mut *session.files, plan, &mut session.observer, evidence);
    session.observer.end();
    refusal
}

/// Files that are not selected, and whose versions on the controller the project does not have.
fn newer_on_controller(status: &ProjectStatus) -> Vec<ControllerPath> {
    let newer = status.differences.iter().filter(|(_, difference)| has_changed_on_controller(difference));
    newer.map(|(path, _)| path.clone()).collect()
}

/// Whether the controller's version has changed since the last pull, and differs from the local one.
fn has_changed_on_controller(difference: &FileDifference) -> bool {
    matches!(difference, FileDifference::Controller(_) | FileDifference::Conflict { .. })
}

/// Writes the changes to the standard output.
fn print(plan: &PushPlan, format: TransferFormat, color: Color) -> Result<(), UserError> {
    match format {
        TransferFormat::Human => {
            let lines = planned_lines(&plan.changes);
            to_stdout_as(OutputContent::Data, color, |out| {
                lines.iter().try_for_each(|line| writeln!(out, "{}", one_line(line)))
            })
        }
        TransferFormat::Json => {
            let document = document::document(plan);
            to_stdout_as(OutputContent::Json, color, |out| writeln!(out, "{document}"))
        }
    }
}

/// Pushes, and reports the outcome.
fn execute(session: &mut ControllerSession, plan: &PushPlan) -> Result<ExitCode, UserError> {
    let owner = LockOwner { user: variable(&["USER", "USERNAME"]), host: variable(&["HOSTNAME", "COMPUTERNAME"]) };
    let now = now();
    let seconds = i64::try_from(now).unwrap_or(i64::MAX);
    let backup = DateTime::from_timestamp(seconds, 0).unwrap_or_default().format("%Y-%m-%dT%H-%M-%SZ").to_string();
    if let Some(state) = &mut session.project.state {
        // A new controller was accepted.
        state.controller = session.identity.clone();
    }
    let request = PushRequest { plan, owner: &owner, now, backup: &backup };
    let pushed = push(&mut session.project, &mut *session.files, request, &mut session.observer);
    session.observer.end();
    match pushed {
        Ok(()) => {
            outcome::done(plan, &session.project)?;
            Ok(session.observer.signal_code().map_or(ExitCode::SUCCESS, |_| {
                note("note: the interruption came after the point at which a push is completed");
                ExitCode::SUCCESS
            }))
        }
        Err(failure) => {
            let is_interrupted = failure.error == ControllerError::Interrupted;
            let code = if is_interrupted { session.observer.signal_code() } else { None };
            report_error(&outcome::failed(failure));
            Ok(ExitCode::from(code.unwrap_or(EXIT_USAGE)))
        }
    }
}

/// Selected folders and files.
fn selection(names: &[String]) -> Result<Vec<ControllerPath>, UserError> {
    if names.is_empty() {
        return Ok(vec![ControllerPath::applications()]);
    }
    names.iter().map(|name| selected_path(name)).collect()
}

/// Path with this name, which is relative to the applications unless it begins with `usr/`.
fn selected_path(name: &str) -> Result<ControllerPath, UserError> {
    let applications = ControllerPath::applications();
    let name = name.trim_end_matches('/');
    let full = if name.starts_with("usr/") { name.to_owned() } else { format!("{applications}/{name}") };
    let path = ControllerPath::parse(&full).map_err(|fault| UserError::new(fault.to_string()))?;
    if !path.is_in(&applications) && is_protected(&path) {
        return Err(ControllerError::Protected(vec![path]).into());
    }
    Ok(path)
}

/// Folders that are compared: those of the project. Every selected path is in one of them.
fn folders(known: &[ControllerPath], selection: &[ControllerPath]) -> Result<Vec<ControllerPath>, UserError> {
    match selection.iter().find(|path| !is_pulled(known, path)) {
        None => Ok(known.to_vec()),
        Some(path) => Err(UserError::new(format!("`{path}` was never pulled"))
            .with_help("run `val3 pull --all`, or `val3 pull --app NAME`, first")),
    }
}

/// Whether the path is in a pulled folder, or contains pulled applications.
fn is_pulled(known: &[ControllerPath], path: &ControllerPath) -> bool {
    let applications = ControllerPath::applications();
    known.iter().any(|folder| path.is_in(folder) || folder.is_in(path) && folder.is_in(&applications))
}

/// Checks that each selected path has files here or on the controller, so that a wrong name is not "nothing to push".
fn check_selection(selection: &[ControllerPath], status: &ProjectStatus) -> Result<(), UserError> {
    let files = status.local.keys().chain(status.controller.keys());
    match selection.iter().find(|folder| !files.clone().any(|path| path.is_in(folder))) {
        None => Ok(()),
        Some(path) => Err(UserError::new(format!("`{path}` has no files, neither here nor on the controller"))
            .with_help("name a folder below usr/usrapp, or the path of a file")),
    }
}

fn refused(reason: &UserError) -> ExitCode {
    report_error(reason);
    ExitCode::FAILURE
}

fn interrupted(session: &ControllerSession) -> ExitCode {
    note("interrupted: the controller was not changed");
    ExitCode::from(session.observer.signal_code().unwrap_or(EXIT_USAGE))
}

/// Value of the first variable that is set.
fn variable(names: &[&str]) -> String {
    names.iter().find_map(|name| std::env::var(name).ok()).unwrap_or_else(|| "unknown".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_relative_to_the_applications() {
        let selected = |name: &str| selected_path(name).unwrap().to_string();
        assert_eq!(selected("palletizer/"), "usr/usrapp/palletizer");
        assert_eq!(selected("usr/usrapp/palletizer"), "usr/usrapp/palletizer");
        assert_eq!(selected("usr/app/val3.cfx"), "usr/app/val3.cfx");
        selected_path("usr/configs/controller.cfx").unwrap_err();
    }

    #[test]
    fn the_folder_of_pulled_applications_is_pulled() {
        let path = |text: &str| ControllerPath::parse(text).unwrap();
        let known = [path("usr/usrapp/a"), path("usr/app")];
        for pulled in ["usr/usrapp/a/start.pgx", "usr/usrapp", "usr/app"] {
            assert!(is_pulled(&known, &path(pulled)), "{pulled}");
        }
        for other in ["usr/usrapp/b", "usr/configs"] {
            assert!(!is_pulled(&known, &path(other)), "{other}");
        }
    }
}
