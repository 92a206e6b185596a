//! Comparisons of the values of signals and variables, as conditions write them.

use std::fmt;

use serde::Deserialize;
use val3_lang::types::BaseType;

use super::values::{Level, Value};

/// The value that a variable must have.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(
    untagged,
    expecting = "a variable is compared with true, false, a number, a text or a range such as { above = 2, below = 5 }"
)]
pub(super) enum Comparison {
    Is(Value),
    Within(Range),
}

/// The value that a signal must have.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(
    untagged,
    expecting = "a signal is compared with true, false, a number or a range such as { above = 2, below = 5 }"
)]
pub(super) enum LevelComparison {
    Is(Level),
    Within(Range),
}

/// The numbers between two limits, of which one may be missing.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(try_from = "Limits")]
pub(super) struct Range(Limits);

#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct Limits {
    above: Option<f64>,
    below: Option<f64>,
}

impl TryFrom<Limits> for Range {
    type Error = &'static str;

    fn try_from(limits: Limits) -> Result<Self, Self::Error> {
        let is_limited = limits.above.is_some() || limits.below.is_some();
        is_limited.then_some(Self(limits)).ok_or("write `above`, `below` or both")
    }
}

impl From<LevelComparison> for Comparison {
    fn from(comparison: LevelComparison) -> Self {
        match comparison {
            LevelComparison::Is(Level::Digital(value)) => Self::Is(Value::Bool(value)),
            LevelComparison::Is(Level::Analog(value)) => Self::Is(Value::Num(value)),
            LevelComparison::Within(range) => Self::Within(range),
        }
    }
}

impl Comparison {
    /// Whether a variable of this type can be compared.
    pub(super) fn suits(&self, base: BaseType) -> bool {
        match self {
            Self::Is(value) => value.suits(base),
            Self::Within(_) => base == BaseType::Num,
        }
    }

    /// Whether a value is as it must be.
    pub(super) fn accepts(&self, actual: &Value) -> bool {
        match (self, actual) {
            (Self::Is(expected), _) => expected == actual,
            (Self::Within(Range(Limits { above, below })), Value::Num(number)) => {
                above.is_none_or(|limit| *number > limit) && below.is_none_or(|limit| *number < limit)
            }
            (Self::Within(_), _) => false,
        }
    }
}

/// The end of a sentence: `3`, `"bolt"`, `above 2 and below 5`.
impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Is(value) => value.fmt(f),
            Self::Within(Range(Limits { above, below })) => {
                let limits = [("above", above), ("below", below)];
                let limits = limits.map(|(word, limit)| limit.map(|limit| format!("{word} {limit}")));
                f.write_str(&limits.into_iter().flatten().collect::<Vec<_>>().join(" and "))
            }
        }
    }
}
