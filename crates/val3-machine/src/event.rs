//! The events of a run, in order: its record.
//!
//! An event is one JSON object a line in the record. docs/events.md describes the stable format.

use crate::run_status::RunStatus;
use serde::{Deserialize, Serialize};
use val3_lang::ports::{CodePlace, SECOND, Time};

use crate::blend_ends::BlendEnds;
use crate::sio::RecordedReply;

/// Event of a run.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Event {
    /// Seconds since the controller was started.
    pub t: f64,
    /// Task in whose turn the event occurred; `None` for external events.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub task: Option<String>,
    /// Line of the task that caused the event.
    #[serde(skip)]
    pub at: Option<CodePlace>,
    /// Kind of the event, with its data.
    #[serde(flatten)]
    pub kind: EventKind,
}

/// Kind of the event, with its data.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum EventKind {
    /// `?` has printed a line.
    Print {
        /// The line.
        text: String,
    },
    /// Text was written on a user page.
    Put {
        /// The screen variable; empty for the default page.
        screen: String,
        /// Column of the first character, from 0.
        x: u8,
        /// Line of the first character, from 0.
        y: u8,
        /// The text.
        text: String,
        /// Whether the cursor moved to the next line after it.
        #[serde(skip)]
        ends_line: bool,
    },
    /// The title of a user page has changed.
    Title {
        /// The screen variable; empty for the default page.
        screen: String,
        /// The title.
        text: String,
    },
    /// A user page was emptied.
    Cls {
        /// The screen variable; empty for the default page.
        screen: String,
    },
    /// A message is shown.
    Popup {
        /// The message.
        text: String,
    },
    /// An element's property on an HTML page has changed (s8).
    Html {
        /// The page.
        page: String,
        /// The element.
        id: String,
        /// The property, such as `innerHTML`.
        attribute: String,
        /// The value as text.
        value: String,
    },
    /// Note of the run itself, which no controller would report.
    Notice {
        /// A sentence.
        text: String,
    },
    /// The event log has a new line.
    Log {
        /// `info`, `warning` or `error`.
        level: &'static str,
        /// The line.
        text: String,
    },
    /// A task was created, has ended, or has changed its state.
    Task {
        /// `created`, `ended`, `suspended`, `resumed`, `killed` or `error`.
        state: &'static str,
        /// Name of the task.
        name: String,
        /// The program that the named task is in.
        program: String,
        /// Line in the file at which the named task is, from 1.
        line: u32,
        /// The number of the run-time error.
        #[serde(skip_serializing_if = "Option::is_none")]
        code: Option<u16>,
        /// The file of the program.
        #[serde(skip)]
        file: String,
    },
    /// A run-time error has stopped a task.
    Error {
        /// Number of the error.
        code: u16,
        /// Meaning of the error.
        message: &'static str,
        /// Reason why a move was rejected.
        #[serde(skip_serializing_if = "Option::is_none")]
        reason: Option<String>,
        /// Explanation and remedy.
        help: &'static str,
        /// The program.
        program: String,
        /// The line of the file, from 1.
        line: u32,
        /// The file.
        file: String,
        /// Whether the error concerns a serial line or socket that the cell does not configure.
        #[serde(skip)]
        is_line_missing: bool,
    },
    /// A task has reached an instruction that this controller does not support.
    Lacking {
        /// The instruction.
        instruction: String,
        /// The program.
        program: String,
        /// The line of the file, from 1.
        line: u32,
        /// The file.
        file: String,
    },
    /// An input or output has changed its value.
    Io {
        /// Path of the signal.
        link: String,
        /// Value; 0 or 1 for a digital signal.
        value: f64,
    },
    /// Bytes went over a serial line or socket.
    Sio {
        /// Path of the serial line or socket.
        link: String,
        /// `in` or `out`.
        dir: &'static str,
        /// The bytes.
        bytes: Vec<u8>,
    },
    /// A serial line or socket has returned an unusual result, which a replay requires.
    Line {
        /// Path of the serial line or socket.
        link: String,
        /// Call number and result.
        #[serde(flatten)]
        entry: RecordedReply,
    },
    /// The time source has changed: the wall clock applies while a serial line or socket has a peer.
    Clock {
        /// Whether the wall clock sets the time, also in virtual time.
        wall: bool,
    },
    /// A library was loaded, saved or deleted.
    Lib {
        /// `load`, `save` or `delete`.
        op: &'static str,
        /// The library identifier; empty for the application itself.
        alias: String,
        /// Path as the program passed it.
        path: String,
        /// The code of the instruction.
        code: u16,
    },
    /// The power of the arm was switched on or off.
    Power {
        /// Whether the arm has power.
        on: bool,
    },
    /// Event of a recorded move or of the entire motion.
    Move {
        /// Id of the move; for the entire motion, id of the current move.
        id: f64,
        /// `recorded`, `started`, `blend`, `reached`, `done`, `dropped`; `stopped`, `restarted`, `reset`, `error`.
        phase: &'static str,
        /// The instruction.
        #[serde(rename = "type")]
        instruction: &'static str,
        /// The program of the instruction; empty for a client.
        program: String,
        /// The line of the file, from 1; 0 for a client.
        line: u32,
        /// Blend distances in the phases `recorded` and `blend`, and in `done` after a cancelled blend.
        #[serde(flatten)]
        blend: BlendEnds,
        /// Position in `world`, in mm, at which the tool centre point would arrive; in the phase `error` of a move only.
        #[serde(skip_serializing_if = "Option::is_none")]
        target: Option<[f64; 3]>,
    },
    /// The arm has come to rest before a path that it cannot follow, or the application has ended before the arm has
    /// reached this path.
    Fault {
        /// The id of the move whose path is impossible.
        id: f64,
        /// The instruction of the move.
        #[serde(rename = "type")]
        instruction: &'static str,
        /// The reason.
        text: String,
        /// The program of the instruction.
        program: String,
        /// The line of the file, from 1.
        line: u32,
        /// The file.
        file: String,
    },
    /// Two things have come too near to each other, touch, or are apart again.
    Clearance {
        /// `near`, `contact` or `clear`.
        state: &'static str,
        /// One of the things.
        a: String,
        /// The other one.
        b: String,
        /// Distance in mm; with `clear`, the smallest since `near`. A negative number is the depth of an overlap.
        distance: f64,
        /// A nearest point of each thing, in mm in world.
        points: [[f64; 3]; 2],
        /// Time of this distance, in seconds.
        at: f64,
        /// Joint position at this time, in degrees or mm.
        joints: Vec<f64>,
        /// Whether they were so near when the run began.
        #[serde(skip_serializing_if = "std::ops::Not::not")]
        start: bool,
        /// The move that the arm executes.
        #[serde(flatten, skip_serializing_if = "Option::is_none")]
        of: Option<ClearanceMove>,
    },
    /// A gripper has closed.
    Grip {
        /// The gripper.
        gripper: String,
        /// The part that it holds; `None` if no part is near enough.
        part: Option<String>,
        /// The nearest part that no gripper held.
        #[serde(skip_serializing_if = "Option::is_none")]
        nearest: Option<String>,
        /// Distance in mm of this part from the point of the gripper.
        #[serde(skip_serializing_if = "Option::is_none")]
        distance: Option<f64>,
        /// Greatest distance in mm of a part that it grips.
        within: f64,
    },
    /// A gripper has released a part.
    Release {
        /// The gripper.
        gripper: String,
        /// The part.
        part: String,
        /// Height in mm above everything else below it, if the part hangs in the air.
        #[serde(skip_serializing_if = "Option::is_none")]
        above: Option<f64>,
    },
    /// A script has placed or removed a part.
    Part {
        /// The part.
        part: String,
        /// `placed` or `removed`.
        state: &'static str,
    },
    /// A sensor detects something, or nothing any more.
    Sensor {
        /// The sensor.
        sensor: String,
        /// Whether it detects something.
        on: bool,
        /// What it detects.
        #[serde(skip_serializing_if = "Option::is_none")]
        detects: Option<String>,
    },
    /// Action of the cell or the operator.
    Act {
        /// Action, with the keys of a script as far as a script has such keys.
        keys: serde_json::Map<String, serde_json::Value>,
    },
    /// The working mode has changed.
    Mode {
        /// Number that `workingMode` returns.
        mode: u8,
    },
    /// The run cannot continue: location of a task.
    Stuck {
        /// The task.
        name: String,
        /// `waiting`, `suspended` or `error`.
        state: &'static str,
        /// The thing that the task waits for.
        #[serde(skip_serializing_if = "Option::is_none")]
        awaits: Option<String>,
        /// The program.
        program: String,
        /// The line of the file, from 1.
        line: u32,
        /// The file.
        file: String,
    },
    /// The run has ended.
    End {
        /// Reason.
        reason: EndReason,
    },
}

impl EventKind {
    /// Describes a gripper that has missed its part, or a part that was released in the air; `None` for other events.
    #[must_use]
    pub fn handling_problem(&self) -> Option<String> {
        match self {
            Self::Grip { gripper, part: None, nearest, distance, within } => {
                let nearest = nearest.as_ref().zip(*distance).map(|(name, distance)| {
                    let shown = (distance * 10.0).ceil() / 10.0;
                    format!("; `{name}` is {shown:.1} mm away")
                });
                Some(format!("`{gripper}` grips nothing: no part within {within} mm{}", nearest.unwrap_or_default()))
            }
            Self::Release { gripper, part, above: Some(height) } => {
                Some(format!("`{gripper}` releases `{part}` {height:.0} mm above everything below it"))
            }
            _ => None,
        }
    }
}

/// The move during which two things are near each other.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ClearanceMove {
    /// Id of the move.
    pub id: f64,
    /// The instruction.
    #[serde(rename = "type")]
    pub instruction: &'static str,
    /// The program of the instruction; empty for a client.
    pub program: String,
    /// The line of the file, from 1; 0 for a client.
    pub line: u32,
    /// The file.
    #[serde(skip)]
    pub file: String,
}

/// End reason in a run's record: the serialised form of a [`RunStatus`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum EndReason {
    /// The application has ended without a stop from outside.
    Finished,
    /// The application was stopped from outside.
    Stopped,
    /// The run has reached its time limit.
    Limit,
    /// No task could continue, or the controller does not support an instruction.
    Error,
    /// The application has faults and was not started.
    Refused,
}

impl From<RunStatus> for EndReason {
    fn from(status: RunStatus) -> Self {
        match status {
            RunStatus::Finished => Self::Finished,
            RunStatus::Limit => Self::Limit,
            RunStatus::Stopped | RunStatus::Suspended | RunStatus::AtStop(_) | RunStatus::Seen(_) => Self::Stopped,
            RunStatus::Stuck | RunStatus::Unsupported => Self::Error,
            // The caller has ended a run that could continue.
            RunStatus::Busy | RunStatus::Waiting(_) => Self::Stopped,
        }
    }
}

/// Converts a time to seconds for messages, rounded to a millisecond: lines take microseconds, which mean nothing in a
/// message.
#[must_use]
pub fn shown_seconds(time: Time) -> f64 {
    const MILLISECOND: Time = SECOND / 1000;
    seconds((time + MILLISECOND / 2) / MILLISECOND * MILLISECOND)
}

/// Converts a time to seconds.
#[must_use]
pub fn seconds(time: Time) -> f64 {
    #[allow(clippy::cast_precision_loss, reason = "exact to a nanosecond for a hundred days")]
    let seconds = time as f64 / SECOND as f64;
    seconds
}
