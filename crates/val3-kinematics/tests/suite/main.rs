//! Tests of the shipped arms.

#![allow(missing_docs, reason = "tests are named by their functions")]
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "a test may fail loudly"
)]

mod calibration;
mod files;
mod laws;
mod peer;
mod poses;
mod shapes;
mod singular;
mod speeds;

use val3_geometry::IsometryMatrix3;
use val3_kinematics::{Arm, Joints};

fn arm(name: &str) -> Arm {
    Arm::by_name(name).unwrap()
}

/// Returns the distance between two poses in mm, and the largest difference between their rotation matrices' entries.
fn difference(left: &IsometryMatrix3<f64>, right: &IsometryMatrix3<f64>) -> (f64, f64) {
    let rotation = (left.rotation.matrix() - right.rotation.matrix()).amax();
    ((left.translation.vector - right.translation.vector).norm(), rotation)
}

/// Returns the largest difference between two positions of the same axis.
fn apart(left: &Joints, right: &Joints) -> f64 {
    left.iter().zip(right).map(|(left, right)| (left - right).abs()).fold(0.0, f64::max)
}

/// Returns joint positions in the arm's ranges, the same in every run.
fn positions(arm: &Arm, count: usize) -> impl Iterator<Item = Joints> {
    let mut state = 0x2545_f491_4f6c_dd1d_u64;
    std::iter::repeat_with(move || {
        let mut joints = Joints::default();
        for (joint, axis) in joints.iter_mut().zip(arm.limits()) {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            *joint = axis.min + (axis.max - axis.min) * ((state >> 11) as f64 / (1_u64 << 53) as f64);
        }
        joints
    })
    .take(count)
}
