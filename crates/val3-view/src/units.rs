//! Conversions between data of the application and the arm. Lengths of data are in the length unit of the application
//! (2.1.4.1); everything else in this crate and its messages is in mm and degrees.

use val3_geometry::{Trsf, Vector3};
use val3_kinematics::Joints;
use val3_lang::references::Poses;
use val3_lang::values::JointValue;
use val3_machine::controller::Controller;

use crate::numbers;

/// Poses of the application's frames, tools and points, in mm.
pub(crate) fn poses(controller: &Controller) -> Poses<'_> {
    Poses::new(&controller.vm.space.memory, controller.length_unit())
}

/// Coordinates of a frame, tool or point in its father, as data of the application. `pose` is in mm.
pub(crate) fn data_of_pose(pose: &Trsf, controller: &Controller) -> [f64; 6] {
    numbers(&pose.scaled(1.0 / controller.length_unit().millimetres()))
}

/// Position as data of the application. `position` is in mm.
pub(crate) fn data_of_position(position: &Vector3<f64>, controller: &Controller) -> [f64; 3] {
    (position / controller.length_unit().millimetres()).into()
}

/// Joint position of the arm as data of the application, one number for each axis.
pub(crate) fn data_of_joints(joints: Joints, controller: &Controller) -> Vec<f64> {
    let model = controller.arm().model();
    let JointValue(numbers) = JointValue::of(joints, model, controller.length_unit().millimetres());
    numbers.into_iter().take(model.axes()).collect()
}

/// Joint position of the application as joints of the arm, in degrees and mm. Missing axes are at 0.
pub(crate) fn joints_of_data(values: &[f64], controller: &Controller) -> Joints {
    let mut joints = Joints::default();
    for (joint, value) in joints.iter_mut().zip(values) {
        *joint = *value;
    }
    JointValue(joints).joints(controller.arm().model(), controller.length_unit().millimetres())
}
