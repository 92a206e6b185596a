//! Moves whose motion descriptor exceeds an axis's maximum speed.

use val3_kinematics::{ExcessSpeed, Joints};
use val3_lang::ports::{CodePlace, MoveRequest};
use val3_motion::PathShape;

use super::RobotArm;

/// Distance from the start at the end of the move from which an axis counts as moving, in degrees or mm.
const MOVES: f64 = 1e-6;

impl RobotArm {
    /// Returns the axis that a move, just recorded from `start` at a line, may move faster than its maximum speed.
    /// `None` also if an earlier move of the line did.
    pub(crate) fn excess_speed(&mut self, request: &MoveRequest, start: &Joints, at: CodePlace) -> Option<ExcessSpeed> {
        let end = self.motion.destination();
        let is_circle = request.path.shape() == PathShape::Circle;
        let excess = self.model.excess_speed(request.descriptor.vel, |axis| {
            let way = start.get(axis).zip(end.get(axis)).map_or(0.0, |(start, end)| (end - start).abs());
            is_circle || way > MOVES
        })?;
        let is_new = !self.too_fast.contains(&at);
        if is_new {
            self.too_fast.push(at);
        }
        is_new.then_some(excess)
    }
}
