//! Values in the entries of a script. Each error lists the possible values.

use std::collections::BTreeMap;
use std::fmt;

use serde::{Deserialize, Serialize, Serializer};
use val3_lang::ports::{Time, nanoseconds};

use super::keys::{key_codes, key_text, typed_keys};
use crate::controller_state::WorkingMode;

/// Number, with a separate message for other values.
#[derive(Deserialize)]
#[serde(untagged, expecting = "write a number")]
enum Amount {
    Number(f64),
}

/// A time since the start.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, Serialize)]
#[serde(try_from = "Amount")]
pub struct Seconds(f64);

impl TryFrom<Amount> for Seconds {
    type Error = String;

    fn try_from(Amount::Number(seconds): Amount) -> Result<Self, String> {
        let suits = (0.0..=1e9).contains(&seconds);
        suits.then_some(Self(seconds)).ok_or_else(|| format!("{seconds} is not a time: write seconds, 0 or more"))
    }
}

impl Seconds {
    /// The time in seconds.
    #[must_use]
    pub fn seconds(self) -> f64 {
        self.0
    }

    /// The time in nanoseconds.
    #[must_use]
    pub fn time(self) -> Time {
        nanoseconds(self.0)
    }
}

/// Value for an input or output.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, Serialize)]
#[serde(untagged, expecting = "an input or output is true, false or a number")]
pub enum SignalValue {
    /// Value for a digital signal.
    Digital(bool),
    /// Value for an analog signal.
    Analog(f64),
}

impl SignalValue {
    pub(super) fn number(self) -> f64 {
        match self {
            Self::Digital(value) => f64::from(u8::from(value)),
            Self::Analog(value) => value,
        }
    }
}

/// A fault of the safety circuit.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(untagged, expecting = "write the name of a signal, or false to end the fault")]
pub(super) enum SafetyFault {
    Signal(String),
    Present(bool),
}

impl SafetyFault {
    /// The name of the signal, `None` without a fault.
    pub(super) fn signal(&self) -> Option<String> {
        match self {
            Self::Signal(name) => Some(name.clone()),
            Self::Present(present) => present.then(String::new),
        }
    }
}

/// Value for a variable or signal.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(untagged, expecting = "a variable is set to true, false, a number or a text")]
pub enum ScriptValue {
    /// A `bool`, or a digital signal's value.
    Bool(bool),
    /// A `num`, or an analog signal's value.
    Num(f64),
    /// A `string`.
    Text(String),
}

impl From<&str> for ScriptValue {
    /// Converts a value on a command line: `true`, `2.5`, `bolt`. A text in quotes is a text in any case: `"2.5"`.
    fn from(text: &str) -> Self {
        let quoted = text.strip_prefix('"').and_then(|text| text.strip_suffix('"'));
        match (quoted, text.parse(), text.parse::<f64>()) {
            (Some(quoted), ..) => Self::Text(quoted.to_owned()),
            (None, Ok(truth), _) => Self::Bool(truth),
            (None, _, Ok(number)) if number.is_finite() => Self::Num(number),
            _ => Self::Text(text.to_owned()),
        }
    }
}

impl fmt::Display for ScriptValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Bool(value) => value.fmt(f),
            Self::Num(value) => value.fmt(f),
            Self::Text(text) => write!(f, "\"{text}\""),
        }
    }
}

/// Maximum number of occurrences.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(try_from = "Amount")]
pub(super) struct OccurrenceLimit(u64);

impl TryFrom<Amount> for OccurrenceLimit {
    type Error = String;

    fn try_from(Amount::Number(times): Amount) -> Result<Self, String> {
        let suits = (1.0..=1e9).contains(&times) && times.fract() == 0.0;
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked")]
        let checked = suits.then_some(Self(times as u64));
        checked.ok_or_else(|| format!("{times} is no number of times: write a whole number from 1"))
    }
}

impl OccurrenceLimit {
    pub(super) fn number(self) -> u64 {
        self.0
    }
}

/// Inputs and outputs by their paths.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(untagged, expecting = "write the path of an input or output, or a list of such paths")]
pub(super) enum SignalPaths {
    One(String),
    Several(Vec<String>),
}

impl Default for SignalPaths {
    fn default() -> Self {
        Self::Several(Vec::new())
    }
}

impl SignalPaths {
    pub(super) fn all(&self) -> &[String] {
        match self {
            Self::One(link) => std::slice::from_ref(link),
            Self::Several(links) => links,
        }
    }
}

/// Inputs and outputs that are locked at the current value, or at a given value.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(
    untagged,
    expecting = "write the path of an input or output, a list of such paths, or a table of paths and values"
)]
pub(super) enum Locks {
    AsIs(SignalPaths),
    At(BTreeMap<String, SignalValue>),
}

impl Default for Locks {
    fn default() -> Self {
        Self::At(BTreeMap::new())
    }
}

/// An input, output or device that fails.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(super) struct FaultEntry {
    pub(super) link: String,
    pub(super) code: i32,
}

/// A percentage.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, Serialize)]
#[serde(try_from = "Amount")]
pub(super) struct Percent(pub(super) f64);

impl TryFrom<Amount> for Percent {
    type Error = String;

    fn try_from(Amount::Number(speed): Amount) -> Result<Self, String> {
        let suits = (0.0..=100.0).contains(&speed);
        suits.then_some(Self(speed)).ok_or_else(|| format!("the monitor speed is 0 to 100 %, not {speed}"))
    }
}

/// A force in N: three numbers along the axes of world, or one along the path of the move.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, Serialize)]
#[serde(untagged, expecting = "write a force in N along the path, or three along the axes of world")]
pub(super) enum Force {
    Path(f64),
    World([f64; 3]),
}

/// Joint position: one number for each axis; omitted numbers are 0.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, Serialize)]
#[serde(try_from = "Vec<f64>")]
pub(super) struct JointPosition(pub(super) [f64; 6]);

impl TryFrom<Vec<f64>> for JointPosition {
    type Error = String;

    fn try_from(axes: Vec<f64>) -> Result<Self, String> {
        let mut joint = [0.0; 6];
        if axes.is_empty() || axes.len() > joint.len() || axes.iter().any(|axis| !axis.is_finite()) {
            return Err("write a number for each axis of the arm, one to six".to_owned());
        }
        joint.iter_mut().zip(axes).for_each(|(axis, position)| *axis = position);
        Ok(Self(joint))
    }
}

/// A number or a name.
#[derive(Deserialize)]
#[serde(untagged, expecting = "write a number or a name")]
enum NumberOrName {
    Number(u16),
    Name(String),
}

/// A working mode.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(try_from = "NumberOrName")]
pub(super) struct Mode(pub(super) WorkingMode);

impl TryFrom<NumberOrName> for Mode {
    type Error = String;

    fn try_from(spelled: NumberOrName) -> Result<Self, String> {
        let mode = match &spelled {
            NumberOrName::Number(number) => u8::try_from(*number).ok().and_then(WorkingMode::from_number),
            NumberOrName::Name(name) => (0..=4).filter_map(WorkingMode::from_number).find(|mode| mode.name() == name),
        };
        mode.map(Self).ok_or_else(|| "no such mode: write manual (1), test (2), local (3) or remote (4)".to_owned())
    }
}

impl Serialize for Mode {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.0.name())
    }
}

/// A key.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
#[serde(try_from = "NumberOrName")]
pub(super) struct PendantKey(pub(super) u16);

impl TryFrom<NumberOrName> for PendantKey {
    type Error = String;

    fn try_from(spelled: NumberOrName) -> Result<Self, String> {
        let text = match spelled {
            NumberOrName::Number(code) => code.to_string(),
            NumberOrName::Name(name) => name,
        };
        match key_codes(&text)?.as_slice() {
            [code] => Ok(Self(*code)),
            _ => Err("`key` is one key; `keys` types several".to_owned()),
        }
    }
}

/// Keys that are typed.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(try_from = "String")]
pub(super) struct Keys(pub(super) Vec<u16>);

impl TryFrom<String> for Keys {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        typed_keys(&text).map(Self)
    }
}

impl Serialize for Keys {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&key_text(&self.0))
    }
}
