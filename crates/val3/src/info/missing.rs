//! What `val3 run` needs and a backup does not contain.

use camino::Utf8Path;
use val3_backup::info::ControllerInfo;
use val3_kinematics::Arm;

use crate::engine::Session;
use crate::opening::OpenRequest;
use crate::selection;
use crate::user_error::UserError;

/// Rules about missing things: add-ons, files of projects, files that cannot be read, files that a project may not load.
const RULES: [&str; 4] = ["V0104", "V0501", "V0502", "V0509"];

/// Returns a sentence for each missing thing. `place` is the absolute path of the controller.
pub(super) fn missing(place: &Utf8Path, info: &ControllerInfo) -> Vec<String> {
    let mut missing = Vec::new();
    missing.extend(missing_arm(info));
    if info.version.is_none() {
        missing.push("the version of the controller is unknown, so that the newest is assumed".to_owned());
    }
    if info.applications.is_empty() {
        missing.push("there is no application".to_owned());
        return missing;
    }
    missing.extend(found(place).unwrap_or_else(|error| vec![sentence(&error)]));
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
fn found(place: &Utf8Path) -> Result<Vec<String>, UserError> {
    let request = OpenRequest {
        asked: vec![place.to_owned()],
        selection: selection::read(&RULES.map(str::to_owned), &[], &[])?,
        quiet: true,
        ..OpenRequest::default()
    };
    let mut session = Session::open(&request)?;
    let checked = session.check()?;
    let report = session.report(checked);
    let findings = report.findings.iter().map(|finding| {
        let place = &finding.place;
        format!("{}:{}: {}", place.file.shown, place.start().line, finding.message_with_help())
    });
    let unread = report.unreadable.iter().map(sentence);
    let found = unread.chain(findings).collect();
    session.abandon();
    Ok(found)
}
