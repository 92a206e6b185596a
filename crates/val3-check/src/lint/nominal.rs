//! Moves with the nominal speeds of the arm, planned as in `val3 run`.

use std::sync::Arc;

use val3_geometry::IsometryMatrix3;
use val3_kinematics::{Arm, Joints};
use val3_motion::{
    Blend, Cause, DegreesPerSecond, Manner, MillimetresPerSecond, Motion, Move, MovePath, Seconds, SpeedLimits,
};

/// Duration of a cycle.
const CYCLE: Seconds = Seconds(0.004);

/// Maximum number of cycles of a move: ten minutes.
const MOST_CYCLES: usize = 150_000;

/// A move with the nominal speeds of the arm.
pub(super) fn nominal_move(arm: &Arm, path: &MovePath, tool: &IsometryMatrix3<f64>, blend: Blend) -> Move {
    let axes = [0, 1, 2, 3, 4, 5];
    let limits = SpeedLimits {
        speed: axes.map(|axis| arm.nominal_speed(axis)),
        acceleration: axes.map(|axis| arm.nominal_acceleration(axis)),
        deceleration: axes.map(|axis| arm.nominal_deceleration(axis)),
        translation: MillimetresPerSecond(f64::from(u16::MAX)),
        rotation: DegreesPerSecond(f64::from(u16::MAX)),
    };
    Move { path: path.clone(), tool: *tool, limits, blend, id: 0.0, manner: Manner::Rigid }
}

/// Joint position at the end of a path.
///
/// # Errors
/// The arm cannot follow the path.
pub(super) fn end_of(
    arm: &Arc<Arm>,
    start: Joints,
    path: &MovePath,
    tool: &IsometryMatrix3<f64>,
) -> Result<Joints, Cause> {
    planned(arm, start, path, tool).map(|motion| motion.destination())
}

/// Joint positions on a path from its start to its end, one for each cycle of 4 ms.
///
/// # Errors
/// The arm cannot follow the path.
pub(super) fn samples(
    arm: &Arc<Arm>,
    start: Joints,
    path: &MovePath,
    tool: &IsometryMatrix3<f64>,
) -> Result<Vec<Joints>, Cause> {
    let mut motion = planned(arm, start, path, tool)?;
    let mut samples = vec![start];
    while !motion.is_empty() && samples.len() < MOST_CYCLES {
        samples.push(motion.advance(CYCLE).joints);
        if let Some(cause) = motion.fault() {
            return Err(cause.clone());
        }
    }
    Ok(samples)
}

fn planned(arm: &Arc<Arm>, start: Joints, path: &MovePath, tool: &IsometryMatrix3<f64>) -> Result<Motion, Cause> {
    let mut motion = Motion::new(Arc::clone(arm), start);
    motion.record(&nominal_move(arm, path, tool, Blend::Off))?;
    motion.close()?;
    Ok(motion)
}
