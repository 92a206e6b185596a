//! Conditions over signals and global data: reactions wait for them, and tests expect them.

mod evaluation;

use std::collections::BTreeMap;
use std::fmt;

use serde::Deserialize;

use super::comparison::{Comparison, LevelComparison};
pub use evaluation::Mismatch;

/// Signals and global data with the values that all of them must have at the same time.
///
/// ```toml
/// io = { "BasicIO-1\\%Q0" = true, "Scale\\weight" = { above = 3, below = 4.5 } }
/// data = { nState = 3, "sNames[1]" = "bolt", "part:bReady" = true }
/// ```
///
/// [`Controller::condition_faults`](crate::controller::Controller::condition_faults) checks that the names exist,
/// [`Controller::meets`](crate::controller::Controller::meets) and
/// [`Controller::mismatches`](crate::controller::Controller::mismatches) compare the values.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(try_from = "Tables")]
pub struct Condition {
    parts: Vec<ConditionPart>,
}

/// Content of a condition in a file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Tables {
    #[serde(default)]
    io: BTreeMap<String, LevelComparison>,
    #[serde(default)]
    data: BTreeMap<String, Comparison>,
}

impl TryFrom<Tables> for Condition {
    type Error = String;

    fn try_from(Tables { io, data }: Tables) -> Result<Self, String> {
        Self::new(io, data)
    }
}

/// Clause of a sentence: "`nState` is 3 and `nCount` is above 2".
impl fmt::Display for Condition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (part, number) in self.parts.iter().zip(0..) {
            let and = if number == 0 { "" } else { " and " };
            write!(f, "{and}`{}` is {}", part.subject.name(), part.comparison)?;
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
}

impl Subject {
    fn name(&self) -> &str {
        let (Self::Signal(name) | Self::Variable(name)) = self;
        name
    }
}

impl Condition {
    /// Creates the condition that these signals and global variables have these values.
    ///
    /// # Errors
    /// The condition names no signal or variable.
    pub fn new(io: BTreeMap<String, LevelComparison>, data: BTreeMap<String, Comparison>) -> Result<Self, String> {
        let signal = |(path, level): (_, LevelComparison)| (Subject::Signal(path), level.into());
        let signals = io.into_iter().map(signal);
        let variables = data.into_iter().map(|(name, comparison)| (Subject::Variable(name), comparison));
        let parts: Vec<ConditionPart> =
            signals.chain(variables).map(|(subject, comparison)| ConditionPart { subject, comparison }).collect();
        match parts.is_empty() {
            true => Err("a condition needs a signal in `io` or a variable in `data`".to_owned()),
            false => Ok(Self { parts }),
        }
    }
}
