//! Choice of the arm for `val3 check --motion`.

use val3_analysis::arm::{ArmOrigin, ProjectArm, arm};
use val3_analysis::db::{Database, Project};
use val3_analysis::items::project::items;
use val3_analysis::load::LoadError;
use val3_check::rules;
use val3_check::settings::WorkspaceSettings;
use val3_config::{ArmModel, ArmSetting, ConfigFile};
use val3_lang::types::BaseType;
use val3_session::SessionError;

use crate::user_error::UserError;

/// Returns the notice that the positions of a project are compared with the default arm; only one notice for all
/// projects.
///
/// # Errors
/// The arm in a `val3.toml` cannot be used.
pub(crate) fn notice(
    db: &Database,
    projects: &[Project],
    settings: &WorkspaceSettings,
) -> Result<Option<String>, UserError> {
    let mut notice = None;
    for project in projects {
        let file = project.configuration(db).map(|found| found.file(db));
        let setting = file.and_then(|file| file.config.arm.as_ref()).and_then(ArmSetting::model);
        let is_compared = is_compared(db, *project, settings);
        // An arm file only matters to projects with positions that are compared with it.
        if !is_compared && !matches!(setting, Some(ArmModel::Name(_))) {
            continue;
        }
        let named = file.filter(|_| setting.is_some());
        match (arm(db, *project), named) {
            (Ok(arm), _) if is_compared => notice = notice.or_else(|| notice_about(arm)),
            (Ok(_), _) => {}
            (Err(reason), Some(file)) => return Err(fault(file, reason)),
            (Err(reason), None) => return Err(UserError::new(reason.to_string())),
        }
    }
    Ok(notice)
}

/// Error about the arm in a `val3.toml`, with its line.
fn fault(file: &ConfigFile, reason: &str) -> UserError {
    let fault = file.fault("arm", reason.to_owned(), "`val3 arm list` lists the arms".to_owned());
    SessionError::Load(LoadError::Configuration(vec![fault])).into()
}

/// Whether the project has points or joints, and a rule that compares them with the arm is on.
fn is_compared(db: &Database, project: Project, settings: &WorkspaceSettings) -> bool {
    let settings = settings.of(db, project);
    rules::of_motion().iter().any(|rule| settings.is_enabled(rule)) && has_positions(db, project)
}

/// Whether the project's data contain points or joints.
fn has_positions(db: &Database, project: Project) -> bool {
    let mut types = items(db, project).data.values().filter_map(|item| item.base.builtin());
    types.any(|ty| matches!(ty, BaseType::Point | BaseType::Joint))
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
            "the arm `{unknown}` of arm.cfx is unknown: positions and moves are compared with a {name}; describe \
             yours in a file (--arm FILE.toml)"
        )),
    }
}
