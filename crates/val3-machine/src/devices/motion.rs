//! The port through which instructions reach the arm.

use val3_geometry::Trsf;
use val3_lang::ports::Motion;

use super::Devices;

impl Motion for Devices {
    fn commanded_joint(&mut self) -> [f64; 6] {
        self.state.arm.joint()
    }

    fn measured_joint(&mut self) -> [f64; 6] {
        self.state.arm.joint()
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
        self.state.arm.is_settled()
    }

    fn is_compliant(&mut self) -> bool {
        false
    }

    fn arrive(&mut self) -> bool {
        true
    }

    fn stop_move(&mut self) {
        self.state.arm.stop();
    }

    fn restart_move(&mut self) {
        self.state.arm.restart();
    }

    fn reset_motion(&mut self, start: Option<[f64; 6]>) {
        self.state.arm.reset(start);
    }

    fn move_id(&mut self) -> f64 {
        self.state.arm.next_move()
    }

    fn set_move_id(&mut self, id: f64) {
        self.state.arm.set_next_move(id);
    }

    fn connects_by_itself(&mut self) -> bool {
        self.state.arm.connects_by_itself()
    }

    fn connect_by_itself(&mut self, active: bool) {
        self.state.arm.connect_by_itself(active);
    }
}
