//! Selection of the cycles that have a row in a trace.

use val3_motion::MotionPhase;

/// Selects the rows of a trace: cycles in which the arm moves, and the first cycle at rest after each motion.
#[derive(Debug, Clone, Copy, Default)]
pub struct RowSelection {
    was_moving: bool,
}

impl RowSelection {
    /// Whether the next cycle has a row.
    pub fn takes(&mut self, phase: MotionPhase) -> bool {
        let is_moving = phase != MotionPhase::Waiting;
        let was_moving = std::mem::replace(&mut self.was_moving, is_moving);
        is_moving || was_moving
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_motion_ends_with_one_row_at_rest() {
        let mut selection = RowSelection::default();
        let phases = [
            MotionPhase::Waiting,
            MotionPhase::Nominal,
            MotionPhase::Blend,
            MotionPhase::Waiting,
            MotionPhase::Waiting,
            MotionPhase::Nominal,
        ];
        assert_eq!(phases.map(|phase| selection.takes(phase)), [false, true, true, true, false, true]);
    }
}
