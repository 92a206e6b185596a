//! The motion as a debugger shows and controls it: the step mode (10.2.2) and the queue of moves.

use val3_geometry::IsometryMatrix3;
use val3_kinematics::Joints;
use val3_lang::ports::CodePlace;
use val3_lang::values::MdescValue;
use val3_motion::{Corner, Millimetres, MotionMode, MoveStage, PathPiece, PathShape, QueuedMove};

use super::Controller;
use crate::arm::{ArmHold, MoveOrigin};
use crate::blend_ends::BlendEnds;

/// Where the arm is in the recorded moves.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionStatus {
    /// The mode.
    pub mode: MotionMode,
    /// The commanded position has changed in the last cycle.
    pub is_moving: bool,
    /// The arm is where it was released to, or at the end of everything that is determined.
    pub has_arrived: bool,
    /// The piece that the arm is in, or at whose end it waits. None before the first one.
    pub piece: Option<MotionPiece>,
    /// The piece after that; none if it is not determined yet.
    pub next: Option<MotionPiece>,
    /// Why the arm rests before the end of what it was released to.
    pub hold: Option<ArmHold>,
}

/// A piece of the path: the nominal part of a move, or the blend around its destination.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionPiece {
    /// The piece: its move, its kind, and where it ends.
    pub piece: PathPiece,
    /// The position of its move in [`Controller::motion_queue`]; none once the move is done.
    pub position: Option<usize>,
    /// The line that requested its move.
    pub source: Option<CodeSource>,
}

/// A recorded move that is not done.
#[derive(Debug, Clone, PartialEq)]
pub struct RecordedMove {
    /// Its number in the order of recording, which no other move has.
    pub serial: u64,
    /// The id that `getMoveId` gives while it is executed.
    pub id: f64,
    /// The shape of its path.
    pub shape: PathShape,
    /// Joint position at its destination, in degrees (linear axes: mm).
    pub joints: Joints,
    /// The tool centre point at its destination, in world; lengths in mm.
    pub target: IsometryMatrix3<f64>,
    /// Its motion descriptor: speeds and accelerations in per cent of the nominal ones, `tvel` in mm/s, `rvel` in
    /// degrees/s, `leave` and `reach` in mm.
    pub descriptor: Option<MdescValue>,
    /// Stage of the execution.
    pub stage: MoveStage,
    /// Where the blend around its destination begins; none without a blend, or while its path is not determined.
    pub leave: Option<BlendPoint>,
    /// Where that blend ends, once the next move determines it.
    pub reach: Option<BlendPoint>,
    /// Requested and effective distances of that blend.
    pub blend: BlendEnds,
    /// The line that requested it.
    pub source: Option<CodeSource>,
}

/// An end of a blend.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BlendPoint {
    /// The effective distance of the tool centre point to the destination; 0 for a pure rotation.
    pub distance: Millimetres,
    /// Commanded joint position there, in degrees (linear axes: mm).
    pub joints: Joints,
    /// The tool centre point there, in world; lengths in mm.
    pub pose: IsometryMatrix3<f64>,
}

/// The instruction that has requested a move, and its line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CodeSource {
    /// Its name: `movel`.
    pub instruction: &'static str,
    /// Its place in the code.
    pub at: CodePlace,
    /// The program.
    pub program: String,
    /// The line of the file, from 1.
    pub line: u32,
    /// The file.
    pub file: String,
}

/// A path before which the arm rests, because it cannot follow the path.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MotionFault {
    /// The number of its move in the order of recording.
    pub serial: u64,
    /// The reason.
    pub text: String,
    /// The line that requested the move.
    pub source: Option<CodeSource>,
}

/// The step mode.
impl Controller {
    /// The mode of the motion.
    #[must_use]
    pub fn motion_mode(&self) -> MotionMode {
        self.devices.state.arm.motion().mode()
    }

    /// Chooses the mode of the motion, also while the arm moves.
    ///
    /// In step mode the arm comes to rest at the end of each piece and waits there until it is released; it first
    /// finishes the piece that it is in. In continuous mode nothing waits any more.
    pub fn set_motion_mode(&mut self, mode: MotionMode) {
        self.devices.state.arm.set_mode(mode);
    }

    /// Releases an arm that waits in step mode to the end of the next piece. Returns whether it waits before one that is
    /// determined.
    pub fn step_motion(&mut self) -> bool {
        self.devices.state.arm.release_piece()
    }

    /// Releases the arm to the end of everything that is determined now.
    pub fn release_motion(&mut self) {
        self.devices.state.arm.release_determined();
    }

    /// Whether the arm waits in step mode before a piece that is determined.
    #[must_use]
    pub fn motion_awaits_release(&self) -> bool {
        self.devices.state.arm.motion().waits_for_release()
    }

    /// A number that grows whenever a move is recorded or more of the path is determined.
    #[must_use]
    pub fn motion_revision(&self) -> u64 {
        self.devices.state.arm.motion().revision()
    }

    /// Whether the arm is where it was released to, or at the end of everything that is determined.
    #[must_use]
    pub fn motion_has_arrived(&self) -> bool {
        self.devices.state.arm.motion().has_arrived()
    }

    /// Why the arm rests before the end of what it was released to, and does not move on by itself.
    #[must_use]
    pub fn motion_hold(&self) -> Option<ArmHold> {
        self.devices.state.arm_standstill()
    }

    /// Where the arm is in the recorded moves.
    #[must_use]
    pub fn motion_status(&self) -> MotionStatus {
        let motion = self.devices.state.arm.motion();
        MotionStatus {
            mode: motion.mode(),
            is_moving: !self.devices.state.arm.is_at_rest(),
            has_arrived: motion.has_arrived(),
            piece: motion.piece().map(|piece| self.motion_piece(piece)),
            next: motion.next_piece().map(|piece| self.motion_piece(piece)),
            hold: self.motion_hold(),
        }
    }

    /// The recorded moves that are not done, the oldest first.
    #[must_use]
    pub fn motion_queue(&self) -> Vec<RecordedMove> {
        self.devices.state.arm.moves().map(|(queued, origin)| self.recorded_move(queued, origin)).collect()
    }

    fn recorded_move(&self, queued: &QueuedMove, origin: Option<&MoveOrigin>) -> RecordedMove {
        let motion = self.devices.state.arm.motion();
        let point = |corner: Option<Corner>, place: Option<(Joints, IsometryMatrix3<f64>)>| {
            let ((joints, pose), distance) = (place?, corner?.distance);
            Some(BlendPoint { distance, joints, pose })
        };
        RecordedMove {
            serial: queued.serial,
            id: queued.id,
            shape: queued.shape,
            joints: queued.joints,
            target: queued.target,
            descriptor: origin.map(|origin| origin.descriptor),
            stage: queued.stage,
            leave: point(queued.leave, motion.leave_point(queued.serial)),
            reach: point(queued.reach, motion.reach_point(queued.serial)),
            blend: self.devices.blend_of(queued, origin),
            source: origin.map(|origin| self.source(origin)),
        }
    }

    fn motion_piece(&self, piece: PathPiece) -> MotionPiece {
        let arm = &self.devices.state.arm;
        let position = arm.moves().position(|(queued, _)| queued.serial == piece.serial);
        let source = arm.origin(piece.serial).map(|origin| self.source(origin));
        MotionPiece { piece, position, source }
    }

    fn source(&self, &MoveOrigin { instruction, at, .. }: &MoveOrigin) -> CodeSource {
        let (program, line, file) = self.devices.place(at);
        CodeSource { instruction, at, program, line, file }
    }

    /// Records the moves that an application which has ended leaves undone, and the fault of their path.
    pub fn record_dropped_moves(&mut self) {
        let now = self.now();
        self.devices.record_dropped_moves(now);
    }

    /// The fault of the path before which the arm rests.
    #[must_use]
    pub fn motion_fault(&self) -> Option<MotionFault> {
        let arm = &self.devices.state.arm;
        let fault = arm.motion().stuck()?;
        let source = arm.origin(fault.serial).map(|origin| self.source(origin));
        Some(MotionFault { serial: fault.serial, text: fault.to_string(), source })
    }

    /// Lets all tasks rest, which programs do not notice: time passes, and the arm, inputs and outputs work.
    pub fn rest_tasks(&mut self, rest: bool) {
        self.schedule.tasks_rest = rest;
    }
}
