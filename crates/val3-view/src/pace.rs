//! The pace of a run as pages spell it.

use std::ops::RangeInclusive;

use serde_json::{Value, json};

/// The slowest and the fastest pace on the real clock.
const SPEEDS: RangeInclusive<f64> = 0.1..=100.0;

/// The pace of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Speed {
    /// This many seconds of the controller in a second of the wall.
    Times(f64),
    /// Without waiting.
    Fastest,
}

impl Speed {
    /// The word for [`Speed::Fastest`].
    const FASTEST: &str = "max";

    /// The pace that a page asks for: a number from 0.1 to 100, or `"max"`.
    #[must_use]
    pub fn of(value: &Value) -> Option<Self> {
        match value {
            Value::String(text) => (text == Self::FASTEST).then_some(Self::Fastest),
            value => value.as_f64().filter(|speed| SPEEDS.contains(speed)).map(Self::Times),
        }
    }

    /// The message `clock` at a time in seconds.
    #[must_use]
    pub fn message(self, t: f64, is_paused: bool) -> Value {
        let speed = match self {
            Self::Times(speed) => json!(speed),
            Self::Fastest => json!(Self::FASTEST),
        };
        json!({ "kind": "clock", "t": t, "speed": speed, "isPaused": is_paused })
    }
}
