//! The motion as a debugger shows and controls it: the step mode (10.2.2) and the queue of moves.

use val3_geometry::IsometryMatrix3;
use val3_kinematics::Joints;
use val3_lang::ports::CodePlace;
use val3_lang::values::MdescValue;
use val3_motion::{BlendCorner, Millimetres, MotionMode, MoveStage, PathPiece, PathShape, QueuedMove};

use super::Controller;
use crate::arm::{ArmHold, MoveOrigin, RobotArm};
use crate::blend_ends::BlendEnds;

/// Progress of the arm on the recorded moves.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionStatus {
    /// Mode of the motion.
    pub mode: MotionMode,
    /// Whether the commanded position has changed in the last cycle.
    pub is_moving: bool,
    /// Whether the arm has reached the end of the release, or of the determined path.
    pub has_arrived: bool,
    /// Current piece, or the piece at whose end the arm waits; `None` before the first piece.
    pub piece: Option<MotionPiece>,
    /// Next piece; `None` if it is not determined yet.
    pub next: Option<MotionPiece>,
    /// Reason why the arm rests before the end of the release.
    pub hold: Option<ArmHold>,
}

/// Piece of the path: the nominal part of a move, or the blend around a destination.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionPiece {
    /// Move, kind and end of the piece.
    pub piece: PathPiece,
    /// Index of the move in [`Controller::motion_queue`]; `None` if the move is done.
    pub position: Option<usize>,
    /// Line that requested the move; `None` for a client.
    pub source: Option<CodeSource>,
}

/// A recorded move that is not done.
#[derive(Debug, Clone, PartialEq)]
pub struct RecordedMove {
    /// Serial number of the move, unique, in the order of recording.
    pub serial: u64,
    /// Id that `getMoveId` returns during the move.
    pub id: f64,
    /// Shape of the path.
    pub shape: PathShape,
    /// Joint position at the destination, in degrees (linear axes: mm).
    pub joints: Joints,
    /// Tool centre point at the destination, in `world`; lengths in mm.
    pub target: IsometryMatrix3<f64>,
    /// Motion descriptor: speeds and accelerations in per cent of the nominal values, `tvel` in mm/s, `rvel` in
    /// degrees/s, `leave` and `reach` in mm.
    pub descriptor: Option<MdescValue>,
    /// Stage of the execution.
    pub stage: MoveStage,
    /// Start of the blend around the destination; `None` without a blend, or before the path is determined.
    pub leave: Option<BlendPoint>,
    /// End of that blend; `None` before the next move determines it.
    pub reach: Option<BlendPoint>,
    /// Requested and effective distances of that blend.
    pub blend: BlendEnds,
    /// Line that requested the move; `None` for a client.
    pub source: Option<CodeSource>,
}

/// Start or end of a blend.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BlendPoint {
    /// Effective distance of the tool centre point to the destination; 0 for a pure rotation.
    pub distance: Millimetres,
    /// Commanded joint position at this end, in degrees (linear axes: mm).
    pub joints: Joints,
    /// Tool centre point at this end, in `world`; lengths in mm.
    pub pose: IsometryMatrix3<f64>,
}

impl BlendPoint {
    /// Blend end at a corner, with the joint position and pose there.
    fn new(corner: Option<BlendCorner>, place: Option<(Joints, IsometryMatrix3<f64>)>) -> Option<Self> {
        let (joints, pose) = place?;
        Some(Self { distance: corner?.distance, joints, pose })
    }
}

/// Instruction that requested a move, with its line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CodeSource {
    /// Name of the instruction: `movel`.
    pub instruction: &'static str,
    /// Location in the code.
    pub at: CodePlace,
    /// The program.
    pub program: String,
    /// The line of the file, from 1.
    pub line: u32,
    /// The file.
    pub file: String,
}

/// Fault of the path before which the arm rests.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MotionFault {
    /// Serial number of the move.
    pub serial: u64,
    /// The reason.
    pub text: String,
    /// Line that requested the move; `None` for a client.
    pub source: Option<CodeSource>,
}

impl Controller {
    /// Arm with its recorded moves.
    #[must_use]
    pub fn arm(&self) -> &RobotArm {
        &self.devices.state.arm
    }

    /// Arm with its recorded moves, for changes from outside of programs.
    pub fn arm_mut(&mut self) -> &mut RobotArm {
        &mut self.devices.state.arm
    }

    /// Progress of the arm on the recorded moves.
    #[must_use]
    pub fn motion_status(&self) -> MotionStatus {
        let motion = self.devices.state.arm.motion();
        MotionStatus {
            mode: motion.mode(),
            is_moving: !self.devices.state.arm.is_at_rest(),
            has_arrived: motion.has_arrived(),
            piece: motion.piece().map(|piece| self.motion_piece(piece)),
            next: motion.next_piece().map(|piece| self.motion_piece(piece)),
            hold: self.devices.state.arm_standstill(),
        }
    }

    /// The recorded moves that are not done, the oldest first.
    #[must_use]
    pub fn motion_queue(&self) -> Vec<RecordedMove> {
        self.devices.state.arm.moves().map(|(queued, origin)| self.recorded_move(queued, origin)).collect()
    }

    fn recorded_move(&self, queued: &QueuedMove, origin: Option<&MoveOrigin>) -> RecordedMove {
        let motion = self.devices.state.arm.motion();
        RecordedMove {
            serial: queued.serial,
            id: queued.id,
            shape: queued.shape,
            joints: queued.joints,
            target: queued.target,
            descriptor: origin.map(|origin| origin.descriptor),
            stage: queued.stage,
            leave: BlendPoint::new(queued.leave, motion.leave_point(queued.serial)),
            reach: BlendPoint::new(queued.reach, motion.reach_point(queued.serial)),
            blend: self.devices.blend_of(queued, origin),
            source: origin.and_then(|origin| self.source(origin)),
        }
    }

    fn motion_piece(&self, piece: PathPiece) -> MotionPiece {
        let arm = &self.devices.state.arm;
        let position = arm.moves().position(|(queued, _)| queued.serial == piece.serial);
        let source = arm.origin(piece.serial).and_then(|origin| self.source(origin));
        MotionPiece { piece, position, source }
    }

    fn source(&self, &MoveOrigin { instruction, at, .. }: &MoveOrigin) -> Option<CodeSource> {
        let at = at?;
        let (program, line, file) = self.devices.place(at);
        Some(CodeSource { instruction, at, program, line, file })
    }

    /// Records the unfinished moves at the end of the application, and the fault of the remaining path.
    pub fn record_dropped_moves(&mut self) {
        let now = self.now();
        self.devices.record_dropped_moves(now);
    }

    /// Fault of the path before which the arm rests.
    #[must_use]
    pub fn motion_fault(&self) -> Option<MotionFault> {
        let arm = &self.devices.state.arm;
        let fault = arm.motion().stuck()?;
        let source = arm.origin(fault.serial).and_then(|origin| self.source(origin));
        Some(MotionFault { serial: fault.serial, text: fault.to_string(), source })
    }

    /// Pauses or resumes all tasks without an effect on programs; time, the arm, inputs and outputs continue.
    pub fn rest_tasks(&mut self, rest: bool) {
        self.schedule.tasks_rest = rest;
    }
}
