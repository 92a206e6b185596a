//! The keys of `cell.toml`:
//!
//! ```toml
//! clearance = 20
//! allow = [["gripper", "rack*", "the pads touch the rack"]]
//!
//! [[object]]
//! name = "fence"
//! box = [2000, 40, 2200]
//! at = [0, 1100, 600]
//!
//! [[object]]
//! name = "gripper"
//! in = "flange"
//! shapes = [{ box = [120, 120, 60], at = [0, 0, 30] }, { cylinder = { radius = 20, length = 80 }, at = [0, 0, 100] }]
//! ```

mod conveyors;
mod grippers;
mod parts;
mod sensors;
mod shapes;
mod signals;

use std::borrow::Cow;

use camino::Utf8Path;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;

pub use self::conveyors::{ConveyorEnd, ConveyorEntry, FeedKeys};
pub use self::grippers::{GripperEntry, HoldingState};
pub use self::parts::PartEntry;
pub use self::sensors::{BeamKeys, SensorEntry};
pub(crate) use self::shapes::{BoxKey, Corners, MeshUnit};
pub use self::shapes::{ShapeEntry, ShapeKeys};
pub use self::signals::{SignalLevel, SignalValues, WhenKey};

/// The surroundings of the arm. Lengths are in mm, angles in degrees.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct CellFile {
    /// The distance in mm below which two things that do not touch are reported as a near miss. The default 0 reports
    /// only contacts.
    pub clearance: f64,
    /// Pairs that may touch, each with the reason: `["gripper", "rack*", "the pads touch the rack"]`. In names, `*`
    /// matches any characters. `arm` means all links.
    pub allow: Vec<AllowedPair>,
    /// Objects: stationary things, and things that the arm carries.
    #[serde(rename = "object")]
    pub objects: Vec<ObjectEntry>,
    /// Parts: things that a gripper can carry.
    #[serde(rename = "part")]
    pub parts: Vec<PartEntry>,
    /// Grippers, which carry parts while an output has its value for holding.
    #[serde(rename = "gripper")]
    pub grippers: Vec<GripperEntry>,
    /// Sensors, which set an input while they detect something.
    #[serde(rename = "sensor")]
    pub sensors: Vec<SensorEntry>,
    /// Conveyors, which move the parts on them.
    #[serde(rename = "conveyor")]
    pub conveyors: Vec<ConveyorEntry>,
}

impl CellFile {
    /// Returns the paths of all meshes, in file order.
    pub fn meshes(&self) -> impl Iterator<Item = &Utf8Path> {
        let objects = self.objects.iter().flat_map(|object| meshes_of(&object.shape, &object.shapes));
        let parts = self.parts.iter().flat_map(|part| meshes_of(&part.shape, &part.shapes));
        let zones = self.sensors.iter().filter_map(|sensor| sensor.zone.as_ref()?.shape.mesh.as_deref());
        objects.chain(parts).chain(zones)
    }
}

/// Returns the paths of the meshes in an entry.
fn meshes_of<'k>(shape: &'k ShapeKeys, shapes: &'k [ShapeEntry]) -> impl Iterator<Item = &'k Utf8Path> {
    let several = shapes.iter().map(|entry| &entry.shape);
    std::iter::once(shape).chain(several).filter_map(|keys| keys.mesh.as_deref())
}

/// Two names, and the reason why these things may touch.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(try_from = "Vec<String>")]
pub struct AllowedPair {
    /// The names, in which `*` matches any characters.
    pub names: [String; 2],
    /// The reason; may be empty.
    pub reason: String,
}

impl TryFrom<Vec<String>> for AllowedPair {
    type Error = &'static str;

    fn try_from(texts: Vec<String>) -> Result<Self, Self::Error> {
        let (names, reason) = match <[String; 3]>::try_from(texts) {
            Ok([first, second, reason]) => ([first, second], reason),
            Err(texts) => {
                (<[String; 2]>::try_from(texts).map_err(|_| "write two names, and the reason")?, String::new())
            }
        };
        Ok(Self { names, reason })
    }
}

impl JsonSchema for AllowedPair {
    fn schema_name() -> Cow<'static, str> {
        "AllowedPair".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "array", "items": { "type": "string" }, "minItems": 2, "maxItems": 3 })
    }
}

/// A thing that does not move by itself.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(default)]
pub struct ObjectEntry {
    /// The name in messages: letters, digits, `_` and blanks.
    pub name: String,
    /// The carrier: `world` (default); `base`, the mounting face of the arm; `flange`; `link1` and so on; a frame or
    /// tool of the application; another object.
    #[serde(rename = "in")]
    #[schemars(with = "String")]
    pub carrier: Option<String>,
    /// The pose of the shapes in the carrier's frame: x, y, z in mm and rx, ry, rz in degrees as in a trsf. rx, ry and
    /// rz may be omitted.
    pub at: Vec<f64>,
    /// The shapes of a thing with several shapes.
    pub shapes: Vec<ShapeEntry>,
    /// The distance in mm below which something is too near to this thing, in place of the general clearance.
    #[schemars(with = "f64")]
    pub clearance: Option<f64>,
    /// The colour in pictures, for example `#d9a400`.
    #[schemars(with = "String")]
    pub colour: Option<String>,
    /// The shape of a thing with one shape.
    #[serde(flatten)]
    pub shape: ShapeKeys,
}
