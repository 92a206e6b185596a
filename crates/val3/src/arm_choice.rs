//! The arm that `val3 check --motion` compares positions and moves with.

use val3_analysis::arm::{ArmOrigin, ProjectArm, arm};
use val3_analysis::db::{Database, Project};
use val3_analysis::items::project::items;
use val3_check::rules;
use val3_check::settings::WorkspaceSettings;
use val3_lang::types::BaseType;

use crate::user_error::UserError;

/// What a check with the arm has to say about its choice: once, wherever the default arm takes the place of another.
///
/// # Errors
/// The arm that a `val3.toml` names cannot be used.
pub(crate) fn notice(
    db: &Database,
    projects: &[Project],
    settings: &WorkspaceSettings,
) -> Result<Option<String>, UserError> {
    let mut notice = None;
    for project in projects.iter().filter(|project| is_compared(db, **project, settings)) {
        match arm(db, *project) {
            Ok(arm) => notice = notice.or_else(|| notice_about(arm)),
            Err(reason) => return Err(UserError::new(reason.to_string())),
        }
    }
    Ok(notice)
}

/// The project has points or joints, and a rule that compares them with the arm is on.
fn is_compared(db: &Database, project: Project, settings: &WorkspaceSettings) -> bool {
    let settings = settings.of(db, project);
    let has_positions = || {
        let mut types = items(db, project).data.values().filter_map(|item| item.base.builtin());
        types.any(|ty| matches!(ty, BaseType::Point | BaseType::Joint))
    };
    rules::of_motion().iter().any(|rule| settings.wants(rule)) && has_positions()
}

fn notice_about(arm: &ProjectArm) -> Option<String> {
    let name = arm.model.name();
    match &arm.origin {
        ArmOrigin::Named => None,
        ArmOrigin::Default => Some(format!(
            "no arm is named: positions and moves are compared with a {name}; name yours with --arm, in val3.toml or in \
             arm.cfx"
        )),
        ArmOrigin::Unknown(unknown) => Some(format!(
            "the arm `{unknown}` of arm.cfx is not known: positions and moves are compared with a {name}; describe \
             yours in a file (--arm FILE.toml)"
        )),
    }
}
