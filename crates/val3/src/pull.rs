//! `val3 pull`: copies the files of a controller, and keeps local changes.

mod print;
mod report;

use std::process::ExitCode;

use camino::Utf8Path;
use val3_controller::{
    ConflictVersions, ControllerAddress, ControllerError, ControllerPath, ControllerProject, PullDecisions,
    PullRequest, pull,
};

use crate::args::PullArgs;
use crate::controller::{ControllerSession, ControllerTarget, note, parse_address, project_folder, report_error};
use crate::merge;
use crate::user_error::{EXIT_USAGE, UserError};

/// Folders that `--all` adds to the applications.
const SETTINGS: [&str; 4] = ["usr/configs", "usr/app", "usr/applicom", "usr/templates"];

/// Reason why a file is not merged after the loss of `.val3/base`, for example in a clone of the project.
const NO_BASE: &str = "its version of the last pull is not stored here, so that the changes of each side are unknown";

/// Runs the command.
///
/// # Errors
/// The controller cannot be reached, is another one, or a file cannot be read or written.
pub(crate) fn run(args: &PullArgs) -> Result<ExitCode, UserError> {
    let folder = project_folder(args.folder.as_deref())?;
    let project = ControllerProject::open(&folder)?;
    let target = ControllerTarget::new(address(args, &project)?, &args.connection, project.state.as_ref())?;
    if let Some(path) = &args.print {
        return print::run(path, &project, target, args.new_controller);
    }
    let folders = folders(args, &project)?;
    let decisions = PullDecisions { local: paths(&args.keep_local)?, controller: paths(&args.keep_controller)? };
    let mut session = ControllerSession::open(project, target, args.new_controller)?;
    note(&session.identity_line());
    let mut is_clean = true;
    let mut merge = |path: &ControllerPath, versions: &ConflictVersions| merge_file(path, versions, &mut is_clean);
    let request = PullRequest {
        address: session.address.clone(),
        connection: session.connection,
        identity: session.identity.clone(),
        folders,
        merge: if args.merge { Some(&mut merge) } else { None },
        decisions,
        accepts_removals: args.accept_removals,
    };
    let pulled = pull(&mut session.project, &mut *session.files, request, &mut session.observer);
    session.observer.end();
    match pulled {
        Ok(result) => {
            is_clean &= result.unmerged.is_empty() && result.changed_meanwhile.is_empty();
            report::write(&result, &folder)?;
        }
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

/// Merges the versions of a file, and reports the result. Returns the merged content; `None` if the file is not merged.
/// `is_clean` becomes `false` if the content contains conflicts.
fn merge_file(path: &ControllerPath, versions: &ConflictVersions, is_clean: &mut bool) -> Option<Vec<u8>> {
    let name = Utf8Path::new(path.as_str());
    let Some(base) = versions.base.clone() else {
        merge::write_unmerged(name, NO_BASE);
        return None;
    };
    let versions = [base, versions.local.clone(), versions.controller.clone()];
    let (bytes, is_merged) = merge::merge_versions(name, &versions)?;
    *is_clean &= is_merged;
    Some(bytes)
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

/// Files and folders on the controller.
fn paths(texts: &[String]) -> Result<Vec<ControllerPath>, UserError> {
    texts.iter().map(|text| full_path(text)).collect()
}

/// File or folder on the controller, named by its full path.
fn full_path(text: &str) -> Result<ControllerPath, UserError> {
    ControllerPath::parse(text.trim_end_matches('/')).map_err(|fault| {
        UserError::new(fault.to_string()).with_help("name a file as `val3 status` does: usr/usrapp/demo/start.pgx")
    })
}
