//! Inverse kinematics of calibrated arms (manual 11.4), by Newton's method from the nominal solution.

use nalgebra::{Matrix6, Vector6};
use val3_geometry::{IsometryMatrix3, Vector3};

use crate::{Arm, Joints, Unreachable};

/// Maximum number of iterations. If it is reached, the joints count as not computable.
const STEPS: usize = 20;

/// Error tolerance that ends the iteration: in mm, and as the sine of an angle.
const POSITION: f64 = 1e-10;
const ORIENTATION: f64 = 1e-13;

/// Largest accepted change of a joint in one iteration, in degrees or mm. A larger change would leave the neighbourhood
/// of the nominal solution.
const LONGEST_STEP: f64 = 30.0;

/// Returns the joints near `start` at which the flange has the pose `target`.
pub(crate) fn refine(arm: &Arm, target: &IsometryMatrix3<f64>, start: Joints) -> Result<Joints, Unreachable> {
    let mut joints = start;
    for _ in 0..STEPS {
        let error = error(&arm.flange(&joints), target);
        if is_small(arm, &error) {
            return Ok(joints);
        }
        let step = step(arm, &joints, &error).filter(|step| step.amax() < LONGEST_STEP);
        let step = step.ok_or(Unreachable::NotConverged)?;
        for (joint, change) in joints.iter_mut().zip(step.iter()) {
            *joint += change;
        }
    }
    Err(Unreachable::NotConverged)
}

fn is_small(arm: &Arm, error: &Vector6<f64>) -> bool {
    let position = error.fixed_rows::<3>(0).amax();
    // A SCARA arm cannot tilt its flange.
    let orientation = if arm.axes() == 6 { error.fixed_rows::<3>(3).amax() } else { error[5].abs() };
    position < POSITION && orientation.to_radians() < ORIENTATION
}

/// Returns the difference from `from` to `to` in world: in mm, and in degrees for small angles.
fn error(from: &IsometryMatrix3<f64>, to: &IsometryMatrix3<f64>) -> Vector6<f64> {
    let position = to.translation.vector - from.translation.vector;
    let (left, right) = (from.rotation.matrix(), to.rotation.matrix());
    let axis = (0..3).map(|column| left.column(column).cross(&right.column(column))).sum::<Vector3<f64>>() * 0.5;
    let turn = axis.map(f64::to_degrees);
    Vector6::new(position.x, position.y, position.z, turn.x, turn.y, turn.z)
}

/// Returns the joint changes that remove the error in a linear approximation.
fn step(arm: &Arm, joints: &Joints, error: &Vector6<f64>) -> Option<Vector6<f64>> {
    let mut matrix = Matrix6::zeros();
    for (mut column, twist) in matrix.column_iter_mut().zip(arm.jacobian(joints)) {
        column.fixed_rows_mut::<3>(0).copy_from(&twist.linear);
        column.fixed_rows_mut::<3>(3).copy_from(&twist.angular);
    }
    let mut error = *error;
    if arm.is_scara() {
        // No axis of a SCARA arm changes the tilt. Conditions on the two columns without an axis replace the two tilt
        // rows.
        matrix.row_mut(3).fill(0.0);
        matrix.row_mut(4).fill(0.0);
        (matrix.m45, matrix.m56) = (1.0, 1.0);
        (error.w, error.a) = (0.0, 0.0);
    }
    matrix.lu().solve(&error)
}
