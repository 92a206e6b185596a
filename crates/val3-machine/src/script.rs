//! Script of external events during a run: `val3 run --script`.
//!
//! A script is a TOML file. Each `[[at]]` contains an event and its time `t`, in seconds since the start:
//!
//! ```toml
//! [[at]]
//! t = 1.5
//! io = { "BasicIO-1\\%I0" = true, "Scale\\weight" = 3.2 }
//! key = 270                # or a name: "Return", "F1"
//! keys = "12.5"            # typed as the program requests them
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
//! move = true              # recorded moves may move the arm, in any mode; false holds it
//! joints = [0, 0, 90, 0, 90, 0]  # position of the arm from now on; its moves are discarded
//! jog = [10, 0, 90, 0, 90, 0]    # the operator moves the arm there by hand, while no move does
//! place = { "carton[0]" = [150, 200, -40] }  # a part of the cell is there from now on
//! remove = ["carton[1]"]   # a part of the cell is gone
//! force = [0, 0, -50]            # in N along the axes of world, or one number along the path of the move
//! connect = true                 # the operator requests the return of the arm to its path
//! stop = true
//! receive = { "Socket\\host" = "START\r" }  # received by a line, whose other end is then the script; or bytes
//! ```
//!
//! With `silent = ["Socket\\host"]` at the top, the script is the other end of a line over which it sends nothing.
//!
//! Each `[[when]]` is a reaction. It occurs each time that its condition becomes true, and at the start if the
//! condition is true from the beginning:
//!
//! ```toml
//! [[when]]
//! io = { "BasicIO-1\\%Q0" = true, "Scale\\weight" = { above = 3, below = 4.5 } }  # signals at their terminals
//! data = { nState = 3, "part:bReady" = true }                                   # global data
//! seen = "part at stop"    # a sensor of the cell detects something
//! held = "carton[0]"       # a gripper of the cell holds the part
//! sent = { "Socket\\host" = "GET" }                     # a task sends a text that contains it
//! times = 1                # only the first time
//! then = [
//!   { io = { "BasicIO-1\\%I1" = true } },     # the keys of [[at]], immediately
//!   { after = 0.5, key = "F1" },              # or some seconds later
//! ]
//! ```

mod apply;
mod bytes;
mod check;
mod comparison;
mod condition;
mod data_path;
mod entry;
mod keys;
mod part_values;
mod parts;
mod reaction;
mod sent;
mod values;

use std::collections::VecDeque;
use std::fmt;
use std::sync::Arc;

use serde::Deserialize;
use toml::Spanned;
use val3_lang::ports::{Time, nanoseconds};

pub use bytes::LineBytes;
pub use check::{Misfit, ScriptFault};
pub use comparison::{ComparedRange, Comparison, LevelComparison};
pub use condition::{Condition, ConditionTable, Mismatch, NamedStates};
use entry::Pending;
pub(crate) use entry::ScriptEntry;
pub use entry::{ScriptAction, ScriptPlace, TimedEntry};
pub use keys::{key_codes, typed_keys};
pub use part_values::PoseNumbers;
use reaction::Reaction;
pub use reaction::ReactionRule;
pub use sent::SentText;
pub use values::{ScriptValue, Seconds, SignalValue};

/// Timed events, and the reactions of the cell.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Script {
    /// Sorted by time.
    pending: VecDeque<Pending>,
    reactions: Vec<Reaction>,
    /// Lines whose other end is the script, also if it sends nothing.
    silent: Vec<String>,
    /// Whether the conditions of the reactions were evaluated before.
    has_begun: bool,
    /// Problems of entries that had no effect.
    problems: Vec<String>,
}

/// Content of a script file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ScriptContent {
    #[serde(default)]
    at: Vec<TimedEntry>,
    #[serde(default)]
    when: Vec<Spanned<ReactionRule>>,
    #[serde(default)]
    silent: Vec<String>,
}

/// Error in a script: location in the file, its text, and the possible texts.
#[derive(Debug, Clone, PartialEq)]
pub struct ScriptError(toml::de::Error);

impl fmt::Display for ScriptError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0.to_string().trim_end())
    }
}

impl std::error::Error for ScriptError {}

impl Script {
    /// Creates a script from the tables of a file with this text. Entries with the same time keep their order. The
    /// script is the other end of the `silent` lines, even if it never sends anything.
    #[must_use]
    pub fn new(mut at: Vec<TimedEntry>, when: Vec<Spanned<ReactionRule>>, silent: Vec<String>, text: &str) -> Self {
        at.sort_by_key(|TimedEntry { t, .. }| t.time());
        let pending = at.into_iter().map(|TimedEntry { t, entry }| Pending {
            time: t.time(),
            place: ScriptPlace::At(t.seconds()),
            entry: Arc::new(entry),
        });
        let line = |offset| text.get(..offset).unwrap_or(text).matches('\n').count() + 1;
        let reactions = when.into_iter().map(|rule| Reaction::new(line(rule.span().start), rule.into_inner()));
        let (pending, reactions) = (pending.collect(), reactions.collect());
        Self { pending, reactions, silent, has_begun: false, problems: Vec::new() }
    }

    /// Creates a script from actions with their times in seconds. Actions with the same time keep their order. The script
    /// is the other end of the `silent` lines, even if it never sends anything.
    #[must_use]
    pub fn of_actions(actions: Vec<(f64, ScriptAction)>, silent: Vec<String>) -> Self {
        let mut pending: Vec<Pending> = actions
            .into_iter()
            .map(|(t, ScriptAction(entry))| Pending {
                time: nanoseconds(t),
                place: ScriptPlace::At(t),
                entry: Arc::new(entry),
            })
            .collect();
        pending.sort_by_key(|pending| pending.time);
        Self { pending: pending.into(), silent, ..Self::default() }
    }

    /// Parses a script. Entries with the same time occur in file order.
    ///
    /// # Errors
    /// The text is no TOML, or contains keys or values that a script does not support.
    pub fn parse(text: &str) -> Result<Self, ScriptError> {
        let ScriptContent { at, when, silent } = toml::from_str(text).map_err(ScriptError)?;
        Ok(Self::new(at, when, silent, text))
    }

    /// The links of the serial lines and sockets that the script sends to or waits for.
    pub(crate) fn lines(&self) -> impl Iterator<Item = &str> {
        let reactions = self.reactions.iter().flat_map(Reaction::entries);
        let entries = self.pending.iter().map(|pending| pending.entry.as_ref()).chain(reactions);
        let sent = self.reactions.iter().filter_map(|reaction| reaction.sent().map(SentText::link));
        let received = entries.flat_map(|entry| entry.receive.keys());
        received.chain(&self.silent).map(String::as_str).chain(sent)
    }

    /// Time of the next event, without reactions whose condition is not true yet.
    #[must_use]
    pub fn next_due(&self) -> Option<Time> {
        self.pending.front().map(|pending| pending.time)
    }

    /// The next entry whose time has come.
    fn take_due(&mut self, now: Time) -> Option<Pending> {
        self.pending.pop_front_if(|pending| pending.time <= now)
    }

    /// The reactions, in the order of the file.
    fn reactions(&self) -> impl Iterator<Item = &Reaction> {
        self.reactions.iter()
    }

    /// Receives the current values of the conditions, and schedules the entries of the reactions that occur.
    fn react(&mut self, holding: &[bool], now: Time) {
        self.has_begun = true;
        let mut due = Vec::new();
        for (reaction, holds) in self.reactions.iter_mut().zip(holding) {
            if reaction.happens(*holds) {
                due.extend(reaction.pending(now));
            }
        }
        due.into_iter().for_each(|pending| self.schedule(pending));
    }

    /// Adds an entry after all entries with the same time.
    fn schedule(&mut self, pending: Pending) {
        let at = self.pending.partition_point(|other| other.time <= pending.time);
        self.pending.insert(at, pending);
    }
}

#[cfg(test)]
mod tests;
