//! Commands of pages: arguments and responses.

use std::fmt;
use std::ops::RangeInclusive;

use schemars::JsonSchema;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use val3_geometry::Trsf;

use super::scene::Pose;

/// Range of paces in real time.
const SPEEDS: RangeInclusive<f64> = 0.1..=100.0;

/// Command with its arguments. A page adds `id`, the number by which it finds the response.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(tag = "command", rename_all = "camelCase")]
pub enum Command {
    /// Executes keys of a script.
    Operate(Operate),
    /// Sets a point.
    SetPoint(SetPoint),
    /// Sets a point or joint position to the current position of the arm.
    Teach(Teach),
    /// Computes a frame from three positions of the arm.
    TeachFrame(TeachFrame),
    /// Computes the centre point of a tool from positions in which its tip touches the same place.
    TeachTool(TeachTool),
    /// Restores the value before the last change.
    Undo,
    /// Computes the joint positions that reach a point or joint position. Changes nothing.
    Solve(Solve),
    /// Lists the points and joint positions that are out of reach. Changes nothing.
    Reach(Reach),
    /// Writes changed points to their files.
    Save(Save),
    /// Shows another user page.
    UserPage(UserPage),
    /// Changes the pace of a served run.
    Pace(Pace),
    /// Executes cycles while a served run is paused.
    Cycle(Cycle),
    /// Records a scenario of a served run.
    Record(RecordScenario),
    /// Starts the application again after a served run has ended.
    Run(StartAgain),
}

/// Arguments of `operate`.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
pub struct Operate {
    /// Keys of a script.
    pub keys: Map<String, Value>,
}

/// Point name, with an index or key.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema)]
pub struct PointName {
    /// Data name, prefixed by the library.
    pub name: String,
    /// Index or key; `null` for data with a single value.
    pub key: Option<String>,
}

/// Arguments of `teach`.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
pub struct Teach {
    /// Data name, prefixed by the library.
    pub name: String,
    /// Index or key; `null` for data with a single value.
    pub key: Option<ElementKey>,
    /// Tool whose centre point counts; the tool of the last move if missing.
    #[schemars(with = "ToolName", default)]
    pub tool: Option<ToolName>,
    /// Frame in which a point is taught, which becomes its father; its present father if missing.
    #[schemars(with = "FrameName", default)]
    pub frame: Option<FrameName>,
}

/// Frame name, with an index or key.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
pub struct FrameName {
    /// Data name, prefixed by the library, or `world`.
    pub name: String,
    /// Index or key; `null` for data with a single value.
    pub key: Option<ElementKey>,
}

/// Arguments of `solve`.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
pub struct Solve {
    /// Data name, prefixed by the library.
    pub name: String,
    /// Index or key; `null` for data with a single value.
    pub key: Option<ElementKey>,
    /// Tool whose centre point counts; the tool of the last move if missing.
    #[schemars(with = "ToolName", default)]
    pub tool: Option<ToolName>,
}

/// Arguments of `teachFrame`.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
pub struct TeachFrame {
    /// Frame name, prefixed by the library.
    pub name: String,
    /// Index or key; `null` for data with a single value.
    pub key: Option<ElementKey>,
    /// Tool whose centre point counts; the tool of the last move if missing.
    #[schemars(with = "ToolName", default)]
    pub tool: Option<ToolName>,
    /// Joints of the arm, in degrees or mm: at the origin, on the positive x axis, and in the xy plane at positive y.
    pub joints: [Vec<f64>; 3],
}

/// Arguments of `teachTool`.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
pub struct TeachTool {
    /// Tool name, prefixed by the library.
    pub name: String,
    /// Index or key; `null` for data with a single value.
    pub key: Option<ElementKey>,
    /// Joints of the arm, in degrees or mm, in at least four positions in which the tip touches the same place.
    pub joints: Vec<Vec<f64>>,
}

/// Arguments of `reach`.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
pub struct Reach {
    /// Tool whose centre point counts; the tool of the last move if missing.
    #[schemars(with = "ToolName", default)]
    pub tool: Option<ToolName>,
}

/// Tool name, with an index or key.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
pub struct ToolName {
    /// Data name, prefixed by the library, or `flange`.
    pub name: String,
    /// Index or key; `null` for data with a single value.
    pub key: Option<ElementKey>,
}

/// Arguments of `setPoint`.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
pub struct SetPoint {
    /// Data name, prefixed by the library.
    pub name: String,
    /// Index or key; `null` for data with a single value.
    pub key: Option<ElementKey>,
    /// New pose relative to the father, in the length unit of the application and degrees.
    pub local: Pose,
}

/// Element index or key.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum ElementKey {
    /// Index in a one-dimensional array.
    Index(u64),
    /// Index, indexes or key as text: `1`, `1,2`, `left`.
    Text(String),
}

/// Arguments of `save`.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
pub struct Save {
    /// Whether to overwrite files that were changed since they were loaded.
    #[serde(default)]
    pub overwrite: bool,
}

/// Arguments of `run`.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct StartAgain {
    /// Whether the arm starts at the initial position of the settings. Otherwise it stays where it is.
    #[serde(default)]
    pub at_initial_position: bool,
}

/// Arguments of `userPage`.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
pub struct UserPage {
    /// Page to show.
    pub to: PageChoice,
}

/// User page, relative to the current one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum PageChoice {
    /// The next page.
    Next,
    /// The previous page.
    Previous,
    /// The first page.
    First,
    /// The last page.
    Last,
}

/// Arguments of `pace`. Missing values do not change.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Pace {
    /// Whether to pause the run.
    #[schemars(with = "bool", default)]
    pub is_paused: Option<bool>,
    /// Pace: a number from 0.1 to 100, or `max`.
    #[schemars(with = "PaceSpeed", default)]
    pub speed: Option<PaceSpeed>,
}

/// Pace of a run: controller seconds per real second, or `max`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum PaceSpeed {
    /// Controller seconds per real second.
    Times(f64),
    /// As fast as possible.
    Fastest(Fastest),
}

/// Word for the fastest pace.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum Fastest {
    /// As fast as possible.
    #[serde(rename = "max")]
    Max,
}

/// Arguments of `cycle`.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
pub struct Cycle {
    /// Number of cycles, from 1 to 250; 1 if missing.
    #[schemars(with = "u64", default)]
    pub cycles: Option<u64>,
}

/// Arguments of `record`.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
pub struct RecordScenario {
    /// Name of the scenario.
    pub name: String,
}

/// Response of `save`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub enum Saved {
    /// The written files.
    Files(Vec<String>),
    /// Files that were changed since they were loaded. Nothing was written.
    Conflict(Vec<String>),
}

/// Response of `solve`.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Solved {
    /// Configurations in their order; a single entry for a joint position.
    pub solutions: Vec<ArmSolution>,
}

/// Joint position in a configuration.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct ArmSolution {
    /// Configuration in words; `null` for a joint position.
    pub config: Option<String>,
    /// Positions of the axes, in degrees or mm; `null` if the arm cannot reach the pose in this configuration.
    pub joints: Option<Vec<f64>>,
    /// Reason why the arm cannot reach the pose.
    pub reason: Option<String>,
    /// Whether `movej` would end at these joints.
    pub is_chosen: bool,
}

/// Response of `reach`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Reached {
    /// Points and joint positions to which `movej` cannot move the arm.
    pub unreachable: Vec<UnreachableValue>,
}

/// Point or joint position out of reach.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct UnreachableValue {
    /// Data name, prefixed by the library.
    pub name: String,
    /// Index or key; `null` for data with a single value.
    pub key: Option<String>,
    /// Reason why the arm cannot reach the value.
    pub reason: String,
}

/// Response of `teachTool`.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct TaughtTool {
    /// Largest distance of the tip from the touched place, in mm.
    pub residual: f64,
}

/// Response of `record`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Recorded {
    /// Path of the scenario.
    pub file: String,
    /// Content of the scenario.
    pub text: String,
    /// Parts of the run that the scenario does not repeat or expect.
    pub remarks: Vec<String>,
}

/// Arguments that are read key by key, so that an error names the key. Unknown keys are ignored.
pub trait Arguments: Sized {
    /// Reads the arguments.
    ///
    /// # Errors
    /// An argument is missing or invalid.
    fn read(arguments: &Map<String, Value>) -> Result<Self, CommandError>;
}

impl Arguments for Operate {
    fn read(arguments: &Map<String, Value>) -> Result<Self, CommandError> {
        Ok(Self { keys: value(arguments, "keys", "`keys` is an object with the keys of a script")? })
    }
}

impl Arguments for SetPoint {
    fn read(arguments: &Map<String, Value>) -> Result<Self, CommandError> {
        let local = value(arguments, "local", "`local` has six numbers: x, y, z, rx, ry, rz")?;
        let Solve { name, key, .. } = Solve::read(arguments)?;
        Ok(Self { name, key, local })
    }
}

impl Arguments for Teach {
    fn read(arguments: &Map<String, Value>) -> Result<Self, CommandError> {
        let Solve { name, key, tool } = Solve::read(arguments)?;
        let reason = "`frame` has the `name` and `key` of a frame";
        Ok(Self { name, key, tool, frame: optional::<Option<FrameName>>(arguments, "frame", reason)?.flatten() })
    }
}

impl Arguments for Solve {
    fn read(arguments: &Map<String, Value>) -> Result<Self, CommandError> {
        let name = value(arguments, "name", "`name` is that of a point")?;
        let reason = "`key` is a whole number from 0, or a text: \"1\", \"1,2\" or the key of a collection";
        let key = optional::<Option<ElementKey>>(arguments, "key", reason)?.flatten();
        let Reach { tool } = Reach::read(arguments)?;
        Ok(Self { name, key, tool })
    }
}

impl Arguments for TeachFrame {
    fn read(arguments: &Map<String, Value>) -> Result<Self, CommandError> {
        let Solve { name, key, tool } = Solve::read(arguments)?;
        Ok(Self { name, key, tool, joints: value(arguments, "joints", "`joints` has three joint positions")? })
    }
}

impl Arguments for TeachTool {
    fn read(arguments: &Map<String, Value>) -> Result<Self, CommandError> {
        let Solve { name, key, .. } = Solve::read(arguments)?;
        Ok(Self { name, key, joints: value(arguments, "joints", "`joints` is an array of joint positions")? })
    }
}

impl Arguments for Reach {
    fn read(arguments: &Map<String, Value>) -> Result<Self, CommandError> {
        let reason = "`tool` has the `name` and `key` of a tool";
        Ok(Self { tool: optional::<Option<ToolName>>(arguments, "tool", reason)?.flatten() })
    }
}

impl Arguments for Save {
    fn read(arguments: &Map<String, Value>) -> Result<Self, CommandError> {
        Ok(Self { overwrite: arguments.get("overwrite") == Some(&Value::Bool(true)) })
    }
}

impl Arguments for StartAgain {
    fn read(arguments: &Map<String, Value>) -> Result<Self, CommandError> {
        let reason = "`atInitialPosition` is true or false";
        Ok(Self { at_initial_position: optional(arguments, "atInitialPosition", reason)?.unwrap_or_default() })
    }
}

impl Arguments for UserPage {
    fn read(arguments: &Map<String, Value>) -> Result<Self, CommandError> {
        Ok(Self { to: value(arguments, "to", "`to` is \"next\", \"previous\", \"first\" or \"last\"")? })
    }
}

impl Arguments for Pace {
    fn read(arguments: &Map<String, Value>) -> Result<Self, CommandError> {
        let is_paused = optional(arguments, "isPaused", "`isPaused` is true or false")?;
        let reason = "`speed` is a number from 0.1 to 100, or \"max\"";
        let speed = optional(arguments, "speed", reason)?;
        if matches!(speed, Some(PaceSpeed::Times(speed)) if !SPEEDS.contains(&speed)) {
            return Err(reason.into());
        }
        Ok(Self { is_paused, speed })
    }
}

impl Arguments for RecordScenario {
    fn read(arguments: &Map<String, Value>) -> Result<Self, CommandError> {
        Ok(Self { name: value(arguments, "name", "`name` is the name of the scenario")? })
    }
}

impl ElementKey {
    /// Text as in the names of points.
    #[must_use]
    pub fn into_text(self) -> String {
        match self {
            Self::Index(index) => index.to_string(),
            Self::Text(text) => text,
        }
    }
}

impl SetPoint {
    /// New values of the point.
    #[must_use]
    pub const fn trsf(&self) -> Trsf {
        let [x, y, z, rx, ry, rz] = self.local;
        Trsf { x, y, z, rx, ry, rz }
    }
}

/// Reads a required argument. `reason` is the sentence of the error.
fn value<T: DeserializeOwned>(arguments: &Map<String, Value>, name: &str, reason: &str) -> Result<T, CommandError> {
    optional(arguments, name, reason)?.ok_or_else(|| reason.into())
}

fn optional<T: DeserializeOwned>(
    arguments: &Map<String, Value>,
    name: &str,
    reason: &str,
) -> Result<Option<T>, CommandError> {
    arguments.get(name).map(|value| T::deserialize(value).map_err(|_| reason.into())).transpose()
}

/// Reason why a command was not executed, for users.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CommandError(pub(crate) String);

impl fmt::Display for CommandError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for CommandError {}

impl From<&str> for CommandError {
    fn from(text: &str) -> Self {
        Self(text.to_owned())
    }
}
