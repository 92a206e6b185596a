//! Keys for parts.

use schemars::JsonSchema;
use serde::Deserialize;

use super::shapes::{ShapeEntry, ShapeKeys};

/// A thing that a gripper can carry, once or several times.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(default)]
pub struct PartEntry {
    /// The name in messages: letters, digits, `_` and blanks. Copies have an index: `carton[0]`.
    pub name: String,
    /// The place at the start: `world` (default), `base`, a frame of the application, or an object that stands.
    #[serde(rename = "in")]
    #[schemars(with = "String")]
    pub carrier: Option<String>,
    /// The pose of the shapes in that frame, as the pose of an object.
    pub at: Vec<f64>,
    /// The number of parts.
    #[schemars(with = "u32")]
    pub copies: Option<u32>,
    /// The shift in mm from one copy to the next.
    pub step: Vec<f64>,
    /// The depth in mm of an overlap that is no contact: parts touch what they stand on. 1 by default.
    pub touch: f64,
    /// The shapes of a part that has several.
    pub shapes: Vec<ShapeEntry>,
    /// The distance below which something is too near to this part. Without it, only the own distances of objects count.
    #[schemars(with = "f64")]
    pub clearance: Option<f64>,
    /// The colour in pictures: `#b5651d`.
    #[schemars(with = "String")]
    pub colour: Option<String>,
    /// The shape of a part that has one.
    #[serde(flatten)]
    pub shape: ShapeKeys,
}

impl Default for PartEntry {
    fn default() -> Self {
        Self {
            name: String::new(),
            carrier: None,
            at: Vec::new(),
            copies: None,
            step: Vec::new(),
            touch: 1.0,
            shapes: Vec::new(),
            clearance: None,
            colour: None,
            shape: ShapeKeys::default(),
        }
    }
}
