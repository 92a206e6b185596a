//! The arm and its recorded moves (9.2.3, 9.6.3, 10.6, 11).
//!
//! Poses are in `world`, tools in `flange`, both in millimetres. A joint position is six numbers, in degrees or
//! millimetres; numbers without an axis are 0.

use val3_geometry::IsometryMatrix3;
use val3_kinematics::{Arm, Dh};
use val3_moves::{AlterReference, Manner, MovePath};

use crate::fault::Result;
use crate::values::MdescValue;

/// Move request of an instruction.
#[derive(Debug, Clone)]
pub struct MoveRequest {
    /// Instruction name, such as `movel`.
    pub instruction: &'static str,
    /// Path with its destination.
    pub path: MovePath,
    /// Tool centre point.
    pub tool: IsometryMatrix3<f64>,
    /// Speeds, accelerations and blend; lengths in millimetres.
    pub descriptor: MdescValue,
    /// Manner in which the arm follows the path.
    pub manner: Manner,
}

/// Arm and its motion.
pub trait MotionPort {
    /// Returns the arm's model.
    fn arm(&mut self) -> &Arm;

    /// `setDH`: changes the arm's geometry. `false` if the parameters differ too much from the arm type's parameters.
    ///
    /// # Errors
    /// 250 without the licence.
    fn set_dh(&mut self, dh: &Dh) -> Result<bool>;

    /// `herej`: returns the commanded joint position.
    fn commanded_joint(&mut self) -> [f64; 6];

    /// Returns the joint position as measured by the encoders.
    fn measured_joint(&mut self) -> [f64; 6];

    /// `getJointForce`: returns the axes' torques in Nm; forces in N for linear axes.
    fn joint_force(&mut self) -> [f64; 6];

    /// `setLatch`: arms the latch, which stores the position at the input's next rising edge.
    ///
    /// # Errors
    /// 70 for an input without latch, 123 without a link.
    fn arm_latch(&mut self, input: Option<u32>) -> Result<()>;

    /// `getLatch`: returns the position that the latch has stored.
    fn latched_joint(&mut self) -> Option<[f64; 6]>;

    /// `getSpeed`: returns the speed of a tool centre point, in mm/s.
    fn speed(&mut self, tool: &IsometryMatrix3<f64>) -> f64;

    /// Records a move and returns its id; `None` while no more moves can be recorded.
    ///
    /// # Errors
    /// 150 if an earlier recorded move cannot be executed, 154 if this move cannot be executed, 250 without the
    /// licence.
    fn record_move(&mut self, request: &MoveRequest) -> Result<Option<f64>>;

    /// Whether all recorded moves are done (`isEmpty`).
    fn is_empty(&mut self) -> bool;

    /// Whether the arm has settled at its position (`isSettled`).
    fn is_settled(&mut self) -> bool;

    /// Whether the controller commands no motion.
    fn is_at_rest(&mut self) -> bool;

    /// Whether a compliant move is in progress (`isCompliant`).
    fn is_compliant(&mut self) -> bool;

    /// `waitEndMove`: ends the last recorded move without a blend. Returns whether the arm has arrived.
    ///
    /// # Errors
    /// 150 if a recorded move cannot be executed.
    fn arrive(&mut self) -> Result<bool>;

    /// `stopMove`: stops the arm on its path.
    fn stop_move(&mut self);

    /// `restartMove`: releases the arm.
    fn restart_move(&mut self);

    /// `resetMotion`; the next move starts at `start`, or at the arm's position.
    fn reset_motion(&mut self, start: Option<[f64; 6]>);

    /// `resetTurn` for an arm at rest: removes full turns of the last axis.
    ///
    /// # Errors
    /// 250 without the licence.
    fn reset_turn(&mut self, reference: [f64; 6]) -> Result<[f64; 6]>;

    /// `getMoveId`: returns the current move's id and its progress.
    fn move_id(&mut self) -> f64;

    /// `setMoveId`: sets the id of the next move.
    fn set_move_id(&mut self, id: f64);

    /// `autoConnectMove`: whether connection moves are automatic.
    fn connects_by_itself(&mut self) -> bool;

    /// `autoConnectMove`: switches automatic connection moves on or off.
    fn connect_by_itself(&mut self, active: bool);

    /// `alterBegin`: returns -3 to 1.
    fn begin_alter(&mut self, reference: AlterReference, limits: &MdescValue) -> i8;

    /// `alter`: returns -3 to 1.
    fn alter(&mut self, transformation: &IsometryMatrix3<f64>) -> i8;

    /// `alterEnd`: returns -3 to 1.
    fn end_alter(&mut self) -> i8;

    /// `alterStopTime`: returns the time in seconds.
    fn alter_stop_time(&mut self) -> f64;
}
