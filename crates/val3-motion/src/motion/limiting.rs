//! Limit that determines the arm's speed.

use super::{Motion, MotionPhase};
use crate::model::Model;
use crate::speed_limit::{ActingLimit, SpeedLimit};

impl Motion {
    /// Limit that determined the speed at the end of the last cycle.
    #[must_use]
    pub fn speed_limit(&self) -> SpeedLimit {
        match &self.acting {
            ActingLimit::Known(limit) => *limit,
            ActingLimit::OnPath(state) => state.speed_limit(&Model(&self.arm)),
        }
    }

    /// Stores the acting limit of a cycle in which the arm has not followed the planned speeds.
    pub(super) fn limit(&mut self, phase: MotionPhase) {
        let known = match phase {
            MotionPhase::Waiting => self.limit_at_rest(),
            MotionPhase::Connection => SpeedLimit::Connection,
            MotionPhase::Stopping => SpeedLimit::Stop,
            MotionPhase::Compliant => SpeedLimit::Force,
            MotionPhase::Nominal | MotionPhase::Blend | MotionPhase::Alter => return,
        };
        self.acting = ActingLimit::Known(known);
    }

    fn limit_at_rest(&self) -> SpeedLimit {
        let is_held = self.is_at_halt() || self.departure.is_some() || self.waits_for_release();
        match self.timeline.compliant() {
            _ if self.stuck().is_some() => SpeedLimit::Fault,
            _ if self.is_empty() && self.departure.is_none() => SpeedLimit::End,
            _ if is_held => SpeedLimit::Held,
            _ if self.executor.pace() == 0.0 => SpeedLimit::MonitorSpeed,
            Some(_) => SpeedLimit::Force,
            None => SpeedLimit::NextMove,
        }
    }
}
