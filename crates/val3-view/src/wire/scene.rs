//! Message `scene`: the constant content of a run.

use schemars::JsonSchema;
use serde::Serialize;
use val3_lang::types;

use super::{CellObject, CellPart};

/// x, y, z in mm, rx, ry, rz in degrees.
pub type Pose = [f64; 6];

/// Role of a reader.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Role {
    /// Operates a served run.
    Operator,
    /// Reads a served run.
    Guest,
    /// Reads a recording.
    Recording,
    /// Operates a debugged run.
    Debugger,
    /// Returns the scene before a run.
    Preview,
}

/// Unit of lengths in the application's data. All other lengths in messages are in mm.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum LengthUnit {
    /// Millimetres.
    Mm,
    /// Inches.
    Inch,
}

impl LengthUnit {
    /// Unit in a sentence, after a number.
    pub(crate) const fn word(self) -> &'static str {
        match self {
            Self::Mm => "mm",
            Self::Inch => "inches",
        }
    }
}

impl From<types::LengthUnit> for LengthUnit {
    fn from(unit: types::LengthUnit) -> Self {
        match unit {
            types::LengthUnit::Millimetre => Self::Mm,
            types::LengthUnit::Inch => Self::Inch,
        }
    }
}

/// Constant content of a run.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Scene {
    /// Version of the messages.
    pub version: u32,
    /// Role of the reader.
    pub role: Role,
    /// Application name.
    pub application: String,
    /// The arm.
    pub arm: ArmChain,
    /// Pose of the arm's base in world.
    #[schemars(with = "Pose")]
    pub base: [u8; 6],
    /// Length unit of the application's data.
    #[serde(rename = "lengthUnit")]
    pub length_unit: LengthUnit,
    /// Things around the arm.
    pub objects: Vec<CellObject>,
    /// Parts, whose places are in `parts` messages.
    pub parts: Vec<CellPart>,
    /// Frames with their initial values.
    pub frames: Vec<CellPoint>,
    /// Tools with their initial values.
    pub tools: Vec<CellPoint>,
    /// Points with their initial values.
    pub points: Vec<CellPoint>,
    /// Joint positions with their initial values.
    pub joints: Vec<JointValue>,
    /// Inputs and outputs.
    pub signals: Vec<SignalInfo>,
    /// Serial lines and sockets.
    pub lines: Vec<LineInfo>,
    /// Motion phase names by their numbers in samples.
    pub phases: Vec<String>,
    /// Names of the speed limits by their numbers in samples.
    pub limits: Vec<String>,
}

/// Chain of axes from the base to the flange.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct ArmChain {
    /// Model name.
    pub name: String,
    /// Whether the arm is a default, because neither a setting nor the cell names it.
    pub is_default: bool,
    /// Note about the accuracy of times.
    pub times_note: Option<String>,
    /// Axes from the base.
    pub axes: Vec<Axis>,
    /// Frames of the axes.
    pub links: Vec<Link>,
    /// Pose of the flange relative to the last frame.
    #[schemars(with = "Pose")]
    pub flange: Option<Pose>,
    /// Height of the `world` origin above the mounting face, in mm; 0 if unknown.
    pub height: f64,
    /// Capsules around the base and around each link, with which distances are computed; empty if the arm's description
    /// has none.
    pub capsules: Vec<Vec<Capsule>>,
    /// Shapes of the links in files; `null` if a link has no file.
    pub shapes: Vec<Option<LinkShape>>,
}

/// Axis limits, in degrees or, for a linear axis, mm.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Axis {
    /// Whether the axis is linear.
    pub is_linear: bool,
    /// Lowest position.
    pub min: f64,
    /// Highest position.
    pub max: f64,
    /// Nominal speed per second.
    pub speed: f64,
}

/// Axis frame.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Link {
    /// Pose relative to the previous frame.
    pub offset: Pose,
    /// Direction about or along which the axis moves.
    #[schemars(with = "[f64; 3]")]
    pub axis: [u8; 3],
}

/// The points within a radius of a line: a cylinder with rounded ends. Coordinates are in mm in the frame of the link
/// after its joint's movement, and in the arm's base for the base.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Capsule {
    /// One end of the line.
    pub from: [f64; 3],
    /// The other end; the same position for a sphere.
    pub to: [f64; 3],
    /// Radius in mm, greater than 0.
    pub radius: f64,
}

/// Shape of a link as a file.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct LinkShape {
    /// File format: `glb` or `stl`.
    #[schemars(extend("enum" = ["glb", "stl"]))]
    pub format: String,
    /// File content in base64.
    pub data: String,
    /// Length of the file's unit, in mm.
    pub unit: f64,
    /// Pose of the file's frame in the frame of the link. The y axis of a `glb` file is the z axis of this frame.
    pub pose: Pose,
}

/// Frame, tool or point.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct CellPoint {
    /// Data name, prefixed by the library.
    pub name: String,
    /// Index or key; `null` for data with a single value.
    pub key: Option<String>,
    /// Name of the data to which the value is relative.
    pub father: Option<String>,
    /// Pose in world, in mm and degrees; of a tool, relative to the flange.
    pub pose: Pose,
    /// Pose relative to the father, in the length unit of the application and degrees.
    #[schemars(with = "Pose")]
    pub local: Option<Vec<f64>>,
    /// Configuration of a point in words.
    pub config: Option<String>,
}

/// Joint position.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct JointValue {
    /// Data name, prefixed by the library.
    pub name: String,
    /// Index or key; `null` for data with a single value.
    pub key: Option<String>,
    /// Positions of the axes, in degrees or the length unit of the application.
    pub values: Vec<f64>,
}

/// Input or output.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct SignalInfo {
    /// Physical path.
    pub link: String,
    /// Data linked to the signal.
    pub names: Vec<String>,
    /// Path of the board; empty if unknown.
    pub board: String,
    /// `input` or `output`.
    #[schemars(extend("enum" = ["input", "output"]))]
    pub direction: String,
    /// Whether the signal has two states.
    pub is_digital: bool,
    /// Unit, if the signal is analog.
    pub unit: Option<String>,
    /// Free text.
    pub description: String,
}

/// Serial line or socket.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct LineInfo {
    /// Link of the line.
    pub link: String,
    /// Kind of the line.
    #[serde(rename = "type")]
    pub kind: String,
}
