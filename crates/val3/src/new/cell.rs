//! Controller of a new application: arm, version and settings.

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::arm::shipped;
use val3_analysis::load::nearest_configuration;
use val3_analysis::system::Disk;
use val3_config::{ArmModel, ConfigFile, FILE_NAME};
use val3_files::{FileClass, Unreadable};
use val3_kinematics::{Arm, DEFAULT_SCARA, DEFAULT_SIX_AXIS};
use val3_lang::types;
use val3_lang::versions::{KNOWN, Version};
use val3_session::ArmFile;
use val3_syntax::encoding::decode;
use val3_syntax::{arm_file, version_file};

use super::place::NewLocation;
use crate::args::NewArgs;
use crate::paths::Paths;
use crate::user_error::UserError;

/// Arm of a new application if neither the cell nor the arguments name one.
const DEFAULT_ARM: &str = "tx2-90";

/// Name prefixes of arms with a CS9 controller.
const CS9_ARMS: [&str; 2] = ["TX2", "TS2"];

/// Controller of a new application.
pub(super) struct Controller {
    /// Arm.
    pub(super) arm: Arm,
    /// VAL 3 version.
    pub(super) version: Version,
    /// Whether runs start with arm power.
    pub(super) has_power: bool,
    /// New settings; `None` if a file already names the arm.
    pub(super) settings: Option<NewSettings>,
}

/// A new `val3.toml` that names the arm.
pub(super) struct NewSettings {
    /// Path.
    pub(super) path: Utf8PathBuf,
    arm: String,
}

impl NewSettings {
    /// Folder of the file.
    pub(super) fn folder(&self) -> &Utf8Path {
        self.path.parent().unwrap_or(&self.path)
    }

    /// Name of the file.
    pub(super) fn file_name(&self) -> &str {
        self.path.file_name().unwrap_or(FILE_NAME)
    }

    /// Text of the file.
    pub(super) fn text(&self) -> String {
        include_str!("template/val3.toml").replace("{arm}", &self.arm)
    }
}

/// Arm named by a file of the cell.
struct CellArm {
    arm: Arm,
    /// File that names the arm.
    file: Utf8PathBuf,
}

impl Controller {
    /// Kind of the arm.
    pub(super) fn kind(&self) -> types::Arm {
        if self.arm.is_scara() { types::Arm::Scara } else { types::Arm::SixAxis }
    }

    /// Reads the controller of the cell. The arguments take precedence.
    ///
    /// # Errors
    /// The arm is unknown or differs from the cell's arm, or a file of the cell cannot be read.
    pub(super) fn of(place: &NewLocation, args: &NewArgs, paths: &Paths) -> Result<Self, UserError> {
        let requested = args.arm.as_deref().map(shipped).transpose().map_err(unknown_arm)?.map(|arm| Arm::clone(&arm));
        let configuration = if place.exists { configuration(&place.usrapp, paths)? } else { None };
        let of_cell = if place.exists { cell_arm(place, configuration.as_ref(), paths)? } else { None };
        let has_power = configuration.as_ref().is_some_and(|file| file.config.run.power);
        let cell_version = if place.exists { cell_version(place, paths)? } else { None };
        let version = |arm: &Arm| args.version.or(cell_version).unwrap_or_else(|| newest_version(arm));

        let (arm, settings) = match (requested, of_cell) {
            (Some(requested), Some(cell)) if requested.name() != cell.arm.name() => {
                let (file, arm) = (paths.shown(&cell.file), cell.arm.name());
                return Err(UserError::new(format!("the arm of this cell is a {arm} ({file})"))
                    .with_help("omit --arm, or name a folder outside of the cell: --folder DIR"));
            }
            (_, Some(cell)) => (cell.arm, None),
            (Some(requested), None) if let Some(file) = &configuration => {
                let (file, name) = (paths.shown(&file.path), requested.name().to_lowercase());
                return Err(UserError::new(format!("the arm is not that of this cell: `{file}` does not name it"))
                    .with_help(format!("add `arm = \"{name}\"` to the beginning of that file")));
            }
            (requested, None) => {
                let arm = requested.map_or_else(|| shipped(DEFAULT_ARM).map(|arm| Arm::clone(&arm)), Ok);
                let arm = arm.map_err(unknown_arm)?;
                let name = arm.name().to_lowercase();
                let folder = place.cell.as_ref().unwrap_or(&place.usrapp);
                let settings = NewSettings { path: folder.join(FILE_NAME), arm: name };
                (arm, configuration.is_none().then_some(settings))
            }
        };
        Ok(Self { version: version(&arm), arm, has_power: has_power || settings.is_some(), settings })
    }
}

fn unknown_arm(reason: impl ToString) -> UserError {
    UserError::new(reason.to_string()).with_help("`val3 arm list` lists the arms")
}

/// Newest known version of the arm's controller: CS9 for TX2 and TS2 arms, otherwise CS8.
fn newest_version(arm: &Arm) -> Version {
    let major = if CS9_ARMS.iter().any(|start| arm.name().starts_with(start)) { 8 } else { 7 };
    let mut known = KNOWN.iter().filter_map(|text| Version::parse(text));
    known.find(|version| version.major == major).unwrap_or_default()
}

/// Settings for applications in the folder.
fn configuration(usrapp: &Utf8Path, paths: &Paths) -> Result<Option<ConfigFile>, UserError> {
    nearest_configuration(&Disk, usrapp).map_err(|error| {
        UserError::new(format!("{}: {}", paths.shown(&error.path), error.message)).with_help(error.help)
    })
}

/// Arm in the settings, otherwise in the cell's files.
fn cell_arm(
    place: &NewLocation,
    configuration: Option<&ConfigFile>,
    paths: &Paths,
) -> Result<Option<CellArm>, UserError> {
    let named = configuration.and_then(|file| Some((file, file.config.arm.as_ref()?)));
    let kind = named.and_then(|(_, setting)| setting.kind());
    if let Some((file, setting)) = named
        && let Some(model) = setting.model()
    {
        let name = match model {
            ArmModel::Name(name) => name.to_owned(),
            ArmModel::File(path) => file.folder().join(path).into_string(),
        };
        return Ok(Some(CellArm { arm: ArmFile::named(&name)?.arm, file: file.path.clone() }));
    }
    let files = ["arm.cfx", "cell.cfx"].map(|name| (place, name));
    let mut read = Vec::new();
    for (place, name) in files {
        if let Some((path, text)) = cell_file(place, name, paths)? {
            read.push((path, arm_file::ArmFile::read(&text)));
        }
    }
    let model = read.iter().find_map(|(path, file)| Some((path, file.model.as_deref()?, file.length_axis3.as_deref())));
    let (arm, file) = match (model, named) {
        (Some((path, model, length)), _) => match Arm::by_settings(model, length) {
            Ok(arm) => (arm, path.clone()),
            Err(unknown) => return Err(unknown_arm(format!("{}: {unknown}", paths.shown(path)))),
        },
        (None, Some((file, _))) => {
            let name = if kind == Some(types::Arm::Scara) { DEFAULT_SCARA } else { DEFAULT_SIX_AXIS };
            (Arm::by_name(name).map_err(unknown_arm)?, file.path.clone())
        }
        (None, None) => return Ok(None),
    };
    let ranges = read.iter().flat_map(|(_, file)| &file.ranges);
    let arm = ranges.fold(arm, |arm, [min, max]| arm.clone().with_limits(min, max).unwrap_or(arm));
    Ok(Some(CellArm { arm, file }))
}

/// VAL 3 version in the cell's files.
fn cell_version(place: &NewLocation, paths: &Paths) -> Result<Option<Version>, UserError> {
    let text = cell_file(place, "val3version.xml", paths)?;
    let version = text.and_then(|(_, text)| Version::parse(&version_file::language(&text)?));
    Ok(version.filter(|version| [7, 8].contains(&version.major)))
}

/// Path and text of a file in `usr/configs`, if it exists.
fn cell_file(place: &NewLocation, name: &str, paths: &Paths) -> Result<Option<(Utf8PathBuf, String)>, UserError> {
    let Some(usr) = place.usrapp.parent() else { return Ok(None) };
    let path = usr.join("configs").join(name);
    match val3_files::read(&path, FileClass::Cell) {
        Ok(bytes) => Ok(Some((path, decode(bytes).text))),
        Err(Unreadable::Missing) => Ok(None),
        Err(reason) => Err(UserError::new(format!("`{}` cannot be read: {reason}", paths.shown(&path)))),
    }
}
