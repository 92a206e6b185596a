//! Entries of a script: the events at one time.

use std::collections::BTreeMap;
use std::fmt;
use std::sync::Arc;

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value as Json};
use val3_lang::ports::Time;

use super::bytes::LineBytes;
use super::part_values::{Names, PartPose};
use super::values::{
    FaultEntry, Force, JointPosition, Keys, Locks, Mode, PendantKey, Percent, SafetyFault, ScriptValue, Seconds,
    SignalPaths, SignalValue,
};

/// An entry that will be applied.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Pending {
    pub(super) time: Time,
    pub(super) place: ScriptPlace,
    pub(super) entry: Arc<ScriptEntry>,
}

/// A table of a script.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ScriptPlace {
    /// The `[[at]]` with this time in seconds.
    At(f64),
    /// The `[[when]]` that begins in this line of the file, from 1.
    When(usize),
    /// Lines over which the script sends no bytes.
    Silent,
}

impl fmt::Display for ScriptPlace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::At(seconds) => write!(f, "t = {seconds}"),
            Self::When(line) => write!(f, "[[when]] in line {line}"),
            Self::Silent => f.write_str("silent"),
        }
    }
}

/// An `[[at]]`.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(try_from = "ScriptEntry")]
pub struct TimedEntry {
    pub(super) t: Seconds,
    pub(super) entry: ScriptEntry,
}

impl TryFrom<ScriptEntry> for TimedEntry {
    type Error = &'static str;

    fn try_from(entry: ScriptEntry) -> Result<Self, Self::Error> {
        match (entry.t, entry.after) {
            (Some(t), None) => Ok(Self { t, entry }),
            (None, None) => Err("`[[at]]` has no time: write `t`, in seconds since the start"),
            (_, Some(_)) => Err("`after` is for the `then` of a reaction: write `t`, in seconds since the start"),
        }
    }
}

/// The events at one time.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ScriptEntry {
    /// Time in an `[[at]]`.
    #[serde(skip_serializing)]
    pub(super) t: Option<Seconds>,
    /// The delay in a `then`.
    #[serde(skip_serializing)]
    pub(super) after: Option<Seconds>,
    /// Inputs and outputs that receive a value from the hardware.
    #[serde(default)]
    pub(super) io: BTreeMap<String, SignalValue>,
    /// Inputs and outputs that the operator locks.
    #[serde(default)]
    pub(super) lock: Locks,
    /// Inputs and outputs that the operator unlocks.
    #[serde(default)]
    pub(super) unlock: SignalPaths,
    /// Inputs and outputs that the controller simulates, or no longer.
    #[serde(default)]
    pub(super) simulate: BTreeMap<String, bool>,
    /// Outputs to reserve for the system or to free.
    #[serde(default)]
    pub(super) protect: BTreeMap<String, bool>,
    /// An input, output or device that fails, or works again.
    pub(super) fault: Option<FaultEntry>,
    /// Global data of the application and its libraries.
    #[serde(default)]
    pub(super) set: BTreeMap<String, ScriptValue>,
    pub(super) power: Option<bool>,
    pub(super) estop: Option<bool>,
    pub(super) safety_fault: Option<SafetyFault>,
    pub(super) calibrated: Option<bool>,
    pub(super) mode: Option<Mode>,
    pub(super) monitor_speed: Option<Percent>,
    /// Whether the operator allows recorded moves.
    #[serde(rename = "move")]
    pub(super) lets_move: Option<bool>,
    /// Joint position that the arm gets immediately; its recorded moves are discarded.
    pub(super) joints: Option<JointPosition>,
    /// A joint position to which the operator moves the arm by hand.
    pub(super) jog: Option<JointPosition>,
    /// Parts that are somewhere else from now on.
    #[serde(default)]
    pub(super) place: BTreeMap<String, PartPose>,
    /// Parts that are removed.
    #[serde(default)]
    pub(super) remove: Names,
    /// Force on the arm, until the next force.
    pub(super) force: Option<Force>,
    /// Whether the operator requests the return of the arm to its path.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub(super) connect: bool,
    /// Element of the displayed HTML page on which the operator clicks.
    pub(super) click: Option<String>,
    /// Key that is tapped immediately.
    pub(super) key: Option<PendantKey>,
    /// Keys that are tapped as the program requests them.
    pub(super) keys: Option<Keys>,
    /// Whether the operator stops the application.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub(super) stop: bool,
    /// Texts and other bytes that serial lines and sockets receive.
    #[serde(default)]
    pub(super) receive: BTreeMap<String, LineBytes>,
}

/// Immediate action of the cell or the operator, with the keys of `[[at]]` except `t`.
#[derive(Debug, Clone, PartialEq)]
pub struct ScriptAction(pub(crate) ScriptEntry);

impl ScriptEntry {
    /// Returns the keys with their values, without the time.
    pub(super) fn keys(&self) -> Map<String, Json> {
        match serde_json::to_value(self) {
            Ok(Json::Object(keys)) => keys.into_iter().filter(|(_, value)| !is_empty(value)).collect(),
            // A structure with keys that are texts is an object.
            _ => Map::new(),
        }
    }
}

impl ScriptAction {
    /// Action of typing these keys as the program requests them.
    #[must_use]
    pub fn typing(codes: Vec<u16>) -> Self {
        Self(ScriptEntry { keys: Some(Keys(codes)), ..ScriptEntry::default() })
    }

    /// Action of setting global variables.
    #[must_use]
    pub fn setting(set: BTreeMap<String, ScriptValue>) -> Self {
        Self(ScriptEntry { set, ..ScriptEntry::default() })
    }

    /// Parses an action.
    ///
    /// # Errors
    /// A key is unknown, or its value is invalid.
    pub fn from_json(keys: Map<String, Json>) -> serde_json::Result<Self> {
        let entry: ScriptEntry = serde_json::from_value(Json::Object(keys))?;
        match (entry.t, entry.after) {
            (None, None) => Ok(Self(entry)),
            _ => Err(serde::de::Error::custom("an action happens at once: it has neither `t` nor `after`")),
        }
    }
}

/// Whether a key has no value.
fn is_empty(value: &Json) -> bool {
    match value {
        Json::Null => true,
        Json::Array(items) => items.is_empty(),
        Json::Object(items) => items.is_empty(),
        _ => false,
    }
}
