//! Keys for parts.

use schemars::JsonSchema;
use serde::Deserialize;

use super::shapes::{ShapeEntry, ShapeKeys};

/// A thing that a gripper can carry, in one or more copies.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(default)]
pub struct PartEntry {
    /// The name in messages: letters, digits, `_` and blanks. Copies have an index: `carton[0]`.
    pub name: String,
    /// The carrier at the start: `world` (default), `base`, a frame of the application, or a stationary object.
    #[serde(rename = "in")]
    #[schemars(with = "String")]
    pub carrier: Option<String>,
    /// The pose of the shapes in the carrier's frame, written as for an object.
    pub at: Vec<f64>,
    /// The number of parts.
    #[schemars(with = "u32")]
    pub copies: Option<u32>,
    /// The shift in mm from one copy to the next.
    pub step: Vec<f64>,
    /// The overlap depth in mm up to which nothing is a contact, because parts touch their supports. 1 by default.
    pub touch: f64,
    /// The shapes of a part with several shapes.
    pub shapes: Vec<ShapeEntry>,
    /// The distance in mm below which something is too near to this part. Without it, only clearances of objects apply.
    #[schemars(with = "f64")]
    pub clearance: Option<f64>,
    /// The colour in pictures, for example `#b5651d`.
    #[schemars(with = "String")]
    pub colour: Option<String>,
    /// The shape of a part with one shape.
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
