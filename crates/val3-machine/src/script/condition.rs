//! Conditions over signals, global data, sensors and parts: reactions wait for them, and tests expect them.

mod evaluation;

use std::collections::BTreeMap;
use std::fmt;

use serde::Deserialize;

use super::comparison::{Comparison, LevelComparison};
use super::part_values::Names;
use super::values::ScriptValue;
pub use evaluation::Mismatch;

/// Signals, global data, sensors and parts with the values that all of them must have at the same time.
///
/// ```toml
/// io = { "BasicIO-1\\%Q0" = true, "Scale\\weight" = { above = 3, below = 4.5 } }
/// data = { nState = 3, "sNames[1]" = "bolt", "part:bReady" = true }
/// seen = "part at stop"                        # or several, or with values: { "part at stop" = false }
/// held = ["carton[0]"]
/// ```
///
/// [`Controller::condition_faults`](crate::controller::Controller::condition_faults) checks that the names exist,
/// [`Controller::meets`](crate::controller::Controller::meets) and
/// [`Controller::mismatches`](crate::controller::Controller::mismatches) compare the values.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(try_from = "ConditionTable")]
pub struct Condition {
    parts: Vec<ConditionPart>,
}

/// Content of a condition in a file.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct ConditionTable {
    /// Values of signals.
    pub io: BTreeMap<String, LevelComparison>,
    /// Values of global variables.
    pub data: BTreeMap<String, Comparison>,
    /// Sensors of the cell that detect something.
    pub seen: NamedStates,
    /// Parts of the cell that grippers hold.
    pub held: NamedStates,
}

/// Sensors or parts, and whether they are seen or held.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(from = "StateForm")]
pub struct NamedStates(BTreeMap<String, bool>);

#[derive(Deserialize)]
#[serde(untagged, expecting = "write a name in quotes, a list of names, or a table such as { \"carton[0]\" = false }")]
enum StateForm {
    Names(Names),
    Table(BTreeMap<String, bool>),
}

impl From<StateForm> for NamedStates {
    fn from(form: StateForm) -> Self {
        Self(match form {
            StateForm::Names(names) => names.all().iter().map(|name| (name.clone(), true)).collect(),
            StateForm::Table(states) => states,
        })
    }
}

impl NamedStates {
    /// Whether no name is given.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl TryFrom<ConditionTable> for Condition {
    type Error = String;

    fn try_from(ConditionTable { io, data, seen, held }: ConditionTable) -> Result<Self, String> {
        let signal = |(path, level): (_, LevelComparison)| (Subject::Signal(path), level.into());
        let is = |holds: bool| Comparison::Is(ScriptValue::Bool(holds));
        let parts = io.into_iter().map(signal);
        let parts = parts.chain(data.into_iter().map(|(name, comparison)| (Subject::Variable(name), comparison)));
        let parts = parts.chain(seen.0.into_iter().map(|(name, holds)| (Subject::Sensor(name), is(holds))));
        let parts = parts.chain(held.0.into_iter().map(|(name, holds)| (Subject::Part(name), is(holds))));
        let parts: Vec<ConditionPart> =
            parts.map(|(subject, comparison)| ConditionPart { subject, comparison }).collect();
        match parts.is_empty() {
            true => {
                Err("a condition needs a signal in `io`, a variable in `data`, a sensor in `seen`, or a part in `held`"
                    .to_owned())
            }
            false => Ok(Self { parts }),
        }
    }
}

/// Clause of a sentence: "`nState` is 3 and `nCount` is above 2".
impl fmt::Display for Condition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (ConditionPart { subject, comparison }, number) in self.parts.iter().zip(0..) {
            let and = if number == 0 { "" } else { " and " };
            let name = subject.name();
            match (subject.participle(), comparison) {
                (Some(word), Comparison::Is(ScriptValue::Bool(true))) => write!(f, "{and}`{name}` is {word}")?,
                (Some(word), _) => write!(f, "{and}`{name}` is not {word}")?,
                (None, _) => write!(f, "{and}`{name}` is {comparison}")?,
            }
        }
        Ok(())
    }
}

/// A signal or variable with the value that it must have.
#[derive(Debug, Clone, PartialEq)]
struct ConditionPart {
    subject: Subject,
    comparison: Comparison,
}

#[derive(Debug, Clone, PartialEq)]
enum Subject {
    /// The value at the terminal of the signal with this path.
    Signal(String),
    /// A global variable: `nCount`, `nCounts[2]`, `library:nCount`.
    Variable(String),
    /// A sensor of the cell.
    Sensor(String),
    /// A part of the cell.
    Part(String),
}

impl Subject {
    fn name(&self) -> &str {
        let (Self::Signal(name) | Self::Variable(name) | Self::Sensor(name) | Self::Part(name)) = self;
        name
    }

    /// Word for the state of a sensor or part.
    fn participle(&self) -> Option<&'static str> {
        match self {
            Self::Signal(_) | Self::Variable(_) => None,
            Self::Sensor(_) => Some("interrupted"),
            Self::Part(_) => Some("held"),
        }
    }
}

impl Condition {
    /// Creates the condition that these signals and global variables have these values.
    ///
    /// # Errors
    /// The condition names no signal or variable.
    pub fn new(io: BTreeMap<String, LevelComparison>, data: BTreeMap<String, Comparison>) -> Result<Self, String> {
        ConditionTable { io, data, ..ConditionTable::default() }.try_into()
    }

    /// Creates the condition that sensors detect something and grippers hold parts.
    ///
    /// # Errors
    /// The condition names no sensor or part.
    pub fn of_cell(seen: NamedStates, held: NamedStates) -> Result<Self, String> {
        ConditionTable { seen, held, ..ConditionTable::default() }.try_into()
    }
}
