//! Message `motion`: the recorded moves, and the remaining path of the tool centre point.

use schemars::JsonSchema;
use serde::Serialize;
use val3_machine::blend_ends;

use super::scene::Pose;

/// Recorded moves and remaining path.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MotionMessage {
    /// Time in s.
    pub t: f64,
    /// Recorded moves in their order.
    pub queue: Vec<QueueEntry>,
    /// Path of the tool centre point to the last destination.
    pub path: Vec<WayPiece>,
}

/// Recorded move.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct QueueEntry {
    /// Id of the move (`getMoveId`).
    pub id: f64,
    /// Name of the instruction.
    #[serde(rename = "type")]
    pub instruction: Option<String>,
    /// Number of the line that requests the move.
    pub source: u16,
    /// Executed part in a word.
    pub phase: String,
    /// Pose of the tool centre point at the destination.
    pub target: Pose,
    /// Pose where the blend around the destination begins.
    pub leave: Option<Pose>,
    /// Pose where this blend ends.
    pub reach: Option<Pose>,
    /// Effective leave distance, in mm.
    pub leave_distance: Option<f64>,
    /// Effective reach distance, in mm.
    pub reach_distance: Option<f64>,
    /// Requested and effective distances.
    #[schemars(with = "BlendEnds")]
    pub blend: blend_ends::BlendEnds,
    /// Reason why the blend is shorter than requested.
    pub blend_cut_short: Option<String>,
}

/// Piece of the remaining path.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct WayPiece {
    /// Phase of motion.
    pub phase: String,
    /// Positions of the tool centre point, in mm.
    pub points: Vec<[f64; 3]>,
}

/// Requested and effective distances of both ends of a blend.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct BlendEnds {
    /// Beginning of the blend.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub leave: Option<BlendDistance>,
    /// End of the blend.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reach: Option<BlendDistance>,
}

/// Distance of one end of a blend to the destination.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct BlendDistance {
    /// Distance of the motion descriptor, in mm.
    pub requested: f64,
    /// Effective distance, in mm.
    pub effective: f64,
    /// Kind of reason for a shorter distance.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
    /// Program of the line that is the reason.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub program: Option<String>,
    /// Line that is the reason, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<u32>,
}
