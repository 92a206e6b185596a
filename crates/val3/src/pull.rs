//! `val3 pull`: copies the files of a controller, and keeps local changes.

mod print;

use std::process::ExitCode;

use camino::Utf8Path;
use val3_controller::{
    ConflictVersions, ControllerAddress, ControllerError, ControllerPath, ControllerProject, FileDifference,
    PullRequest, PullResult, pull,
};

use crate::args::PullArgs;
use crate::controller::{
    ControllerSession, counted_files, note, parse_address, project_folder, report_error, shown, shown_bytes,
};
use crate::merge;
use crate::user_error::{EXIT_USAGE, UserError};

/// Folders that `--all` adds to the applications.
const SETTINGS: [&str; 4] = ["usr/configs", "usr/app", "usr/applicom", "usr/templates"];

/// Runs the command.
///
/// # Errors
/// The controller cannot be reached, is another one, or a file cannot be read or written.
pub(crate) fn run(args: &PullArgs) -> Result<ExitCode, UserError> {
    let folder = project_folder(args.folder.as_deref())?;
    let project = ControllerProject::open(&folder)?;
    let address = address(args, &project)?;
    if let Some(path) = &args.print {
        return print::run(path, &project, &address, args.new_controller);
    }
    let folders = folders(args, &project)?;
    let mut session = ControllerSession::open(project, &address, args.new_controller)?;
    note(&session.identity_line());
    let mut is_clean = true;
    let mut merge = |path: &ControllerPath, versions: &ConflictVersions| {
        let versions = [versions.base.clone(), versions.local.clone(), versions.controller.clone()];
        let (bytes, is_merged) = merge::merge_versions(Utf8Path::new(path.as_str()), &versions);
        is_clean &= is_merged;
        Ok(bytes)
    };
    let request = PullRequest {
        address: session.address.clone(),
        identity: session.identity.clone(),
        folders,
        merge: if args.merge { Some(&mut merge) } else { None },
    };
    let pulled = pull(&mut session.project, &mut *session.files, request, &mut session.observer);
    session.observer.end();
    match pulled {
        Ok(result) => report(&result, &folder)?,
        Err(ControllerError::Interrupted) => {
            note("interrupted: no local file was changed");
            return Ok(ExitCode::from(session.observer.signal_code().unwrap_or(EXIT_USAGE)));
        }
        Err(error @ ControllerError::Conflicts(_)) => {
            report_error(&error.into());
            return Ok(ExitCode::FAILURE);
        }
        Err(error) => return Err(error.into()),
    }
    Ok(if is_clean { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn address(args: &PullArgs, project: &ControllerProject) -> Result<ControllerAddress, UserError> {
    match (&args.address, &project.state) {
        (Some(text), _) => parse_address(text),
        (None, Some(state)) => parse_address(&state.address),
        (None, None) => Err(UserError::new("this folder has no controller yet")
            .with_help("name its address: `val3 pull ftp://PROFILE@HOST DIR`")),
    }
}

/// Pulled folders: the requested ones, else those of the last pull, else all applications.
fn folders(args: &PullArgs, project: &ControllerProject) -> Result<Vec<ControllerPath>, UserError> {
    let applications = ControllerPath::applications();
    let path = |text: &str| ControllerPath::parse(text).map_err(|fault| UserError::new(fault.to_string()));
    if !args.app.is_empty() {
        return args.app.iter().map(|name| path(&format!("{applications}/{}", name.trim_end_matches('/')))).collect();
    }
    let mut folders = match &project.state {
        Some(state) => state.folders.clone(),
        None => vec![applications.clone()],
    };
    if args.all {
        folders.push(applications);
        for text in SETTINGS {
            folders.push(path(text)?);
        }
        folders.sort();
        folders.dedup();
    }
    Ok(folders)
}

fn report(result: &PullResult, folder: &Utf8Path) -> Result<(), UserError> {
    let status = &result.status;
    let is_pulled = |difference: &&FileDifference| {
        matches!(difference, FileDifference::Controller(_) | FileDifference::Conflict { .. })
    };
    let updated = status.differences.values().filter(is_pulled).count();
    let kept = status.differences.values().filter(|difference| matches!(difference, FileDifference::Local(_))).count();
    let bytes = status.controller.values().map(|digest| digest.size).sum();
    let mut line = format!(
        "{}: {} of the controller ({}), {updated} updated",
        shown(folder)?,
        counted_files(status.controller.len()),
        shown_bytes(bytes)
    );
    if !result.merged.is_empty() {
        line.push_str(&format!(", of them {} merged", result.merged.len()));
    }
    if kept > 0 {
        line.push_str(&format!(", {kept} with local changes kept"));
    }
    note(&line);
    Ok(())
}
