//! A script of events from outside during a run: `val3 run --script`.
//!
//! A script is a TOML file. Each `[[at]]` says with `t` when something happens, in seconds since the start, and what:
//!
//! ```toml
//! [[at]]
//! t = 1.5
//! io = { "BasicIO-1\\%I0" = true, "Scale\\weight" = 3.2 }
//! key = 270                # or a name: "Return", "F1"
//! keys = "12.5"            # typed as the program asks for them
//! set = { nCount = 4, "sNames[1]" = "bolt" }
//! lock = "BasicIO-1\\%I1"  # or several, or with the values at which they are held
//! unlock = ["BasicIO-1\\%I2"]
//! simulate = { "BasicIO-1\\%Q1" = true }
//! protect = { "BasicIO-1\\%Q2" = true }
//! fault = { link = "BasicIO-1\\%Q0", code = -3 }
//! power = true
//! estop = false
//! mode = "remote"          # or 4
//! safety_fault = "DOOR"   # the name of a signal, or false
//! calibrated = false
//! monitor_speed = 50
//! move = true              # the operator lets recorded moves move the arm, in any mode; false holds it
//! joints = [0, 0, 90, 0, 90, 0]  # where the arm stands from now on; its moves are forgotten
//! jog = [10, 0, 90, 0, 90, 0]    # the operator moves the arm there by hand, while no move does
//! force = [0, 0, -50]            # in N along the axes of world, or one number along the path of the move
//! connect = true                 # the operator lets the arm return to its path
//! stop = true
//! ```

mod apply;
mod check;
mod keys;
mod values;

use std::collections::{BTreeMap, VecDeque};
use std::fmt;

use serde::Deserialize;
use val3_lang::ports::Time;

pub use check::ScriptFault;
pub use keys::{key_codes, typed_keys};
pub use values::Seconds;
use values::{FaultEntry, Force, Key, Keys, Level, Links, Locks, Mode, Percent, Position, SafetyFault, Value};

/// The entries of a script, in the order of their times.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Script {
    entries: VecDeque<Entry>,
}

/// A script as a file has it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(default)]
    at: Vec<Entry>,
}

/// The events at one time: a table `[[at]]`.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Entry {
    t: Seconds,
    /// Inputs and outputs that get a value from the hardware.
    #[serde(default)]
    io: BTreeMap<String, Level>,
    /// Inputs and outputs that the operator holds.
    #[serde(default)]
    lock: Locks,
    /// Inputs and outputs that the operator lets go.
    #[serde(default)]
    unlock: Links,
    /// Inputs and outputs that the controller simulates, or no longer.
    #[serde(default)]
    simulate: BTreeMap<String, bool>,
    /// Outputs to reserve for the system or to free.
    #[serde(default)]
    protect: BTreeMap<String, bool>,
    /// An input, output or device that fails, or works again.
    fault: Option<FaultEntry>,
    /// Global data of the application and its libraries.
    #[serde(default)]
    set: BTreeMap<String, Value>,
    power: Option<bool>,
    estop: Option<bool>,
    safety_fault: Option<SafetyFault>,
    calibrated: Option<bool>,
    mode: Option<Mode>,
    monitor_speed: Option<Percent>,
    /// Whether the operator lets recorded moves move the arm.
    #[serde(rename = "move")]
    lets_move: Option<bool>,
    /// A joint position to which the arm is put at once; its recorded moves are forgotten.
    joints: Option<Position>,
    /// A joint position to which the operator moves the arm by hand.
    jog: Option<Position>,
    /// A force on the arm, until another one.
    force: Option<Force>,
    /// The operator lets the arm return to its path.
    #[serde(default)]
    connect: bool,
    /// A key that is tapped at once.
    key: Option<Key>,
    /// Keys that are tapped as the program asks for them.
    keys: Option<Keys>,
    /// The operator stops the application.
    #[serde(default)]
    stop: bool,
}

/// Something that the cell or the operator does at once. It has the keys of an `[[at]]` table, without `t`.
#[derive(Debug, Clone, PartialEq)]
pub struct Action(pub(crate) Entry);

impl Action {
    /// Reads an action.
    ///
    /// # Errors
    /// A key is unknown, or does not take its value.
    pub fn from_json(mut keys: serde_json::Map<String, serde_json::Value>) -> serde_json::Result<Self> {
        keys.insert("t".to_owned(), 0.into());
        serde_json::from_value(serde_json::Value::Object(keys)).map(Self)
    }
}

/// The reason why a script cannot be used: the place in the file, its text, and the possible texts.
#[derive(Debug, Clone, PartialEq)]
pub struct ScriptError(toml::de::Error);

impl fmt::Display for ScriptError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0.to_string().trim_end())
    }
}

impl std::error::Error for ScriptError {}

impl Script {
    /// The script with these entries. Those of one time keep their order.
    #[must_use]
    pub fn new(mut entries: Vec<Entry>) -> Self {
        entries.sort_by_key(|entry| entry.t.time());
        Self { entries: entries.into() }
    }

    /// Reads a script. Entries of one time happen in the order of the file.
    ///
    /// # Errors
    /// The text is no TOML, or says what no script can say.
    pub fn parse(text: &str) -> Result<Self, ScriptError> {
        Ok(Self::new(toml::from_str::<File>(text).map_err(ScriptError)?.at))
    }

    /// When something happens next.
    #[must_use]
    pub fn next_due(&self) -> Option<Time> {
        self.entries.front().map(|entry| entry.t.time())
    }

    /// The next entry whose time has come.
    fn take_due(&mut self, now: Time) -> Option<Entry> {
        self.entries.pop_front_if(|entry| entry.t.time() <= now)
    }
}

#[cfg(test)]
mod tests;
