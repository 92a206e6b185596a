//! Pace of a run in the format of pages.

use std::ops::RangeInclusive;

use serde_json::{Value, json};

/// Range of paces in real time.
const SPEEDS: RangeInclusive<f64> = 0.1..=100.0;

/// Pace of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Speed {
    /// Controller seconds per real second.
    Times(f64),
    /// As fast as possible.
    Fastest,
}

impl Speed {
    /// Text for [`Speed::Fastest`].
    const FASTEST: &str = "max";

    /// Parses the pace that a page requests: a number from 0.1 to 100, or `"max"`.
    #[must_use]
    pub fn of(value: &Value) -> Option<Self> {
        match value {
            Value::String(text) => (text == Self::FASTEST).then_some(Self::Fastest),
            value => value.as_f64().filter(|speed| SPEEDS.contains(speed)).map(Self::Times),
        }
    }

    /// Message `clock` at a time in seconds.
    #[must_use]
    pub fn message(self, t: f64, is_paused: bool) -> Value {
        let speed = match self {
            Self::Times(speed) => json!(speed),
            Self::Fastest => json!(Self::FASTEST),
        };
        json!({ "kind": "clock", "t": t, "speed": speed, "isPaused": is_paused })
    }
}
