//! Keys for conveyors.

use schemars::JsonSchema;
use serde::Deserialize;

use super::shapes::BoxKey;
use super::signals::WhenKey;

/// A conveyor: a stationary box that moves the parts on it.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(default)]
pub struct ConveyorEntry {
    /// The name in messages: letters, digits, `_` and blanks.
    pub name: String,
    /// The carrier of the conveyor: `world` (default), `base`, a frame of the application, or a stationary object.
    #[serde(rename = "in")]
    #[schemars(with = "String")]
    pub carrier: Option<String>,
    /// The pose of the box in the carrier's frame, written as for an object.
    pub at: Vec<f64>,
    /// The belt: length, width and height around its centre, or its corners. Parts lie on its top.
    #[serde(rename = "box")]
    #[schemars(with = "BoxKey")]
    pub cuboid: Option<BoxKey>,
    /// The speed of the parts in mm/s, as a vector in the conveyor's frame: `[250, 0, 0]`.
    pub speed: Vec<f64>,
    /// Signal values at which the conveyor runs. Without them, it always runs.
    #[schemars(with = "WhenKey")]
    pub when: Option<WhenKey>,
    /// Parts that arrive on the conveyor from outside of the cell.
    #[schemars(with = "FeedKeys")]
    pub feed: Option<FeedKeys>,
    /// Effect on a part that reaches the end of the belt: `stop` by default.
    pub end: ConveyorEnd,
    /// The distance in mm below which something is too near to the conveyor, in place of the general clearance.
    #[schemars(with = "f64")]
    pub clearance: Option<f64>,
    /// The colour in pictures, for example `#5a6470`.
    #[schemars(with = "String")]
    pub colour: Option<String>,
}

/// Parts that arrive on a conveyor.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(default)]
pub struct FeedKeys {
    /// The name of a `[[part]]` without `in`, `at` and `step`. Its copies are outside of the cell at the start and
    /// arrive one after the other.
    pub part: String,
    /// The time between two parts in seconds, counted while the conveyor runs.
    pub every: f64,
    /// The pose of a new part in the conveyor's frame, written as for an object.
    pub at: Vec<f64>,
}

/// Effect on a part that reaches the end of a conveyor.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum ConveyorEnd {
    /// The part waits at the end, and later parts queue up.
    #[default]
    Stop,
    /// The part is removed when its centre has passed the end.
    Remove,
}
