//! Keys for conveyors.

use schemars::JsonSchema;
use serde::Deserialize;

use super::shapes::BoxKey;
use super::signals::WhenKey;

/// A conveyor: a box that stands, and that shifts the parts on it.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(default)]
pub struct ConveyorEntry {
    /// The name in messages: letters, digits, `_` and blanks.
    pub name: String,
    /// The carrier of the conveyor: `world` (default), `base`, a frame of the application, or an object that stands.
    #[serde(rename = "in")]
    #[schemars(with = "String")]
    pub carrier: Option<String>,
    /// The pose of the box in that frame, as the pose of an object.
    pub at: Vec<f64>,
    /// The belt: length, width and height around its centre, or its corners. Parts lie on its top.
    #[serde(rename = "box")]
    #[schemars(with = "BoxKey")]
    pub cuboid: Option<BoxKey>,
    /// The speed of the parts in mm/s, in the frame of the conveyor: `[250, 0, 0]`.
    pub speed: Vec<f64>,
    /// Values of signals while which the conveyor runs. It always runs without them.
    #[schemars(with = "WhenKey")]
    pub when: Option<WhenKey>,
    /// Parts that the conveyor receives from outside of the cell.
    #[schemars(with = "FeedKeys")]
    pub feed: Option<FeedKeys>,
    /// Effect of the end of the belt on a part: `stop` by default.
    pub end: ConveyorEnd,
    /// The distance below which something is too near to the conveyor, in place of the general one.
    #[schemars(with = "f64")]
    pub clearance: Option<f64>,
    /// The colour in pictures: `#5a6470`.
    #[schemars(with = "String")]
    pub colour: Option<String>,
}

/// Parts that a conveyor receives.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(default)]
pub struct FeedKeys {
    /// The name of a `[[part]]` without a place. Its copies are outside of the cell at the start, and arrive one after the
    /// other.
    pub part: String,
    /// The time in seconds from one part to the next, while the conveyor runs.
    pub every: f64,
    /// The pose of a new part in the frame of the conveyor, as the pose of an object.
    pub at: Vec<f64>,
}

/// Effect of the end of a conveyor on a part.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum ConveyorEnd {
    /// The part waits at the end, and parts queue up after it.
    #[default]
    Stop,
    /// The part leaves the cell when its centre has passed the end.
    Remove,
}
