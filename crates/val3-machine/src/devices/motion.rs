//! The arm as instructions reach it (9.2.3, 10.6, 11.1).

use val3_geometry::Trsf;
use val3_lang::ports::Motion;

use super::Devices;
use crate::controller_state::JointLimits;

/// An arm that does not move: it is at joint position zero, and no move is ever recorded.
#[derive(Debug, Clone, Default)]
pub struct StandingArm {
    /// `stopMove` holds it.
    pub is_stopped: bool,
    /// Where the next move starts, if a program has said it.
    pub start: Option<[f64; 6]>,
    /// The id of the next move.
    next_move: f64,
    connects_by_itself: bool,
    /// How far each axis may go.
    pub limits: JointLimits,
}

impl StandingArm {
    /// An arm of this model, with the known limits of its axes.
    #[must_use]
    pub fn new(model: &str) -> Self {
        Self { limits: JointLimits::of_model(model), ..Self::default() }
    }
}

impl Motion for Devices {
    fn commanded_joint(&mut self) -> [f64; 6] {
        [0.0; 6]
    }

    fn measured_joint(&mut self) -> [f64; 6] {
        [0.0; 6]
    }

    fn is_in_range(&mut self, joint: [f64; 6]) -> bool {
        self.state.arm.limits.contain(joint)
    }

    fn speed(&mut self, _: &[Trsf]) -> f64 {
        0.0
    }

    fn is_empty(&mut self) -> bool {
        true
    }

    fn is_settled(&mut self) -> bool {
        true
    }

    fn is_compliant(&mut self) -> bool {
        false
    }

    fn arrive(&mut self) -> bool {
        true
    }

    fn stop_move(&mut self) {
        self.state.arm.is_stopped = true;
    }

    fn restart_move(&mut self) {
        self.state.arm.is_stopped = false;
    }

    fn reset_motion(&mut self, start: Option<[f64; 6]>) {
        (self.state.arm.is_stopped, self.state.arm.start, self.state.arm.next_move) = (false, start, 0.0);
    }

    fn move_id(&mut self) -> f64 {
        self.state.arm.next_move
    }

    fn set_move_id(&mut self, id: f64) {
        self.state.arm.next_move = id;
    }

    fn connects_by_itself(&mut self) -> bool {
        self.state.arm.connects_by_itself
    }

    fn connect_by_itself(&mut self, active: bool) {
        self.state.arm.connects_by_itself = active;
    }
}
