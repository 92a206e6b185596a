//! Joint positions that reach a point or joint position (`pointToJoint`, 9.6.3).

use val3_geometry::{IsometryMatrix3, Trsf};
use val3_kinematics::Joints;
use val3_lang::call::PointRef;
use val3_lang::references::Poses;
use val3_lang::types::BaseType;
use val3_lang::values::ConfigValue;
use val3_machine::controller::Controller;

use super::lookup::tool_pose;
use crate::positions::{self, GlobalValue};
use crate::wire::{ArmSolution, CommandError, Reached, Solved, ToolName, UnreachableValue};
use crate::{configuration, units};

/// Tolerance within which two joint positions are equal, in degrees or mm.
const SAME_JOINTS: f64 = 1e-6;

/// Reason for a value that the program has removed since the page received it.
const NO_VALUE: &str = "it has no value any more";

/// Computes the joints in each configuration, or the reason why the arm cannot reach the value.
pub(super) fn solve(
    datum: &GlobalValue,
    tool: Option<ToolName>,
    controller: &Controller,
) -> Result<Solved, CommandError> {
    let is_scara = positions::is_for_scara(&controller.vm.space.memory, datum.place);
    if is_scara != controller.arm().model().is_scara() {
        return Err(CommandError(format!("`{}` is for another kind of arm", datum.name)));
    }
    if datum.base == BaseType::Joint {
        return Ok(Solved { solutions: vec![of_joint(datum, controller)] });
    }
    let memory = &controller.vm.space.memory;
    let pose = units::poses(controller).of_point(PointRef(datum.place));
    let pose = pose.map_err(|fault| CommandError(format!("the point has no frame (error {})", fault.0)))?;
    let flange = pose * tool_pose(tool, controller)?.inverse();
    let config = configuration::of_point(memory, datum.place, is_scara).unwrap_or(ConfigValue([0.0; 3]));
    Ok(Solved { solutions: of_pose(&flange, &config, controller) })
}

/// Lists the points and joint positions out of reach of a tool.
pub(super) fn unreachable(tool: Option<ToolName>, controller: &Controller) -> Result<Reached, CommandError> {
    let tool = tool_pose(tool, controller)?;
    Ok(Reached { unreachable: out_of_reach(&tool, &positions::data(controller), controller) })
}

/// Lists the points and joint positions to which `movej` with a tool cannot move the arm, with the reasons: out of
/// reach, no frame, or for another kind of arm. `tool` is the pose of the tool centre point on the flange.
pub(crate) fn out_of_reach(
    tool: &IsometryMatrix3<f64>,
    data: &[GlobalValue],
    controller: &Controller,
) -> Vec<UnreachableValue> {
    let tool = tool.inverse();
    let mut poses = units::poses(controller);
    let unreachable = data.iter().filter_map(|datum| {
        let reason = obstacle(datum, &tool, &mut poses, controller)?;
        Some(UnreachableValue { name: datum.name.clone(), key: datum.key.clone(), reason })
    });
    unreachable.collect()
}

/// Reason why `movej` cannot move the arm to a value; `None` if it can. `tool` is the inverse pose of the tool.
fn obstacle(
    datum: &GlobalValue,
    tool: &IsometryMatrix3<f64>,
    poses: &mut Poses<'_>,
    controller: &Controller,
) -> Option<String> {
    let (memory, model) = (&controller.vm.space.memory, controller.arm().model());
    match datum.base {
        BaseType::Joint | BaseType::Point if positions::is_for_scara(memory, datum.place) != model.is_scara() => {
            Some("it is for another kind of arm".to_owned())
        }
        BaseType::Joint => of_joint(datum, controller).reason,
        BaseType::Point => {
            let pose = match poses.of_point(PointRef(datum.place)) {
                Ok(pose) => pose,
                Err(fault) => return Some(format!("it has no frame (error {})", fault.0)),
            };
            let Some(config) = configuration::of_point(memory, datum.place, model.is_scara()) else {
                return Some(NO_VALUE.to_owned());
            };
            let solved = model.solve(&Trsf::from(pose * tool), &controller.arm().joint(), config.requested());
            solved.err().map(|reason| reason.to_string())
        }
        _ => None,
    }
}

fn of_joint(datum: &GlobalValue, controller: &Controller) -> ArmSolution {
    let model = controller.arm().model();
    let Some(values) = positions::all_nums(&controller.vm.space.memory, datum.place) else {
        return ArmSolution { config: None, joints: None, reason: Some(NO_VALUE.to_owned()), is_chosen: false };
    };
    let joints = units::joints_of_data(&values, controller);
    let violation = model.violations(&joints).next();
    ArmSolution {
        config: None,
        joints: violation.is_none().then(|| joints.into_iter().take(model.axes()).collect()),
        reason: violation.map(|violation| violation.to_string()),
        is_chosen: violation.is_none(),
    }
}

fn of_pose(flange: &IsometryMatrix3<f64>, config: &ConfigValue, controller: &Controller) -> Vec<ArmSolution> {
    let model = controller.arm().model();
    let near = controller.arm().joint();
    let chosen = model.solve(&Trsf::from(*flange), &near, config.requested()).ok();
    let mut is_open = true;
    let solutions = model.branches().iter().map(|branch| {
        let words = ConfigValue::of(*branch, model.is_scara());
        let joints = model.inverse_isometry_on(*branch, flange, &near);
        // At a singular position, several branches have the same joints. Only the first one is marked.
        let is_chosen = is_open && joints.is_ok_and(|joints| chosen.is_some_and(|chosen| is_same(&joints, &chosen)));
        is_open &= !is_chosen;
        ArmSolution {
            config: Some(configuration::words(&words, model.is_scara())),
            joints: joints.ok().map(|joints| joints.into_iter().take(model.axes()).collect()),
            reason: joints.err().map(|reason| reason.to_string()),
            is_chosen,
        }
    });
    solutions.collect()
}

fn is_same(left: &Joints, right: &Joints) -> bool {
    left.iter().zip(right).all(|(left, right)| (left - right).abs() < SAME_JOINTS)
}
