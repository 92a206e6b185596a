//! Poses of the points, frames, tools and joints in a data file, for its tables.

use rustc_hash::FxHashSet;
use val3_analysis::changes::is_changed;
use val3_analysis::db::{Db, File, Project};
use val3_analysis::items::parse;
use val3_analysis::items::positions::each;
use val3_analysis::placement::{joints, placement, position, shown};
use val3_geometry::{IsometryMatrix3, Trsf};
use val3_kinematics::{Arm, Joints};
use val3_lang::data_path::DataPath;
use val3_lang::types::BaseType;

use crate::data_tables::{DataPlace, place_of_path};
use crate::reached::{Reached, UNTAUGHT, arm_of, named_arm, not_placed, outside, reached_with_tool, rounded};

/// Maximum chain length. Without it, the response size could grow with the square of the number of values.
const LONGEST_CHAIN: usize = 100;

/// Pose of a value, and the joint position in which the arm reaches it.
#[derive(Debug, Clone, PartialEq)]
pub struct DataPose {
    /// The value.
    pub place: DataPlace,
    /// Pose in `world` (of a tool: on the flange; of joints: of the flange): x, y, z in mm and rx, ry, rz in degrees.
    pub pose: Option<[f64; 6]>,
    /// The value and its nearest fathers, at most 100 in total, without the built-in father.
    pub chain: Vec<String>,
    /// Whether the arm reaches it; `None` if unknown, or for a tool.
    pub reach: Option<PoseReach>,
    /// Reason why the pose or the joints are unknown, or the tool with which they are reached.
    pub remark: Option<String>,
    /// Joint positions in degrees; linear axes in mm.
    pub joints: Option<Vec<f64>>,
}

/// Whether the arm reaches a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PoseReach {
    /// The arm reaches it.
    Reachable,
    /// The arm does not reach it.
    OutOfReach,
    /// No file names the arm.
    NoArm,
}

/// Remark for [`PoseReach::NoArm`].
const NO_ARM: &str = "no arm is named: name yours in val3.toml (`arm`) or in arm.cfx";

/// Poses of all values in a data file that belong to the variables `names`, as part of `project`.
pub fn data_poses(db: &dyn Db, project: Project, file: File, names: &[String]) -> Vec<DataPose> {
    let wanted: FxHashSet<&str> = names.iter().map(String::as_str).collect();
    let parse = parse(db, file);
    let mut paths = Vec::new();
    each(parse.view(), &mut |value| {
        if wanted.contains(DataPath::new(&value.path).before_index()) {
            paths.push(value.path);
        }
    });
    paths.into_iter().filter_map(|path| pose(db, project, &path)).collect()
}

fn pose(db: &dyn Db, project: Project, path: &str) -> Option<DataPose> {
    let value = position(db, project, path)?;
    let empty =
        DataPose { place: place_of_path(path), pose: None, chain: Vec::new(), reach: None, remark: None, joints: None };
    let arm = arm_of(db, project, value);
    let has_arm = named_arm(db, project).is_some();
    match value.ty {
        BaseType::Joint if !has_arm => Some(without_arm(empty)),
        BaseType::Joint => arm.map(|arm| {
            let found = of_joints(arm, &joints(db, project, value, arm), empty);
            with_changes(found, is_changed(db, project, path))
        }),
        BaseType::Point | BaseType::Frame | BaseType::Tool => Some(match placement(db, project, path) {
            Err(unplaced) => DataPose { remark: Some(not_placed(&unplaced)), ..empty },
            Ok(placed) => {
                let chain = placed.chain.iter().take(LONGEST_CHAIN).map(|path| shown(path)).collect();
                let found = DataPose { pose: Some(numbers(&placed.pose)), chain, ..empty };
                let found = match arm {
                    _ if value.ty == BaseType::Tool => found,
                    Some(arm) => {
                        let reached = reached_with_tool(db, project, path, value, &placed.pose, arm);
                        with_reach(found, arm, reached)
                    }
                    None if has_arm => found,
                    None => without_arm(found),
                };
                with_changes(found, placed.chain.iter().any(|path| is_changed(db, project, path)))
            }
        }),
        _ => None,
    }
}

/// Adds a remark if programs change the pose, because then it is only the initial pose.
fn with_changes(found: DataPose, is_changed: bool) -> DataPose {
    let changed = is_changed.then(|| "at the start; a program changes it or one of its fathers".to_owned());
    let remarks: Vec<String> = found.remark.into_iter().chain(changed).collect();
    DataPose { remark: (!remarks.is_empty()).then(|| remarks.join("; ")), ..found }
}

/// Adds that the reach is unknown, because no file names the arm.
fn without_arm(found: DataPose) -> DataPose {
    DataPose { reach: Some(PoseReach::NoArm), remark: Some(NO_ARM.to_owned()), ..found }
}

/// Adds whether the arm reaches the pose, and with which joint values.
fn with_reach(found: DataPose, arm: &Arm, reached: Reached) -> DataPose {
    match reached {
        Reached::Untaught => DataPose { remark: Some(UNTAUGHT.to_owned()), ..found },
        Reached::WithTool(tool, Ok(joints)) => DataPose {
            reach: Some(PoseReach::Reachable),
            remark: Some(format!("{} with `{tool}`", arm.name())),
            joints: Some(axes(arm, &joints)),
            ..found
        },
        Reached::WithTool(tool, Err(reason)) => DataPose {
            reach: Some(PoseReach::OutOfReach),
            remark: Some(format!("{} with `{tool}`: {reason}", arm.name())),
            ..found
        },
    }
}

fn of_joints(arm: &Arm, joints: &Joints, found: DataPose) -> DataPose {
    let outside = outside(arm, joints);
    DataPose {
        pose: Some(numbers(&arm.flange(joints))),
        reach: Some(if outside.is_empty() { PoseReach::Reachable } else { PoseReach::OutOfReach }),
        remark: (!outside.is_empty()).then(|| outside.join(", ")),
        joints: Some(axes(arm, joints)),
        ..found
    }
}

fn axes(arm: &Arm, joints: &Joints) -> Vec<f64> {
    joints.iter().take(arm.axes()).map(|joint| rounded(*joint)).collect()
}

fn numbers(pose: &IsometryMatrix3<f64>) -> [f64; 6] {
    let Trsf { x, y, z, rx, ry, rz } = Trsf::from(*pose);
    [x, y, z, rx, ry, rz].map(rounded)
}

#[cfg(test)]
mod tests;
