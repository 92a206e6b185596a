//! The arm and its recorded moves (9.2.3, 10.6, 11.1).

use val3_geometry::Trsf;

/// The arm. A joint position is six numbers, in degrees or millimetres; those that the arm lacks are 0.
pub trait Motion {
    /// `herej`: where the controller wants each axis.
    fn commanded_joint(&mut self) -> [f64; 6];

    /// Where the encoders find each axis.
    fn measured_joint(&mut self) -> [f64; 6];

    /// `isInRange`: every axis would be within its software limits.
    fn is_in_range(&mut self, joint: [f64; 6]) -> bool;

    /// `getSpeed`: of the tip of a tool, in millimetres a second; `tool` is its way to the flange, from the inside out.
    fn speed(&mut self, tool: &[Trsf]) -> f64;

    /// `isEmpty`: every recorded move is done.
    fn is_empty(&mut self) -> bool;

    /// `isSettled`.
    fn is_settled(&mut self) -> bool;

    /// `isCompliant`.
    fn is_compliant(&mut self) -> bool;

    /// `waitEndMove`: the last recorded move ends without a blend. Whether the arm has got there.
    fn arrive(&mut self) -> bool;

    /// `stopMove`.
    fn stop_move(&mut self);

    /// `restartMove`.
    fn restart_move(&mut self);

    /// `resetMotion`; the next move starts at `start`, or wherever the arm is.
    fn reset_motion(&mut self, start: Option<[f64; 6]>);

    /// `getMoveId`.
    fn move_id(&mut self) -> f64;

    /// `setMoveId`: the id of the next move.
    fn set_move_id(&mut self, id: f64);

    /// `autoConnectMove`: the present choice.
    fn connects_by_itself(&mut self) -> bool;

    /// `autoConnectMove`: makes a choice.
    fn connect_by_itself(&mut self, active: bool);
}
