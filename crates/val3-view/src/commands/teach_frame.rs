//! Teaching a frame with three positions of the arm (`setFrame`, 9.4.4).

use val3_geometry::{FrameError, Trsf, set_frame};
use val3_lang::call::FrameRef;
use val3_lang::references;
use val3_machine::controller::Controller;

use super::lookup::tool_pose;
use super::store::write;
use super::teach::joints_of;
use crate::positions::GlobalValue;
use crate::units;
use crate::wire::{CommandError, ToolName};

/// Minimum distance of taught positions, in mm. An error of 0.1 mm then rotates the frame by less than 1 degree.
const SMALLEST_DISTANCE: f64 = 10.0;

/// Computes a frame from three joint positions, in which the tool centre point is at the origin, on the positive x
/// axis, and in the xy plane at positive y.
pub(super) fn teach_frame(
    frame: &GlobalValue,
    tool: Option<ToolName>,
    joints: &[Vec<f64>; 3],
    controller: &mut Controller,
) -> Result<(), CommandError> {
    let tool = tool_pose(tool, controller)?;
    let memory = &controller.vm.space.memory;
    let father = references::reference(memory, frame.place).ok().flatten();
    let father = father.ok_or_else(|| CommandError(format!("the frame `{}` has no father", frame.name)))?;
    let father = units::poses(controller).of_frame(FrameRef(father));
    let father = father.map_err(|fault| CommandError(format!("a father has no father (error {})", fault.0)))?;
    let in_father = father.inverse();
    let mut taught = [Trsf::default(); 3];
    for (position, joints) in taught.iter_mut().zip(joints) {
        let flange = controller.arm().model().flange(&joints_of(joints, controller)?);
        *position = Trsf::from(in_father * flange * tool);
    }
    let [origin, on_x, on_plane] = &taught;
    check_distances(origin, on_x, on_plane).map_err(|error| CommandError(too_close(error)))?;
    let found = set_frame(origin, on_x, on_plane).map_err(|error| CommandError(too_close(error)))?;
    let found = units::data_of_pose(&found, controller);
    write(frame, (0..).zip(found), controller)
}

fn too_close(error: FrameError) -> String {
    format!("{error}; at least {SMALLEST_DISTANCE} mm are necessary")
}

/// Checks that the second position is far enough from the origin, and the third from the x axis.
fn check_distances(origin: &Trsf, on_x: &Trsf, on_plane: &Trsf) -> Result<(), FrameError> {
    let along = on_x.translation() - origin.translation();
    let x = along.try_normalize(SMALLEST_DISTANCE).ok_or(FrameError::AxisPoint)?;
    let in_plane = on_plane.translation() - origin.translation();
    let beside = in_plane - x * in_plane.dot(&x);
    beside.try_normalize(SMALLEST_DISTANCE).ok_or(FrameError::PlanePoint).map(|_| ())
}
