//! The events of a run, in order: its record.
//!
//! An event is one JSON object a line in the record. docs/events.md describes the stable format.

use serde::{Deserialize, Serialize};
use val3_lang::ports::{SECOND, Time};
use val3_vm::Outcome;

use crate::blend_ends::BlendEnds;
use crate::sio::Entry;

/// Something that has happened.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Event {
    /// Seconds since the controller was started.
    pub t: f64,
    /// The task in whose turn it has happened; none for what comes from outside.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub task: Option<String>,
    /// The kind of an event, with its data.
    #[serde(flatten)]
    pub kind: EventKind,
}

/// The kind of an event, with its data.
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
    },
    /// A user page has another title.
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
    /// A message has come up.
    Popup {
        /// The message.
        text: String,
    },
    /// A property of an element of a page made with HTML has another value (s8).
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
    /// The run says something about itself that no controller would.
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
        /// Its name.
        name: String,
        /// The program that the named task is in.
        program: String,
        /// The line of its file at which the named task is, from 1.
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
        /// Its number.
        code: u16,
        /// Its meaning.
        message: &'static str,
        /// The program.
        program: String,
        /// The line of the file, from 1.
        line: u32,
        /// The file.
        file: String,
        /// Whether it is about a serial line or socket that the cell does not configure.
        #[serde(skip)]
        is_line_missing: bool,
    },
    /// A task is at an instruction that this controller does not have.
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
    /// An input or output has another value.
    Io {
        /// Its path.
        link: String,
        /// Its value; 0 or 1 for a digital one.
        value: f64,
    },
    /// Bytes went over a serial line or socket.
    Sio {
        /// Its path.
        link: String,
        /// `in` or `out`.
        dir: &'static str,
        /// The bytes.
        bytes: Vec<u8>,
    },
    /// A serial line or socket has answered otherwise than usual: what a replay needs to know of it.
    Line {
        /// Its path.
        link: String,
        /// The answer.
        #[serde(flatten)]
        entry: Entry,
    },
    /// Whose time passes from here on: that of the wall while a serial line or socket has a peer.
    Clock {
        /// The clock on the wall decides, also in virtual time.
        wall: bool,
    },
    /// A library was loaded, saved or deleted.
    Lib {
        /// `load`, `save` or `delete`.
        op: &'static str,
        /// The library identifier; empty for the application itself.
        alias: String,
        /// The path as the program gave it.
        path: String,
        /// The code of the instruction.
        code: u16,
    },
    /// The arm was powered or is no longer.
    Power {
        /// It has power.
        on: bool,
    },
    /// Something has happened to a recorded move, or to the motion as a whole.
    Move {
        /// The id of the move; for the motion as a whole that of the present one.
        id: f64,
        /// `recorded`, `started`, `blend`, `reached`, `done`, `dropped`; `stopped`, `restarted`, `reset`, `error`.
        phase: &'static str,
        /// The instruction.
        #[serde(rename = "type")]
        instruction: &'static str,
        /// The program of the instruction.
        program: String,
        /// The line of the file, from 1.
        line: u32,
        /// Distances of its blend, of `recorded`, `blend`, and `done` of a cancelled blend.
        #[serde(flatten)]
        blend: BlendEnds,
    },
    /// The arm has come to rest before a path that it cannot follow, or the application has ended before the arm was
    /// there.
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
    /// The cell or the operator has done something.
    Act {
        /// What, with the keys of a script where there are such.
        keys: serde_json::Map<String, serde_json::Value>,
    },
    /// The working mode has changed.
    Mode {
        /// The number that `workingMode` gives.
        mode: u8,
    },
    /// The run cannot continue, and this is where one of its tasks is.
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
    /// The run is over.
    End {
        /// Why.
        reason: EndReason,
    },
}

/// Why a run is over, as the record of a run has it: the serialised form of an [`Outcome`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum EndReason {
    /// The application has ended without a stop from outside.
    Finished,
    /// It was stopped from outside.
    Stopped,
    /// The time of the run was up.
    Limit,
    /// No task could continue, or the controller lacks an instruction.
    Error,
    /// The application was not started because of its faults.
    Refused,
}

impl From<Outcome> for EndReason {
    fn from(outcome: Outcome) -> Self {
        match outcome {
            Outcome::Finished => Self::Finished,
            Outcome::Limit => Self::Limit,
            Outcome::Stopped | Outcome::Suspended | Outcome::AtStop(_) | Outcome::Seen(_) => Self::Stopped,
            Outcome::Refused => Self::Refused,
            Outcome::Stuck | Outcome::Lacking | Outcome::Failed(_) | Outcome::Halted => Self::Error,
            // The caller has ended a run that could continue.
            Outcome::Busy | Outcome::Waiting(_) | Outcome::Pausing(_) => Self::Stopped,
        }
    }
}

/// Seconds of a time as people read it, rounded to a millisecond: lines take microseconds, which mean nothing in a message.
#[must_use]
pub fn shown_seconds(time: Time) -> f64 {
    const MILLISECOND: Time = SECOND / 1000;
    seconds((time + MILLISECOND / 2) / MILLISECOND * MILLISECOND)
}

/// Seconds of a time.
#[must_use]
pub fn seconds(time: Time) -> f64 {
    #[allow(clippy::cast_precision_loss, reason = "exact to a nanosecond for a hundred days")]
    let seconds = time as f64 / SECOND as f64;
    seconds
}
