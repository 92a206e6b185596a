//! Reachability of positions by the arm.

use smol_str::SmolStr;
use val3_analysis::arm::{ArmOrigin, arm};
use val3_analysis::db::{Db, Project};
use val3_analysis::items::positions::TaughtPosition;
use val3_analysis::placement::{Unplaced, placement, shown};
use val3_analysis::reach::reach;
use val3_analysis::targets::targets;
use val3_geometry::IsometryMatrix3;
use val3_kinematics::{Arm, Joints};
use val3_lang::data_path::DataPath;
use val3_lang::types::{self, BaseType};

use crate::markdown::code;

/// Reason why an untaught position is not examined.
pub(crate) const UNTAUGHT: &str = "all values are 0: it has not been taught";

/// Reachability of a position.
pub(crate) enum Reached {
    /// All values are 0: the point was declared but not taught.
    Untaught,
    /// Tool (or flange) with which it was computed, and the joints, or the reason why there is no solution. The tool is
    /// the tool of all moves to the position, otherwise the flange.
    WithTool(String, Result<Joints, String>),
}

/// Arm of a project; `None` unless the files name an arm and its kind suits the value.
pub(crate) fn arm_of<'db>(db: &'db dyn Db, project: Project, value: &TaughtPosition) -> Option<&'db Arm> {
    named_arm(db, project).filter(|arm| is_for(arm, value))
}

/// Arm of a project; `None` unless the files name an arm.
pub(crate) fn named_arm(db: &dyn Db, project: Project) -> Option<&Arm> {
    let arm = arm(db, project).as_ref().ok().filter(|arm| arm.origin == ArmOrigin::Named)?;
    Some(arm.model.as_ref())
}

fn is_for(arm: &Arm, value: &TaughtPosition) -> bool {
    let kind = if arm.is_scara() { types::Arm::Scara } else { types::Arm::SixAxis };
    value.arm.is_none_or(|arm| arm == kind)
}

/// Reachability of a point or frame origin at `point` in `world`.
pub(crate) fn reached_with_tool(
    db: &dyn Db,
    owner: Project,
    path: &str,
    value: &TaughtPosition,
    point: &IsometryMatrix3<f64>,
    arm: &Arm,
) -> Reached {
    if value.ty == BaseType::Point && value.is_zero() {
        return Reached::Untaught;
    }
    let (tool, pose) = only_tool(db, owner, path).unwrap_or_else(|| ("flange".to_owned(), IsometryMatrix3::identity()));
    let joints = reach(arm, &(point * pose.inverse()), value.configuration.requested());
    Reached::WithTool(tool, joints.map_err(|reason| reason.to_string()))
}

/// Tool of all moves to a point; `None` if they use several tools.
fn only_tool(db: &dyn Db, owner: Project, path: &str) -> Option<(String, IsometryMatrix3<f64>)> {
    let uses = targets(db, owner)
        .get(DataPath::new(path).before_index())
        .filter(|uses| !uses.is_open && uses.tools.len() == 1)?;
    let tool = uses.tools.iter().next()?;
    Some((shown(tool), placement(db, owner, tool).ok()?.pose))
}

/// Descriptions of the axes outside their ranges.
pub(crate) fn outside(arm: &Arm, joints: &Joints) -> Vec<String> {
    let outside = arm.violations(joints);
    outside
        .map(|found| {
            format!("axis {} is outside its range from {} to {} {}", found.axis, found.min, found.max, found.unit)
        })
        .collect()
}

/// Reason why the pose of a position is unknown.
pub(crate) fn not_placed(reason: &Unplaced) -> String {
    match reason {
        Unplaced::Unwritten(path) => {
            format!("its placement is unknown: {} is not in the data files", code(&shown(path)))
        }
        Unplaced::NoFather(path) => format!("its placement is unknown: {} has no father", code(&shown(path))),
        Unplaced::Loop { first, count } => {
            let quoted = |path: &SmolStr| code(&shown(path));
            let mut names: Vec<String> = first.iter().map(quoted).collect();
            if let Some(others @ 1..) = count.checked_sub(first.len()) {
                names.push(format!("{others} others"));
            }
            names.extend(first.first().map(quoted));
            format!("its placement is unknown: the fathers form a loop, {}", names.join(" on "))
        }
    }
}

/// Rounds to thousandths, without a negative zero.
pub(crate) fn rounded(number: f64) -> f64 {
    (number * 1000.0).round() / 1000.0 + 0.0
}
