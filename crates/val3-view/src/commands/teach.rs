//! Teaching: sets data to the current position of the arm (`here` and `herej`, 9.6.3 and 9.2.3).

use val3_geometry::Trsf;
use val3_kinematics::Joints;
use val3_lang::call::{FrameRef, PointRef};
use val3_lang::memory::Place;
use val3_lang::references;
use val3_lang::types::BaseType;
use val3_lang::values::ConfigValue;
use val3_machine::controller::Controller;

use super::father;
use super::lookup::tool_pose;
use super::store::write;
use crate::positions::{self, GlobalValue};
use crate::wire::{CommandError, ToolName};
use crate::{configuration, units};

/// Sets a point to the pose of a tool centre point with the configuration of the arm, or a joint position to the joints
/// of the arm. A point is taught in its frame, or in a new `frame`, which becomes its father. A `movej` to the new
/// value does not change the joints.
pub(super) fn teach(
    datum: &GlobalValue,
    tool: Option<ToolName>,
    frame: Option<Place>,
    controller: &mut Controller,
) -> Result<(), CommandError> {
    let is_scara = positions::is_for_scara(&controller.vm.space.memory, datum.place);
    if is_scara != controller.arm().model().is_scara() {
        return Err(CommandError(format!("`{}` is for another kind of arm", datum.name)));
    }
    match datum.base {
        BaseType::Joint => teach_joint(datum, controller),
        _ => teach_point(datum, tool, frame, is_scara, controller),
    }
}

fn teach_joint(joint: &GlobalValue, controller: &mut Controller) -> Result<(), CommandError> {
    let joints = units::data_of_joints(controller.arm().joint(), controller);
    write(joint, (0..).zip(joints), controller)
}

fn teach_point(
    point: &GlobalValue,
    tool: Option<ToolName>,
    new_frame: Option<Place>,
    is_scara: bool,
    controller: &mut Controller,
) -> Result<(), CommandError> {
    let (memory, arm) = (&controller.vm.space.memory, controller.arm());
    let (joints, model) = (arm.joint(), arm.model());
    let here = model.flange(&joints) * tool_pose(tool, controller)?;
    let frame =
        new_frame.map_or_else(|| references::frame_of(memory, PointRef(point.place)), |frame| Ok(FrameRef(frame)));
    let frame = frame.and_then(|FrameRef(frame)| units::poses(controller).of_frame(FrameRef(frame)));
    let frame = frame.map_err(|fault| CommandError(format!("the point has no frame (error {})", fault.0)))?;
    let local = units::data_of_pose(&Trsf::from(frame.inverse() * here), controller);
    let present = configuration::of_point(memory, point.place, is_scara).unwrap_or(ConfigValue([0.0; 3]));
    let config = configuration::taught(present, ConfigValue::at(model, &joints), is_scara);
    if let Some(frame) = new_frame {
        father::link(point, frame, controller)?;
    }
    write(point, (0..).zip(local).chain(config), controller)
}

/// Joints from a command, in degrees and mm, which must be within the limits of the axes.
pub(super) fn joints_of(numbers: &[f64], controller: &Controller) -> Result<Joints, CommandError> {
    let model = controller.arm().model();
    if numbers.len() != model.axes() {
        return Err(CommandError(format!("a joint position has {} numbers", model.axes())));
    }
    let mut joints = Joints::default();
    for (joint, number) in joints.iter_mut().zip(numbers) {
        *joint = *number;
    }
    match model.violations(&joints).next() {
        Some(violation) => Err(CommandError(violation.to_string())),
        None => Ok(joints),
    }
}
