//! Arm model: from the settings, otherwise from `val3.toml`, otherwise from the cell.

use std::fmt::Display;
use std::sync::Arc;

use camino::{Utf8Path, Utf8PathBuf};
use salsa::Setter as _;
use val3_analysis::arm::RequestedArm;
use val3_analysis::db::{Configuration, Database, Project};
use val3_config::{ArmModel, ArmSetting, ConfigFile};
use val3_files::FileClass;
use val3_kinematics::{Arm, UnknownArm};
use val3_lang::suggest::{proposals, question};

use crate::error::SessionError;

/// An arm, and its name for `getVersion`.
pub(crate) struct ChosenArm {
    pub(crate) model: Arm,
    pub(crate) name: String,
}

/// Arm set by the settings or by `val3.toml`; `None` if the cell determines it.
///
/// # Errors
/// If the model does not exist, or if its description file is invalid.
pub(crate) fn chosen(setting: Option<&str>, file: Option<&ConfigFile>) -> Result<Option<ChosenArm>, SessionError> {
    if let Some(setting) = setting.and_then(ArmSetting::parse) {
        return model(&setting, Utf8Path::new(""));
    }
    let configured = file.and_then(|file| Some((file, file.config.arm.as_ref()?)));
    configured.map_or(Ok(None), |(file, setting)| model(setting, file.folder()).map_err(|error| in_file(file, error)))
}

/// Adds the line in `val3.toml` to the error.
fn in_file(file: &ConfigFile, error: SessionError) -> SessionError {
    match error {
        SessionError::Setting { message, help } => file.fault("arm", message, help).into(),
        other => other,
    }
}

/// Sets the arm of projects for their analysis, with precedence over their configurations and cells.
///
/// # Errors
/// If the model does not exist, or if its description file is invalid.
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

/// Sets the arm of a project, with precedence over its configuration.
///
/// # Errors
/// If no arm is called `name`.
pub(crate) fn set_arm(db: &mut Database, project: Project, name: &str) -> Result<(), SessionError> {
    let parsed = ConfigFile::parse(Utf8Path::new(""), &format!("arm = {name:?}"));
    let mut arm =
        parsed.map_err(|error| SessionError::Setting { message: error.message, help: error.help })?.config.arm;
    // The arm kind is derived from the model, because a name prefix does not always determine it.
    let chosen = arm.as_ref().map_or(Ok(None), |setting| model(setting, Utf8Path::new("")))?;
    if let (Some(setting), Some(chosen)) = (&arm, chosen)
        && setting.kind().is_none()
    {
        arm = ArmSetting::parse(if chosen.model.is_scara() { "scara" } else { "six-axis" });
    }
    let mut file = project.configuration(db).map(|found| found.file(db).clone()).unwrap_or_default();
    file.config.arm = arm;
    let configuration = Configuration::new(db, file);
    project.set_configuration(db).to(Some(configuration));
    Ok(())
}

/// Arm of a setting, with file paths relative to `folder`; `None` if the setting only states the arm kind.
pub(crate) fn model(setting: &ArmSetting, folder: &Utf8Path) -> Result<Option<ChosenArm>, SessionError> {
    Ok(read(setting, folder)?.map(|file| {
        let name = match setting.model() {
            Some(ArmModel::Name(name)) => name.to_owned(),
            _ => file.arm.name().to_owned(),
        };
        ChosenArm { model: file.arm, name }
    }))
}

/// An arm and its description file.
pub struct ArmFile {
    /// The arm.
    pub arm: Arm,
    /// File text in TOML.
    pub text: String,
}

impl ArmFile {
    /// Arm for `--arm`: a shipped model (`tx2-60l`) or a file path (`my-arm.toml`).
    ///
    /// # Errors
    /// If the model does not exist, if the name only states an arm kind, or if the file is invalid.
    pub fn named(name: &str) -> Result<Self, SessionError> {
        let Some(setting) = ArmSetting::parse(name) else { return shipped(name) };
        read(&setting, Utf8Path::new(""))?.ok_or_else(|| SessionError::Setting {
            message: format!("`{name}` is a kind of arm, and a model is needed here"),
            help: "name a model such as `tx2-60l` (`val3 arm list` shows them), or a file such as `my-arm.toml`"
                .to_owned(),
        })
    }
}

fn read(setting: &ArmSetting, folder: &Utf8Path) -> Result<Option<ArmFile>, SessionError> {
    match setting.model() {
        None => Ok(None),
        Some(ArmModel::Name(name)) => shipped(name).map(Some),
        Some(ArmModel::File(path)) => described(folder.join(path)).map(Some),
    }
}

fn shipped(name: &str) -> Result<ArmFile, SessionError> {
    let shipped = Arm::file(name).and_then(|text| Ok(ArmFile { arm: Arm::by_name(name)?, text: text.to_owned() }));
    shipped.map_err(|unknown| unknown_arm(name, &unknown))
}

fn unknown_arm(name: &str, error: &UnknownArm) -> SessionError {
    let help = question(proposals(name, Arm::names()))
        .unwrap_or_else(|| format!("{error}; another arm can be described in a file: --arm my-arm.toml"));
    SessionError::Setting { message: format!("the arm `{name}` is not known"), help }
}

fn described(path: Utf8PathBuf) -> Result<ArmFile, SessionError> {
    let text = val3_files::read_text(&path, FileClass::Settings).map_err(|reason| unusable(&path, reason))?;
    let arm = Arm::from_toml(&text).map_err(|error| unusable(&path, error))?;
    Ok(ArmFile { arm, text })
}

fn unusable(path: &Utf8Path, reason: impl Display) -> SessionError {
    SessionError::Setting {
        message: format!("the arm of `{path}` cannot be used: {reason}"),
        help: "a shipped file shows the form: `val3 arm show TX2-90`".to_owned(),
    }
}
