//! Things around the arm, a part of the message `scene`.

use schemars::JsonSchema;
use serde::Serialize;

use super::Pose;

/// Thing around the arm.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct CellObject {
    /// Name in events.
    pub name: String,
    /// Colour as `#rrggbb`; `null` for the default.
    pub colour: Option<String>,
    /// Carrier of the thing.
    pub carrier: ObjectCarrier,
    /// Shapes in the frame of the carrier.
    pub shapes: Vec<ObjectShape>,
}

/// Part that a gripper can carry.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct CellPart {
    /// Name in events.
    pub name: String,
    /// Colour as `#rrggbb`; `null` for the default.
    pub colour: Option<String>,
    /// Shapes in the frame of the part.
    pub shapes: Vec<ObjectShape>,
}

/// Places of the parts.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct PartsMessage {
    /// Time in s.
    pub t: f64,
    /// All parts.
    pub parts: Vec<PartPlace>,
}

/// Place of a part.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct PartPlace {
    /// Name of the part.
    pub name: String,
    /// Carrier of the part; `null` if it was removed.
    pub carrier: Option<ObjectCarrier>,
    /// Pose of the part in the frame of the carrier.
    pub pose: Pose,
}

/// Frame in which a thing rests.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "camelCase")]
pub enum ObjectCarrier {
    /// `world`.
    World,
    /// Frame of the application.
    Frame {
        /// Name as in a program: `fPallet`, `fPallets[1]`.
        name: String,
    },
    /// Flange of the arm.
    Flange,
    /// Tool of the application.
    Tool {
        /// Name as in a program.
        name: String,
    },
    /// Link of the arm.
    Link {
        /// Number from 1; 0 is the base.
        link: usize,
    },
}

/// Shape of a thing, with the pose of its frame in the frame of the carrier. Lengths are in mm.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "camelCase")]
pub enum ObjectShape {
    /// Box around the origin.
    Box {
        /// Pose of the shape.
        pose: Pose,
        /// Lengths along x, y and z.
        size: [f64; 3],
    },
    /// Cylinder around z; the origin is in its centre.
    Cylinder {
        /// Pose of the shape.
        pose: Pose,
        /// Radius.
        radius: f64,
        /// Length along z.
        length: f64,
    },
    /// Capsule, or a sphere.
    Capsule {
        /// Pose of the shape.
        pose: Pose,
        /// One end of the line.
        from: [f64; 3],
        /// The other end; the same position for a sphere.
        to: [f64; 3],
        /// Radius.
        radius: f64,
    },
    /// Triangles.
    Mesh {
        /// Pose of the shape.
        pose: Pose,
        /// Coordinates of the corners in base64: three `f32` in little endian for each corner, three corners for each
        /// triangle.
        corners: String,
    },
}
