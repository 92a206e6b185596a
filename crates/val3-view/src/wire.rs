//! Messages between a run and its pages, and their JSON schema.
//!
//! The schema is `editors/schema/view-messages.schema.json`; the declarations of the page are generated from it.

mod cell;
mod commands;
mod motion;
mod page;
mod programs;
mod scene;
mod state;

pub use cell::{CellObject, CellPart, ObjectCarrier, ObjectShape, PartPlace, PartsMessage};
pub use commands::{
    Arguments, ArmSolution, Command, CommandError, Cycle, ElementKey, Fastest, FrameName, Operate, Pace, PaceSpeed,
    PageChoice, PointName, Reach, Reached, RecordScenario, Recorded, Save, Saved, SetPoint, Solve, Solved, StartAgain,
    TaughtTool, Teach, TeachFrame, TeachTool, ToolName, UnreachableValue, UserPage,
};
pub use motion::{BlendDistance, BlendEnds, MotionMessage, QueueEntry, WayPiece};
pub use page::{HtmlClick, HtmlPage, HtmlValue, ModeRun, PageMessage};
pub use programs::{CodeClass, CodePart, ProgramCode, ProgramsMessage};
pub use scene::{
    ArmChain, Axis, Capsule, CellPoint, JointValue, LengthUnit, LineInfo, Link, LinkShape, Pose, Role, Scene,
    SignalInfo,
};
pub use state::{CallingLine, SignalState, StateMessage, TaskState};

use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde::Serialize;
use serde_json::{Map, Value};
use val3_machine::event::{EndReason, Event};

/// Message of a run to its pages. Times `t` are in seconds on the controller's clock.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "camelCase")]
pub enum Message {
    /// The constant content of a run; always the first message.
    Scene(Box<Scene>),
    /// Code of loaded programs.
    Programs(ProgramsMessage),
    /// A line that requests moves.
    Source(Source),
    /// A tool.
    Tool(Tool),
    /// The pace of the run.
    Clock(Clock),
    /// The state of tasks and robot.
    State(StateMessage),
    /// The recorded moves and the remaining path.
    Motion(MotionMessage),
    /// Changed signals.
    Io(IoMessage),
    /// The user page.
    Page(PageMessage),
    /// Events of the run.
    Events(EventsMessage),
    /// Places of the parts, when one has another carrier or was placed elsewhere.
    Parts(PartsMessage),
    /// Points, joint positions, frames and tools with other values.
    Data(DataMessage),
    /// Points and joint positions that the last move's tool cannot reach.
    Reach(ReachMessage),
    /// Points, joint positions, frames and tools with unsaved changes.
    Unsaved(UnsavedMessage),
    /// The run has ended.
    End(End),
    /// A debugger has gone back: the page discards all later messages.
    Rewind(Rewind),
    /// Part of the run whose messages are not sent yet.
    Past(Past),
    /// Response to a command.
    Answer(Answer),
    /// Batch of arm samples, for pages whose connection has no binary messages.
    Samples(Samples),
    /// Selects the data that is selected in an editor.
    Select(Select),
}

/// Line that requests moves.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Source {
    /// Number of the line in samples and queue entries.
    pub index: u16,
    /// Name of the instruction.
    pub instruction: String,
    /// Program name.
    pub program: String,
    /// Line in the file, from 1.
    pub line: u32,
    /// Path of the program's file.
    pub file: String,
}

/// Tool, from flange to tool centre point.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Tool {
    /// Number of the tool in samples.
    pub index: u8,
    /// Name of the data with this value, if any.
    pub name: Option<String>,
    /// Pose of the tool centre point relative to the flange.
    pub pose: Pose,
}

/// Pace of a run.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Clock {
    /// Time in s.
    pub t: f64,
    /// Controller seconds per real second.
    pub speed: PaceSpeed,
    /// Whether the run is paused.
    pub is_paused: bool,
    /// Whether a debugger has stopped the run.
    pub is_stopped: bool,
}

/// Changed signals.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct IoMessage {
    /// Time in s.
    pub t: f64,
    /// Signals with another state.
    pub changes: Vec<SignalState>,
}

/// Events of the run.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct EventsMessage {
    /// Events in their order.
    #[schemars(with = "Vec<RunEvent>")]
    pub events: Vec<PageEvent>,
}

/// Event with its line of code.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct PageEvent {
    /// The event.
    #[serde(flatten)]
    pub event: Event,
    /// Code of the line, for the event of a fault.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line_code: Option<String>,
}

/// Event in the format of `val3 run --events`. A fault also has `lineCode`, its line of code.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct RunEvent {
    /// Time in s.
    pub t: f64,
    /// Task in whose turn it has happened.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub task: Option<String>,
    /// Kind of the event.
    pub kind: String,
    /// Data of the kind.
    #[serde(flatten)]
    pub data: Map<String, Value>,
}

/// Points, joint positions, frames and tools with other values.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct DataMessage {
    /// Time in s.
    pub t: f64,
    /// Changed points.
    pub points: Vec<CellPoint>,
    /// Changed joint positions.
    pub joints: Vec<JointValue>,
    /// Changed frames.
    pub frames: Vec<CellPoint>,
    /// Changed tools.
    pub tools: Vec<CellPoint>,
}

impl DataMessage {
    /// Whether nothing has changed.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.points.is_empty() && self.joints.is_empty() && self.frames.is_empty() && self.tools.is_empty()
    }
}

/// Points and joint positions that the last move's tool cannot reach; before the first move, the flange counts.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ReachMessage {
    /// Time in s.
    pub t: f64,
    /// Number of the tool.
    pub tool: u8,
    /// Points and joint positions to which `movej` cannot move the arm.
    pub unreachable: Vec<UnreachableValue>,
}

/// Points, joint positions, frames and tools with unsaved changes.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, JsonSchema)]
pub struct UnsavedMessage {
    /// Names of the data.
    pub points: Vec<PointName>,
    /// Data that `undo` restores; `null` if nothing was changed.
    pub undo: Option<PointName>,
}

/// End of the run.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct End {
    /// Time in s.
    pub t: f64,
    /// Reason in a word.
    #[schemars(with = "String")]
    pub reason: EndReason,
    /// Exit code of the command.
    pub exit_code: u8,
}

/// Time to which a debugger has gone back.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Rewind {
    /// Time in s.
    pub t: f64,
}

/// Part of the run whose messages are not sent yet, for a reader that connects to a run in progress. They follow in
/// blocks, the latest first.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Past {
    /// Time in s from which messages will be sent: the start of the run, unless its first messages were dropped.
    pub from: f64,
    /// Time in s from which messages were sent. If it equals `from`, no block follows.
    pub to: f64,
}

/// Response to a command, with further keys of the command.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Answer {
    /// Number of the command; `null` if the command could not be read.
    #[schemars(with = "Option<u64>")]
    pub id: Value,
    /// Reason why the command was not executed.
    pub error: Option<String>,
    /// Further keys.
    #[serde(flatten)]
    pub more: Map<String, Value>,
}

/// Batch of arm samples.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Samples {
    /// The bytes of the batch in base64.
    pub base64: String,
}

/// Data that is selected in an editor.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Select {
    /// Data name.
    pub name: Option<String>,
}

/// Returns the schema of all messages, commands and responses. The schema of [`Message`] is its root.
#[must_use]
pub fn schema() -> Value {
    let mut messages = SchemaSettings::draft2020_12().for_serialize().into_generator();
    let root = messages.subschema_for::<Message>();
    messages.subschema_for::<Saved>();
    messages.subschema_for::<Recorded>();
    messages.subschema_for::<Solved>();
    messages.subschema_for::<TaughtTool>();
    messages.subschema_for::<Reached>();
    let mut commands = SchemaSettings::draft2020_12().for_deserialize().into_generator();
    commands.subschema_for::<Command>();
    let mut definitions = messages.take_definitions(true);
    definitions.extend(commands.take_definitions(true));
    let mut schema = root.to_value();
    if let Some(keys) = schema.as_object_mut() {
        keys.insert("$schema".to_owned(), "https://json-schema.org/draft/2020-12/schema".into());
        keys.insert("$defs".to_owned(), Value::Object(definitions));
    }
    schema
}

#[cfg(test)]
mod tests;
