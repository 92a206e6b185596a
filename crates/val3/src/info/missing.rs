//! What `val3 run` needs and a backup does not contain.

use camino::Utf8Path;
use val3_analysis::load::{self, Workspace};
use val3_analysis::system::{Memory, OverlayFs};
use val3_backup::info::ControllerInfo;
use val3_kinematics::Arm;

use crate::backup_files::OpenedBackup;
use crate::engine::Session;
use crate::opening::OpenRequest;
use crate::selection;
use crate::user_error::UserError;

/// Rules about missing things: add-ons, files of projects, files that cannot be read, files that a project may not load.
const RULES: [&str; 4] = ["V0104", "V0501", "V0502", "V0509"];

/// Folder of a controller's files in memory.
const ROOT: &str = "/";

/// Returns a sentence for each missing thing. `place` is the absolute path of the controller, or its address.
pub(super) fn missing(backup: &OpenedBackup, place: &Utf8Path, info: &ControllerInfo) -> Vec<String> {
    let mut missing = Vec::new();
    missing.extend(missing_arm(info));
    if info.version.is_none() {
        missing.push("the version of the controller is unknown, so that the newest is assumed".to_owned());
    }
    if info.applications.is_empty() {
        missing.push("there is no application".to_owned());
        return missing;
    }
    missing.extend(found(backup, place).unwrap_or_else(|error| vec![sentence(&error)]));
    missing
}

fn missing_arm(info: &ControllerInfo) -> Option<String> {
    match info.arm.as_deref().filter(|_| !info.arm_of_drawing) {
        None => Some("the arm is unknown: name it with --arm".to_owned()),
        Some(name) => Arm::by_settings(name, info.length_axis3.as_deref())
            .err()
            .map(|_| format!("the arm `{name}` is unknown: describe it in a file (--arm FILE.toml)")),
    }
}

/// Error without line feeds.
fn sentence(error: &UserError) -> String {
    error.lines().replace("\n  help: ", "; ").replace('\n', "; ")
}

/// Returns the findings of the check about missing things.
fn found(backup: &OpenedBackup, place: &Utf8Path) -> Result<Vec<String>, UserError> {
    let asked = if backup.is_remote() { ROOT.into() } else { place.to_owned() };
    let request = OpenRequest {
        asked: vec![asked],
        selection: selection::read(&RULES.map(str::to_owned), &[], &[])?,
        quiet: true,
        ..OpenRequest::default()
    };
    let mut session = match backup.is_remote() {
        true => Session::with_workspace(&request, downloaded(backup)?)?,
        false => Session::open(&request)?,
    };
    let checked = session.check()?;
    let report = session.report(checked);
    let findings = report.findings.iter().map(|finding| {
        let file = if backup.is_remote() { &finding.place.file.path } else { &finding.place.file.shown };
        format!("{file}:{}: {}", finding.place.start().line, finding.message_with_help())
    });
    let unread = report.unreadable.iter().map(sentence);
    let found = unread.chain(findings).collect();
    session.abandon();
    Ok(found)
}

/// Loads the downloaded files of a controller.
fn downloaded(backup: &OpenedBackup) -> Result<Workspace, UserError> {
    let mut system = OverlayFs::new(Memory::default());
    for file in backup.files.files().iter().filter(|file| file.path.starts_with("usr/")) {
        let bytes = backup.files.read(&file.path).map_err(UserError::new)?;
        system.store(Utf8Path::new(ROOT).join(&file.path), bytes);
    }
    load::load(&system, &[ROOT.into()]).map_err(|error| UserError::new(error.to_string()))
}
