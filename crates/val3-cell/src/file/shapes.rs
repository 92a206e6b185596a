//! Keys for shapes.

use std::borrow::Cow;

use camino::{Utf8Path, Utf8PathBuf};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;

/// One shape of a thing with several shapes.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(default)]
pub struct ShapeEntry {
    /// The pose of the shape in the thing's frame, written as for an object.
    pub at: Vec<f64>,
    /// The shape.
    #[serde(flatten)]
    pub shape: ShapeKeys,
}

/// The keys for a shape. Exactly one form is used.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(default)]
pub struct ShapeKeys {
    /// A box: length, width and height around its centre, or its corners: `{ min = [0, 0, 0], max = [100, 50, 20] }`.
    #[serde(rename = "box")]
    #[schemars(with = "BoxKey")]
    pub cuboid: Option<BoxKey>,
    /// A cylinder around the z axis with its centre in the origin.
    #[schemars(with = "CylinderKey")]
    pub cylinder: Option<CylinderKey>,
    /// A sphere around the origin.
    #[schemars(with = "SphereKey")]
    pub sphere: Option<SphereKey>,
    /// The points within a radius of a line: a cylinder with round ends.
    #[schemars(with = "CapsuleKey")]
    pub capsule: Option<CapsuleKey>,
    /// An STL file (mm, z up) or a GLB file (m, y up), relative to the folder of this file. A stationary thing is
    /// compared by the mesh surface, so that other things can be inside of it. A thing on the arm is compared by the
    /// convex hull.
    #[schemars(with = "String")]
    pub mesh: Option<Utf8PathBuf>,
    /// The length unit of the mesh: `mm` by default, `m` for a GLB file.
    #[schemars(with = "MeshUnit")]
    pub unit: Option<MeshUnit>,
    /// Whether to use the convex hull of the mesh (`true`) or the mesh surface (`false`).
    #[schemars(with = "bool")]
    pub hull: Option<bool>,
}

/// A box.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(untagged, expecting = "a box is [length, width, height], or { min = [x, y, z], max = [x, y, z] }")]
pub enum BoxKey {
    /// Length, width and height.
    Size(Vec<f64>),
    /// Two corners.
    Corners(Corners),
}

/// Two corners of a box.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(default)]
pub struct Corners {
    /// The smallest coordinates.
    pub min: Vec<f64>,
    /// The greatest coordinates.
    pub max: Vec<f64>,
}

impl JsonSchema for BoxKey {
    fn schema_name() -> Cow<'static, str> {
        "BoxKey".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let corner = json_schema!({ "type": "array", "items": { "type": "number" }, "minItems": 3, "maxItems": 3 });
        json_schema!({
            "type": ["array", "object"],
            "items": { "type": "number" },
            "properties": { "min": corner, "max": corner },
            "additionalProperties": false,
        })
    }
}

/// A cylinder.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(default)]
pub struct CylinderKey {
    /// The radius.
    pub radius: f64,
    /// The length along the z axis.
    pub length: f64,
}

/// A sphere.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(default)]
pub struct SphereKey {
    /// The radius.
    pub radius: f64,
}

/// A capsule.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(default)]
pub struct CapsuleKey {
    /// One end of the line.
    pub from: Vec<f64>,
    /// The other end of the line.
    pub to: Vec<f64>,
    /// The radius.
    pub radius: f64,
}

/// Length unit of a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum MeshUnit {
    /// Millimetres.
    Mm,
    /// Metres.
    M,
}

impl MeshUnit {
    /// Returns the default unit for a mesh file, by its extension.
    pub(crate) fn of(path: &Utf8Path) -> Self {
        let is_glb = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("glb"));
        if is_glb { Self::M } else { Self::Mm }
    }

    /// Returns the length of the unit in mm.
    pub(crate) const fn length(self) -> f64 {
        match self {
            Self::Mm => 1.0,
            Self::M => 1000.0,
        }
    }
}
