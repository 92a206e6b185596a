//! Keys for sensors.

use schemars::JsonSchema;
use serde::Deserialize;

use super::shapes::ShapeEntry;

/// A sensor: it sets an input while something is in its beam or zone.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(default)]
pub struct SensorEntry {
    /// The name in messages and conditions: letters, digits, `_` and blanks.
    pub name: String,
    /// The carrier of the sensor, named like the carrier of objects.
    #[serde(rename = "in")]
    #[schemars(with = "String")]
    pub carrier: Option<String>,
    /// The line of a light barrier, which detects what interrupts it.
    #[schemars(with = "BeamKeys")]
    pub beam: Option<BeamKeys>,
    /// The shape in which the sensor detects things.
    #[schemars(with = "ShapeEntry")]
    pub zone: Option<ShapeEntry>,
    /// The input, which is true while the sensor detects something.
    #[schemars(with = "String")]
    pub io: Option<String>,
    /// Whether the input is false while the sensor detects something.
    pub not: bool,
    /// Names of the parts, objects and links that the sensor detects. `*` matches any characters; `arm` means all
    /// links. By default, all parts.
    #[schemars(with = "Vec<String>")]
    pub sees: Option<Vec<String>>,
    /// The delay in seconds between the detection and the change of the input.
    pub delay: f64,
}

/// The ends of a beam.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(default)]
pub struct BeamKeys {
    /// One end of the line.
    pub from: Vec<f64>,
    /// The other end of the line.
    pub to: Vec<f64>,
}
