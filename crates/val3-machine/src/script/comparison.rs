//! Comparisons of signal and variable values in conditions.

use std::fmt;

use serde::Deserialize;
use val3_lang::types::BaseType;

use super::values::{ScriptValue, SignalValue};

/// The value that a variable must have.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(
    untagged,
    expecting = "a variable is compared with true, false, a number, a text or a range such as { above = 2, below = 5 }"
)]
pub enum Comparison {
    /// This value.
    Is(ScriptValue),
    /// A number in a range.
    Within(ComparedRange),
}

/// The value that a signal must have.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(
    untagged,
    expecting = "a signal is compared with true, false, a number or a range such as { above = 2, below = 5 }"
)]
pub enum LevelComparison {
    /// This value.
    Is(SignalValue),
    /// A number in a range.
    Within(ComparedRange),
}

/// A range of numbers.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(try_from = "RangeLimits")]
pub enum ComparedRange {
    /// Numbers between two limits, of which one may be missing.
    Between {
        /// The number is greater.
        above: Option<f64>,
        /// The number is less.
        below: Option<f64>,
    },
    /// Numbers within a distance.
    Near {
        /// The number in the middle.
        is: f64,
        /// The largest distance.
        within: f64,
    },
}

/// Content of a range in a file.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct RangeLimits {
    above: Option<f64>,
    below: Option<f64>,
    is: Option<f64>,
    within: Option<f64>,
}

impl TryFrom<RangeLimits> for ComparedRange {
    type Error = &'static str;

    fn try_from(RangeLimits { above, below, is, within }: RangeLimits) -> Result<Self, Self::Error> {
        match (is, within) {
            (None, None) if above.is_some() || below.is_some() => Ok(Self::Between { above, below }),
            (Some(is), Some(within @ 0.0..)) if above.is_none() && below.is_none() => Ok(Self::Near { is, within }),
            _ => Err("write `above`, `below` or both, or `is` and `within`"),
        }
    }
}

impl ComparedRange {
    fn contains(&self, number: f64) -> bool {
        match self {
            Self::Between { above, below } => {
                above.is_none_or(|limit| number > limit) && below.is_none_or(|limit| number < limit)
            }
            Self::Near { is, within } => (number - is).abs() <= *within,
        }
    }
}

impl fmt::Display for ComparedRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Between { above, below } => {
                let limits = [("above", above), ("below", below)];
                let limits = limits.map(|(word, limit)| limit.map(|limit| format!("{word} {limit}")));
                f.write_str(&limits.into_iter().flatten().collect::<Vec<_>>().join(" and "))
            }
            Self::Near { is, within } => write!(f, "{is} within {within}"),
        }
    }
}

impl From<LevelComparison> for Comparison {
    fn from(comparison: LevelComparison) -> Self {
        match comparison {
            LevelComparison::Is(SignalValue::Digital(value)) => Self::Is(ScriptValue::Bool(value)),
            LevelComparison::Is(SignalValue::Analog(value)) => Self::Is(ScriptValue::Num(value)),
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

    /// Whether the comparison accepts a value.
    pub(super) fn accepts(&self, actual: &ScriptValue) -> bool {
        match (self, actual) {
            (Self::Is(expected), _) => expected == actual,
            (Self::Within(range), ScriptValue::Num(number)) => range.contains(*number),
            (Self::Within(_), _) => false,
        }
    }
}

/// End of a sentence: `3`, `"bolt"`, `above 2 and below 5`.
impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Is(value) => value.fmt(f),
            Self::Within(range) => range.fmt(f),
        }
    }
}
