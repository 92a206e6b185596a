//! Arm model of a project, for checks of positions and moves.

#![allow(missing_docs, reason = "the builders and setters that salsa generates cannot be documented")]

use std::sync::Arc;

use camino::Utf8Path;
use smol_str::{SmolStr, format_smolstr};
use val3_config::ArmModel;
use val3_kinematics::{Arm, DEFAULT_SCARA, DEFAULT_SIX_AXIS};
use val3_lang::suggest::{proposals, question};
use val3_lang::types;

use crate::db::{Db, Project};
use crate::items::project::items;

/// An arm that takes precedence over all configurations and cells.
#[salsa::input(singleton, debug)]
pub struct RequestedArm {
    /// Model of the arm.
    #[returns(ref)]
    pub arm: Arc<Arm>,
}

/// The arm of a project.
#[derive(Debug, Clone, PartialEq)]
pub struct ProjectArm {
    /// Model with the limits of the cell.
    pub model: Arc<Arm>,
    /// Source of the model.
    pub origin: ArmOrigin,
}

/// Source of a project's arm model.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ArmOrigin {
    /// Set on the command line, in `val3.toml` or in the cell.
    Named,
    /// The default arm, because no arm is set.
    Default,
    /// The default arm, because the cell's arm, named here, is unknown.
    Unknown(SmolStr),
}

/// Returns the arm of a project from the command line, `val3.toml`, the cell or the default, in this order. The error
/// is the reason why the arm of `val3.toml` cannot be used.
#[salsa::tracked]
pub fn arm(db: &dyn Db, project: Project) -> Result<ProjectArm, SmolStr> {
    let (model, origin) = match (RequestedArm::try_get(db), configured(db, project)) {
        (Some(requested), _) => (Arc::clone(requested.arm(db)), ArmOrigin::Named),
        (None, Some(configured)) => (configured?, ArmOrigin::Named),
        (None, None) => of_cell(db, project)?,
    };
    Ok(ProjectArm { model: narrowed(db, project, model), origin })
}

/// Returns the model of a shipped arm.
///
/// # Errors
/// No arm has this name.
pub fn shipped(name: &str) -> Result<Arc<Arm>, SmolStr> {
    Arm::by_name(name).map(Arc::new).map_err(|_| unknown_arm(name))
}

fn unknown_arm(name: &str) -> SmolStr {
    let hint = question(proposals(name, Arm::names()));
    let hint = hint.unwrap_or_else(|| "another arm can be described in a file that ends in `.toml`".to_owned());
    format_smolstr!("the arm `{name}` is not known; {hint}")
}

fn configured(db: &dyn Db, project: Project) -> Option<Result<Arc<Arm>, SmolStr>> {
    match project.config(db)?.arm.as_ref()?.model()? {
        ArmModel::Name(name) => Some(shipped(name)),
        ArmModel::File(path) => Some(described(db, project, path)),
    }
}

fn described(db: &dyn Db, project: Project, path: &Utf8Path) -> Result<Arc<Arm>, SmolStr> {
    let read = project.cell(db).and_then(|cell| cell.config(db).described_arm.clone());
    read.unwrap_or_else(|| Err(format_smolstr!("the arm of `{path}` was not read")))
}

fn of_cell(db: &dyn Db, project: Project) -> Result<(Arc<Arm>, ArmOrigin), SmolStr> {
    let files = project.cell(db).map_or(&[][..], |cell| cell.config(db).arm_files.as_slice());
    let named = files.iter().find_map(|file| Some((file.model.as_deref()?, file.length_axis3.as_deref())));
    let is_scara = items(db, project).arm == Some(types::Arm::Scara);
    let default = if is_scara { DEFAULT_SCARA } else { DEFAULT_SIX_AXIS };
    match named.map(|(name, length)| (name, Arm::by_settings(name, length))) {
        Some((_, Ok(model))) => Ok((Arc::new(model), ArmOrigin::Named)),
        Some((name, Err(_))) => Ok((shipped(default)?, ArmOrigin::Unknown(name.into()))),
        None => Ok((shipped(default)?, ArmOrigin::Default)),
    }
}

/// Returns the model with the limits of the cell. A limit that would leave an axis without a range has no effect.
fn narrowed(db: &dyn Db, project: Project, model: Arc<Arm>) -> Arc<Arm> {
    let files = project.cell(db).map_or(&[][..], |cell| cell.config(db).arm_files.as_slice());
    let ranges = files.iter().flat_map(|file| &file.ranges);
    ranges.fold(model, |model, [min, max]| Arm::clone(&model).with_limits(min, max).map_or(model, Arc::new))
}
