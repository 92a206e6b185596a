//! Step mode of the arm (10.2.2).

use val3_motion::{Motion, MotionMode};

use super::{ArmHold, Drive, MoveOrigin, RobotArm, WAITING};

impl RobotArm {
    /// The moves in execution.
    #[must_use]
    pub const fn motion(&self) -> &Motion {
        &self.motion
    }

    /// The instruction of a move that is not done, or at whose end the arm waits.
    pub(crate) fn origin(&self, serial: u64) -> Option<&MoveOrigin> {
        self.origins.get(&serial)
    }

    /// Sets the mode of the motion, also while the arm moves.
    ///
    /// In step mode the arm first finishes the current piece. It then comes to rest at the end of each piece and waits
    /// there until it is released. In continuous mode it does not wait.
    pub fn set_mode(&mut self, mode: MotionMode) {
        self.motion.set_mode(mode);
    }

    /// Releases an arm that waits in step mode to the end of the next piece. Returns whether the arm waits before a
    /// determined piece.
    pub fn release_piece(&mut self) -> bool {
        self.motion.release_piece()
    }

    /// Releases the arm to the end of the path that is determined now.
    pub fn release_determined(&mut self) {
        self.motion.release_determined();
    }

    /// Reason why the arm rests before the end of the release and does not continue by itself.
    #[must_use]
    pub fn standstill(&self, drive: Drive) -> Option<ArmHold> {
        // An arm held by the monitor speed has a plan with a speed.
        if !self.is_at_rest() || self.motion.has_arrived() {
            return None;
        }
        let is_yielding = self.motion.is_compliant() && self.yielding >= WAITING;
        match self.hold(drive) {
            Some(ArmHold::Away) if self.may_connect(drive) => None,
            None if is_yielding => Some(ArmHold::NoForce),
            hold => hold,
        }
    }
}
