//! The port through which instructions reach the arm.

use val3_geometry::IsometryMatrix3;
use val3_kinematics::{Arm, Dh};
use val3_lang::fault::{Fault, Result};
use val3_lang::ports::{AlterReference, Motion, MoveRequest};
use val3_lang::runtime_errors::{IMPOSSIBLE_MOVE, MOTION_FAULT};
use val3_lang::values::MdescValue;

use super::Devices;
use crate::arm::MoveError;
use crate::controller_state::Severity;

impl Motion for Devices {
    fn arm(&mut self) -> &Arm {
        self.state.arm.model()
    }

    fn set_dh(&mut self, dh: &Dh) -> Result<bool> {
        let changed = self.state.arm.set_dh(dh);
        if let Err(error) = &changed {
            self.report_here(&format!("setDH: {error}"), Severity::Warning);
        }
        Ok(changed.is_ok())
    }

    fn commanded_joint(&mut self) -> [f64; 6] {
        if self.state.robot.is_powered() { self.state.arm.joint() } else { self.state.arm.measured_joint() }
    }

    fn measured_joint(&mut self) -> [f64; 6] {
        self.state.arm.measured_joint()
    }

    fn joint_force(&mut self) -> [f64; 6] {
        [0.0; 6]
    }

    fn arm_latch(&mut self, _input: Option<u32>) -> Result<()> {
        Ok(())
    }

    fn latched_joint(&mut self) -> Option<[f64; 6]> {
        None
    }

    fn speed(&mut self, tool: &IsometryMatrix3<f64>) -> f64 {
        self.state.arm.speed(tool)
    }

    fn record_move(&mut self, request: &MoveRequest) -> Result<Option<f64>> {
        let recorded = self.state.arm.record(request);
        recorded.map_err(|error| self.refuse(request.instruction, &error))
    }

    fn is_empty(&mut self) -> bool {
        self.state.arm.is_empty()
    }

    fn is_settled(&mut self) -> bool {
        self.state.arm.is_settled()
    }

    fn is_at_rest(&mut self) -> bool {
        self.state.arm.is_at_rest()
    }

    fn is_compliant(&mut self) -> bool {
        false
    }

    fn arrive(&mut self) -> Result<bool> {
        let arrived = self.state.arm.arrive();
        arrived.map_err(|error| self.refuse("waitEndMove", &error))
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

    fn reset_turn(&mut self, reference: [f64; 6]) -> Result<[f64; 6]> {
        Ok(self.state.arm.reset_turn(&reference))
    }

    fn move_id(&mut self) -> f64 {
        self.state.arm.move_id()
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

    fn begin_alter(&mut self, _reference: AlterReference, _limits: &MdescValue) -> i8 {
        0
    }

    fn alter(&mut self, _transformation: &IsometryMatrix3<f64>) -> i8 {
        -1
    }

    fn end_alter(&mut self) -> i8 {
        -1
    }

    fn alter_stop_time(&mut self) -> f64 {
        0.0
    }
}

impl Devices {
    /// Says in the event log why a move is refused, and gives the run-time error.
    fn refuse(&mut self, instruction: &str, error: &MoveError) -> Fault {
        let (text, code) = match error {
            MoveError::Earlier(cause) => (format!("a move recorded before cannot be done: {cause}"), MOTION_FAULT),
            MoveError::Refused(cause) => (format!("{instruction}: {cause}"), IMPOSSIBLE_MOVE),
        };
        self.report_here(&text, Severity::Error);
        Fault(code)
    }
}
