//! Keys for grippers.

use schemars::JsonSchema;
use serde::Deserialize;

use super::signals::{SignalValues, WhenKey};

/// A gripper: it carries the nearest part while an output has its value for holding.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(default)]
pub struct GripperEntry {
    /// The tool of the application whose output controls the gripper, with the delays `ioOpen` and `ioClose`.
    #[schemars(with = "String")]
    pub tool: Option<String>,
    /// The instruction with which a tool's gripper holds a part: `close` by default.
    #[schemars(with = "HoldingState")]
    pub holds: Option<HoldingState>,
    /// Signal values at which a gripper without a tool holds a part.
    #[schemars(with = "WhenKey")]
    pub when: Option<WhenKey>,
    /// The carrier of a gripper without a tool: `flange` (default), or a tool of the application.
    #[serde(rename = "in")]
    #[schemars(with = "String")]
    pub carrier: Option<String>,
    /// The grip point of a gripper without a tool, in the carrier's frame, written as for an object.
    pub at: Vec<f64>,
    /// The largest distance in mm between a gripped part and the grip point. 5 by default.
    pub within: f64,
    /// Input values while the gripper holds a part.
    pub holding: SignalValues,
    /// Input values while the gripper holds no part.
    pub empty: SignalValues,
    /// The objects that belong to the gripper and may touch parts; by default, all objects on the flange and on the
    /// tool.
    #[schemars(with = "Vec<String>")]
    pub objects: Option<Vec<String>>,
}

impl Default for GripperEntry {
    fn default() -> Self {
        Self {
            tool: None,
            holds: None,
            when: None,
            carrier: None,
            at: Vec::new(),
            within: 5.0,
            holding: SignalValues::default(),
            empty: SignalValues::default(),
            objects: None,
        }
    }
}

/// The instruction with which a gripper holds a part.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum HoldingState {
    /// `close`: the output is false.
    Close,
    /// `open`: the output is true.
    Open,
}
