//! Moves and the position of the arm in requests and events `val3/…`. Lengths are in mm, angles in degrees.

use schemars::JsonSchema;
use serde::Serialize;
use serde_json::{Map, Value};
use val3_lang::enumerations::blend_name;
use val3_lang::values::MdescValue;
use val3_machine::blend_ends::BlendEnds;
use val3_machine::controller::{BlendPoint, CodeSource, Controller, MotionPiece, RecordedMove};
use val3_view::coordinates;

/// Line that requested a move.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(crate) struct CodeLine {
    /// Instruction, for example `movel`.
    instruction: &'static str,
    /// Program name.
    program: String,
    /// Line of the file, from 1.
    line: u32,
    /// Path of the file.
    file: String,
}

/// Position and motion of the arm at a time.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(crate) struct ArmSample {
    /// Time since the start of the run, in seconds.
    t: f64,
    /// Joint position.
    joints: Vec<f64>,
    /// Pose in `world`: x, y, z, rx, ry, rz.
    pose: [f64; 6],
    /// Speed of the tool centre point, in mm/s.
    speed: f64,
    /// Value of `getMoveId()`.
    move_id: f64,
    /// Kind of motion.
    phase: &'static str,
    /// Line of the current move.
    source: Option<CodeLine>,
}

/// Piece of the motion in step mode.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(crate) struct MovePiece {
    /// Id of the move.
    move_id: f64,
    /// `nominal` or `blend`.
    kind: &'static str,
    /// Kind of end point: `leave`, `reach`, `target` or `fault`.
    end: &'static str,
    /// Joint position at the end.
    joints: [f64; 6],
    /// Pose at the end.
    pose: [f64; 6],
    /// Index of the move in the motion queue.
    position: Option<usize>,
    /// Line of the move.
    source: Option<CodeLine>,
}

/// Recorded move that is not done.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(crate) struct QueuedMove {
    /// Id of the move.
    id: f64,
    /// Instruction, for example `movel`.
    r#type: Option<&'static str>,
    /// Executed part: `waiting`, `nominal` or `blend`.
    phase: &'static str,
    /// Joint position at the target.
    joints: [f64; 6],
    /// Pose of the target.
    target: [f64; 6],
    /// Motion descriptor.
    mdesc: Option<MotionDescriptor>,
    /// Begin of the blend around the target.
    leave: Option<BlendEnd>,
    /// End of the blend, after the next move determines it.
    reach: Option<BlendEnd>,
    /// Requested and effective distances of the blend, as in the event of a run.
    #[schemars(with = "Map<String, Value>")]
    blend: BlendEnds,
    /// Line of the move.
    source: Option<CodeLine>,
}

/// Motion descriptor: speeds and accelerations in % of the nominal ones.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
struct MotionDescriptor {
    accel: f64,
    vel: f64,
    decel: f64,
    /// In mm/s.
    tvel: f64,
    /// In degrees/s.
    rvel: f64,
    /// `off`, `joint` or `Cartesian`.
    blend: &'static str,
    /// In mm.
    leave: f64,
    /// In mm.
    reach: f64,
}

/// End of a blend.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
struct BlendEnd {
    /// Effective distance to the target.
    distance: f64,
    /// Joint position.
    joints: [f64; 6],
    /// Pose.
    pose: [f64; 6],
}

impl ArmSample {
    /// Returns the present sample, with this time.
    pub(crate) fn new(t: f64, controller: &Controller) -> Self {
        let arm = controller.arm();
        let sample = arm.sample();
        let moving = controller.motion_status().piece.and_then(|piece| piece.source);
        Self {
            t,
            joints: sample.joints.iter().copied().take(arm.model().axes()).collect(),
            pose: coordinates(&sample.pose),
            speed: sample.speed.0,
            move_id: sample.id,
            phase: sample.phase.word(),
            source: moving.as_ref().map(CodeLine::from),
        }
    }

    /// Whether only the time differs.
    pub(crate) fn is_same_motion(&self, other: &Self) -> bool {
        *self == Self { t: self.t, ..other.clone() }
    }
}

impl From<&CodeSource> for CodeLine {
    fn from(source: &CodeSource) -> Self {
        let CodeSource { instruction, program, line, file, .. } = source;
        Self { instruction, program: program.clone(), line: *line, file: file.clone() }
    }
}

impl From<&MotionPiece> for MovePiece {
    fn from(MotionPiece { piece, position, source }: &MotionPiece) -> Self {
        Self {
            move_id: piece.id,
            kind: piece.kind.word(),
            end: piece.end.word(),
            joints: piece.joints,
            pose: coordinates(&piece.pose),
            position: *position,
            source: source.as_ref().map(CodeLine::from),
        }
    }
}

impl From<&RecordedMove> for QueuedMove {
    fn from(recorded: &RecordedMove) -> Self {
        Self {
            id: recorded.id,
            r#type: recorded.source.as_ref().map(|source| source.instruction),
            phase: recorded.stage.word(),
            joints: recorded.joints,
            target: coordinates(&recorded.target),
            mdesc: recorded.descriptor.as_ref().map(MotionDescriptor::from),
            leave: recorded.leave.as_ref().map(BlendEnd::from),
            reach: recorded.reach.as_ref().map(BlendEnd::from),
            blend: recorded.blend.clone(),
            source: recorded.source.as_ref().map(CodeLine::from),
        }
    }
}

impl From<&MdescValue> for MotionDescriptor {
    fn from(mdesc: &MdescValue) -> Self {
        Self {
            accel: mdesc.accel,
            vel: mdesc.vel,
            decel: mdesc.decel,
            tvel: mdesc.tvel,
            rvel: mdesc.rvel,
            blend: blend_name(mdesc.blend),
            leave: mdesc.leave,
            reach: mdesc.reach,
        }
    }
}

impl From<&BlendPoint> for BlendEnd {
    fn from(point: &BlendPoint) -> Self {
        Self { distance: point.distance.0, joints: point.joints, pose: coordinates(&point.pose) }
    }
}
