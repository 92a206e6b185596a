//! The model of the arm: that of the settings, else that of `val3.toml`, else that of the cell.

use std::sync::Arc;

use camino::{Utf8Path, Utf8PathBuf};
use salsa::Setter as _;
use val3_analysis::arm::RequestedArm;
use val3_analysis::db::{Configuration, Database, Project};
use val3_config::{ArmModel, ArmSetting, ConfigFile};
use val3_kinematics::Arm;
use val3_lang::suggest::{proposals, question};

use crate::error::SessionError;

/// An arm, and the name under which `getVersion` shows it.
pub(crate) struct ChosenArm {
    pub(crate) model: Arm,
    pub(crate) name: String,
}

/// The arm that the settings or the `val3.toml` choose; `None` where they leave it to the cell.
///
/// # Errors
/// There is no such model, or the file that describes it has a fault.
pub(crate) fn chosen(setting: Option<&str>, file: Option<&ConfigFile>) -> Result<Option<ChosenArm>, SessionError> {
    if let Some(setting) = setting.and_then(ArmSetting::parse) {
        return model(&setting, Utf8Path::new(""));
    }
    let configured = file.and_then(|file| Some((file.config.arm.as_ref()?, file.folder())));
    configured.map_or(Ok(None), |(setting, folder)| model(setting, folder))
}

/// Chooses the arm of projects for their analysis, whatever their configurations and cells say.
///
/// # Errors
/// There is no such model, or the file that describes it has a fault.
pub fn request_arm(db: &mut Database, projects: &[Project], name: &str) -> Result<(), SessionError> {
    projects.iter().try_for_each(|project| set_arm(db, *project, name))?;
    let Some(chosen) = chosen(Some(name), None)? else { return Ok(()) };
    let model = Arc::new(chosen.model);
    match RequestedArm::try_get(db) {
        Some(requested) => _ = requested.set_arm(db).to(model),
        None => _ = RequestedArm::new(db, model),
    }
    Ok(())
}

/// Chooses the arm of a project, whatever its configuration says.
///
/// # Errors
/// There is no arm called `name`.
pub(crate) fn set_arm(db: &mut Database, project: Project, name: &str) -> Result<(), SessionError> {
    let parsed = ConfigFile::parse(Utf8Path::new(""), &format!("arm = {name:?}"));
    let mut arm =
        parsed.map_err(|error| SessionError::Setting { message: error.message, help: error.help })?.config.arm;
    if let Some(setting) = &arm
        && setting.kind().is_none()
        && let Some(chosen) = model(setting, Utf8Path::new(""))?
    {
        arm = ArmSetting::parse(if chosen.model.is_scara() { "scara" } else { "six-axis" });
    }
    let mut file = project.configuration(db).map(|found| found.file(db).clone()).unwrap_or_default();
    file.config.arm = arm;
    let configuration = Configuration::new(db, file);
    project.set_configuration(db).to(Some(configuration));
    Ok(())
}

/// The arm of a setting, whose files are relative to `folder`; `None` where it only says the kind.
pub(crate) fn model(setting: &ArmSetting, folder: &Utf8Path) -> Result<Option<ChosenArm>, SessionError> {
    match setting.model() {
        None => Ok(None),
        Some(ArmModel::Name(name)) => Ok(Some(ChosenArm { model: shipped(name)?, name: name.to_owned() })),
        Some(ArmModel::File(path)) => {
            let model = described(folder.join(path))?;
            Ok(Some(ChosenArm { name: model.name().to_owned(), model }))
        }
    }
}

fn shipped(name: &str) -> Result<Arm, SessionError> {
    Arm::by_name(name).map_err(|unknown| SessionError::Setting {
        message: format!("the arm `{name}` is not known"),
        help: question(proposals(name, Arm::names()))
            .unwrap_or_else(|| format!("{unknown}; another arm can be described in a file: --arm my-arm.toml")),
    })
}

fn described(path: Utf8PathBuf) -> Result<Arm, SessionError> {
    let failed = |reason: String| SessionError::Setting {
        message: format!("the arm of `{path}` cannot be used: {reason}"),
        help: "the files of the shipped arms show the form: crates/val3-kinematics/arms".to_owned(),
    };
    let text = std::fs::read_to_string(&path).map_err(|error| failed(error.to_string()))?;
    Arm::from_toml(&text).map_err(|error| failed(error.to_string()))
}
