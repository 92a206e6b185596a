//! Instructions that record moves, and the conversion of their requests to moves of the planner.

use val3_kinematics::Arm;
use val3_lang::ports::{CodePlace, MoveRequest};
use val3_lang::values::MdescValue;
use val3_motion::{Blend, Cause, DegreesPerSecond, Millimetres, MillimetresPerSecond, Move, MovePath, SpeedLimits};

use super::{CAPACITY, RobotArm};

/// Instruction or client that has recorded a move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MoveOrigin {
    /// Name of the instruction, such as `movel`, or of the client's request.
    pub instruction: &'static str,
    /// Location in the code; `None` for a client.
    pub at: Option<CodePlace>,
    /// Motion descriptor, with lengths in mm.
    pub descriptor: MdescValue,
    /// Line that has cancelled the blend at the destination.
    pub cancelled_by: Option<CodePlace>,
}

impl RobotArm {
    /// Adapts the locations of recorded moves to changed code.
    pub(crate) fn move_code(&mut self, moved: impl Fn(CodePlace) -> CodePlace) {
        for origin in self.origins.values_mut() {
            (origin.at, origin.cancelled_by) = (origin.at.map(&moved), origin.cancelled_by.map(&moved));
        }
    }

    /// Whether no more moves can be recorded before a move is done.
    pub(super) fn is_full(&self) -> bool {
        self.motion.moves().len() >= CAPACITY
    }

    /// Appends a move with this id, requested at a line or by a client.
    pub(super) fn append(&mut self, request: &MoveRequest, id: f64, at: Option<CodePlace>) -> Result<(), Cause> {
        self.motion.record(&to_move(&self.model, request, id))?;
        if let Some(last) = self.motion.moves().last() {
            let (instruction, descriptor) = (request.instruction, request.descriptor);
            self.origins.insert(last.serial, MoveOrigin { instruction, at, descriptor, cancelled_by: None });
        }
        Ok(())
    }

    /// Position of the tool centre point at the destination of a move, in mm in `world`, to a micrometre.
    pub(crate) fn target_of(&self, request: &MoveRequest) -> [f64; 3] {
        let pose = match &request.path {
            MovePath::Joint(joints) => self.model.flange(joints) * request.tool,
            MovePath::JointToPoint(target) | MovePath::Line(target) | MovePath::Circle(_, target) => target.pose,
        };
        let position: [f64; 3] = pose.translation.vector.into();
        position.map(|coordinate| (coordinate * 1000.0).round() / 1000.0)
    }
}

/// Converts a request to the move with this id.
fn to_move(arm: &Arm, request: &MoveRequest, id: f64) -> Move {
    let MoveRequest { path, tool, descriptor, manner, .. } = request;
    let MdescValue { blend, leave, reach, .. } = *descriptor;
    let blend = Blend::new(blend, Millimetres(leave), Millimetres(reach));
    Move { path: path.clone(), tool: *tool, limits: limits(arm, descriptor), blend, id, manner: *manner }
}

/// Limits of a descriptor, whose percentages refer to the nominal values of the arm (10.3.4).
pub(super) fn limits(arm: &Arm, descriptor: &MdescValue) -> SpeedLimits {
    SpeedLimits {
        speed: std::array::from_fn(|axis| descriptor.vel / 100.0 * arm.nominal_speed(axis)),
        acceleration: std::array::from_fn(|axis| descriptor.accel / 100.0 * arm.nominal_acceleration(axis)),
        deceleration: std::array::from_fn(|axis| descriptor.decel / 100.0 * arm.nominal_deceleration(axis)),
        translation: MillimetresPerSecond(descriptor.tvel),
        rotation: DegreesPerSecond(descriptor.rvel),
    }
}
