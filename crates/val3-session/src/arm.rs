//! The model of the arm: that of the settings, else that of `val3.toml`, else that of the cell.

use std::sync::Arc;

use camino::{Utf8Path, Utf8PathBuf};
use salsa::Setter as _;
use val3_analysis::arm::RequestedArm;
use val3_analysis::db::{Configuration, Database, Project};
use val3_analysis::load::LoadError;
use val3_config::{ArmModel, ArmSetting, ConfigFile};
use val3_files::FileClass;
use val3_kinematics::{Arm, UnknownArm};
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
    let configured = file.and_then(|file| Some((file, file.config.arm.as_ref()?)));
    configured.map_or(Ok(None), |(file, setting)| model(setting, file.folder()).map_err(|error| in_file(file, error)))
}

/// The error with the line of a `val3.toml`.
fn in_file(file: &ConfigFile, error: SessionError) -> SessionError {
    match error {
        SessionError::Setting { message, help } => {
            SessionError::Load(LoadError::Configuration(vec![file.fault("arm", message, help)]))
        }
        other => other,
    }
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
    // A name that begins like that of a known kind of arm need not be one.
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

/// The arm of a setting, whose files are relative to `folder`; `None` where it only says the kind.
pub(crate) fn model(setting: &ArmSetting, folder: &Utf8Path) -> Result<Option<ChosenArm>, SessionError> {
    Ok(read(setting, folder)?.map(|file| {
        let name = match setting.model() {
            Some(ArmModel::Name(name)) => name.to_owned(),
            _ => file.arm.name().to_owned(),
        };
        ChosenArm { model: file.arm, name }
    }))
}

/// An arm and the text of its file.
pub struct ArmFile {
    /// The arm.
    pub arm: Arm,
    /// Text of the file, in TOML.
    pub text: String,
}

impl ArmFile {
    /// The arm of `--arm`: a shipped model (`tx2-60l`) or the path of a file (`my-arm.toml`).
    ///
    /// # Errors
    /// There is no such model, the name is only a kind of arm, or the file has a fault.
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
    let unknown = |unknown: UnknownArm| SessionError::Setting {
        message: format!("the arm `{name}` is not known"),
        help: question(proposals(name, Arm::names()))
            .unwrap_or_else(|| format!("{unknown}; another arm can be described in a file: --arm my-arm.toml")),
    };
    let text = Arm::file(name).map_err(unknown)?.to_owned();
    Ok(ArmFile { arm: Arm::by_name(name).map_err(unknown)?, text })
}

fn described(path: Utf8PathBuf) -> Result<ArmFile, SessionError> {
    let failed = |reason: String| SessionError::Setting {
        message: format!("the arm of `{path}` cannot be used: {reason}"),
        help: "a shipped file shows the form: `val3 arm show TX2-90`".to_owned(),
    };
    let text = val3_files::read_text(&path, FileClass::Settings).map_err(|reason| failed(reason.to_string()))?;
    let arm = Arm::from_toml(&text).map_err(|error| failed(error.to_string()))?;
    Ok(ArmFile { arm, text })
}
