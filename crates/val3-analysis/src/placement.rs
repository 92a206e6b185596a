//! Placement of data: positions in `world` and tools on the flange, from the data files.

use rustc_hash::FxHashSet;
use smol_str::SmolStr;
use val3_geometry::{IsometryMatrix3, Trsf, chain};
use val3_lang::builtins;
use val3_lang::data_path::DataPath;
use val3_lang::types::BaseType;

use crate::db::{Db, Project};
use crate::items::manifest::length_unit;
use crate::items::positions::{TaughtPosition, positions};
use crate::items::project::items;

/// Pose of a position or tool, and its chain of fathers.
#[derive(Debug, Clone, PartialEq)]
pub struct Placement {
    /// Pose in `world`; for a tool, on the flange. Lengths in mm.
    pub pose: IsometryMatrix3<f64>,
    /// Data paths of the value and its fathers, without the built-in father.
    pub chain: Vec<SmolStr>,
}

/// Reason why a placement is unknown.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Unplaced {
    /// The data files contain no such value.
    Unwritten(SmolStr),
    /// The value has no father.
    NoFather(SmolStr),
    /// The fathers form a loop.
    Loop {
        /// First members of the loop, at most 20.
        first: Vec<SmolStr>,
        /// Number of members.
        count: usize,
    },
}

/// Maximum number of loop members in an error.
const MOST_OF_LOOP: usize = 20;

/// Returns the value at a data path such as `tSlots[1,2].pPlace[0]` in the data files of a project.
pub fn position<'db>(db: &'db dyn Db, project: Project, path: &str) -> Option<&'db TaughtPosition> {
    let item = items(db, project).data.get(DataPath::new(path).before_index())?;
    positions(db, item.file).get(path)
}

/// Computes the placement of a point, frame or tool.
///
/// # Errors
/// If the value or one of its fathers is unknown.
pub fn placement(db: &dyn Db, project: Project, path: &str) -> Result<Placement, Unplaced> {
    if is_built_in(path) {
        return Ok(Placement { pose: IsometryMatrix3::identity(), chain: Vec::new() });
    }
    let Some(value) = position(db, project, path) else { return Err(Unplaced::Unwritten(path.into())) };
    let father = value.father.clone().ok_or_else(|| Unplaced::NoFather(path.into()))?;
    let pose = father_pose(db, project, father.clone()).as_ref().map_err(Unplaced::clone)?;
    let unit = length_unit(db, project.manifest(db)).millimetres();
    let mut chain = vec![SmolStr::new(path)];
    chain.append(&mut chain_from(db, project, father)?);
    Ok(Placement { pose: pose * transformation(value).scaled(unit).isometry(), chain })
}

/// Returns the pose of a father, memoised because many values share it.
#[salsa::tracked]
fn father_pose(db: &dyn Db, project: Project, path: SmolStr) -> Result<IsometryMatrix3<f64>, Unplaced> {
    let fathers = chain_from(db, project, path)?;
    let unit = length_unit(db, project.manifest(db)).millimetres();
    let values = fathers.iter().filter_map(|path| position(db, project, path));
    let links: Vec<Trsf> = values.map(|value| transformation(value).scaled(unit)).collect();
    Ok(chain::resolve(&links))
}

/// Returns the data paths of a father and its fathers, without the built-in one. Not memoised, because the chains of
/// many values would need too much memory.
fn chain_from(db: &dyn Db, project: Project, path: SmolStr) -> Result<Vec<SmolStr>, Unplaced> {
    let (mut chain, mut known): (Vec<SmolStr>, FxHashSet<SmolStr>) = (Vec::new(), FxHashSet::default());
    let mut next = path;
    while !is_built_in(&next) {
        if !known.insert(next.clone()) {
            return Err(of_loop(&chain, &next));
        }
        let Some(value) = position(db, project, &next) else { return Err(Unplaced::Unwritten(next)) };
        chain.push(next.clone());
        next = value.father.clone().ok_or(Unplaced::NoFather(next))?;
    }
    Ok(chain)
}

/// Returns the loop at the end of a chain, beginning with `start`.
fn of_loop(chain: &[SmolStr], start: &SmolStr) -> Unplaced {
    let members = chain.iter().skip_while(|name| *name != start);
    let count = members.clone().count();
    Unplaced::Loop { first: members.take(MOST_OF_LOOP).cloned().collect(), count }
}

/// Returns the transformation of a value in the length unit of the application.
pub fn transformation(value: &TaughtPosition) -> Trsf {
    let [x, y, z, rx, ry, rz] = value.numbers;
    Trsf::new([x, y, z], [rx, ry, rz])
}

/// Returns the joints of a value in degrees; in mm for a linear axis.
pub fn joints(db: &dyn Db, project: Project, value: &TaughtPosition, arm: &val3_kinematics::Arm) -> [f64; 6] {
    let unit = length_unit(db, project.manifest(db)).millimetres();
    let mut joints = value.numbers;
    joints.iter_mut().enumerate().filter(|(axis, _)| arm.is_stroke(*axis)).for_each(|(_, joint)| *joint *= unit);
    joints
}

/// Whether the data path is `world` or `flange`, where every chain ends. Files of s5 and s6 declare them, too.
fn is_built_in(path: &str) -> bool {
    let name = path.strip_suffix("[0]").unwrap_or(path);
    builtins::find(name)
        .is_some_and(|builtin| builtin.is_variable && matches!(builtin.ty, BaseType::Frame | BaseType::Tool))
}

/// Formats a data path as in programs: `tSlots[1,2].pPlace` for `tSlots[1,2].pPlace[0]`, `pPick["near"]` for
/// `pPick[near]`.
pub fn shown(path: &str) -> String {
    DataPath::new(path).in_code()
}
