//! The arm and its recorded moves (9.2.3, 9.6.3, 10.6, 11).
//!
//! Poses are in `world`, tools in `flange`, both in millimetres. A joint position is six numbers, in degrees or
//! millimetres; those that the arm lacks are 0.

use val3_geometry::IsometryMatrix3;
use val3_kinematics::{Arm, Dh};
use val3_moves::{AlterReference, Manner, MovePath};

use crate::fault::Result;
use crate::values::MdescValue;

/// Move as an instruction requests it.
#[derive(Debug, Clone)]
pub struct MoveRequest {
    /// Name of the instruction: `movel`.
    pub instruction: &'static str,
    /// Path with its destination.
    pub path: MovePath,
    /// The tool centre point.
    pub tool: IsometryMatrix3<f64>,
    /// Speeds, accelerations and blend; lengths in millimetres.
    pub descriptor: MdescValue,
    /// How the arm follows the path.
    pub manner: Manner,
}

/// The arm.
pub trait MotionPort {
    /// Its model.
    fn arm(&mut self) -> &Arm;

    /// `setDH`: changes its geometry. `false` where the parameters differ too much from those of the arm type.
    ///
    /// # Errors
    /// 250 without the licence.
    fn set_dh(&mut self, dh: &Dh) -> Result<bool>;

    /// `herej`: where the controller wants each axis.
    fn commanded_joint(&mut self) -> [f64; 6];

    /// Where the encoders find each axis.
    fn measured_joint(&mut self) -> [f64; 6];

    /// `getJointForce`: torque of each axis in Nm, force of a linear axis in N.
    fn joint_force(&mut self) -> [f64; 6];

    /// `setLatch`: the next rising edge of an input keeps the position.
    ///
    /// # Errors
    /// 70 an input without latch, 123 without a link.
    fn arm_latch(&mut self, input: Option<u32>) -> Result<()>;

    /// `getLatch`: the position that the latch has kept.
    fn latched_joint(&mut self) -> Option<[f64; 6]>;

    /// `getSpeed`: of the tip of a tool, in millimetres a second.
    fn speed(&mut self, tool: &IsometryMatrix3<f64>) -> f64;

    /// Records a move, and gives its id; `None` while no more moves can be recorded.
    ///
    /// # Errors
    /// 150 a move recorded before cannot be done, 154 this one cannot, 250 without the licence.
    fn record_move(&mut self, request: &MoveRequest) -> Result<Option<f64>>;

    /// `isEmpty`: every recorded move is done.
    fn is_empty(&mut self) -> bool;

    /// `isSettled`.
    fn is_settled(&mut self) -> bool;

    /// The controller commands no motion.
    fn is_at_rest(&mut self) -> bool;

    /// `isCompliant`.
    fn is_compliant(&mut self) -> bool;

    /// `waitEndMove`: the last recorded move ends without a blend. Whether the arm has got there.
    ///
    /// # Errors
    /// 150 a recorded move cannot be done.
    fn arrive(&mut self) -> Result<bool>;

    /// `stopMove`.
    fn stop_move(&mut self);

    /// `restartMove`.
    fn restart_move(&mut self);

    /// `resetMotion`; the next move starts at `start`, or wherever the arm is.
    fn reset_motion(&mut self, start: Option<[f64; 6]>);

    /// `resetTurn` of an arm at rest: forgets whole turns of the last axis.
    ///
    /// # Errors
    /// 250 without the licence.
    fn reset_turn(&mut self, reference: [f64; 6]) -> Result<[f64; 6]>;

    /// `getMoveId`.
    fn move_id(&mut self) -> f64;

    /// `setMoveId`: the id of the next move.
    fn set_move_id(&mut self, id: f64);

    /// `autoConnectMove`: the present choice.
    fn connects_by_itself(&mut self) -> bool;

    /// `autoConnectMove`: makes a choice.
    fn connect_by_itself(&mut self, active: bool);

    /// `alterBegin`: its result, -3 to 1.
    fn begin_alter(&mut self, reference: AlterReference, limits: &MdescValue) -> i8;

    /// `alter`: its result, -3 to 1.
    fn alter(&mut self, transformation: &IsometryMatrix3<f64>) -> i8;

    /// `alterEnd`: its result, -3 to 1.
    fn end_alter(&mut self) -> i8;

    /// `alterStopTime`, in seconds.
    fn alter_stop_time(&mut self) -> f64;
}
