//! Keys for signal values.

use std::borrow::Cow;
use std::collections::BTreeMap;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;

/// Signal values, by signal path or name.
pub type SignalValues = BTreeMap<String, SignalLevel>;

/// A condition that holds while all signals have their values.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(default)]
pub struct WhenKey {
    /// Signal values, by signal path or name.
    pub io: SignalValues,
}

/// Value of a signal.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(untagged, expecting = "a signal is true, false or a number")]
pub enum SignalLevel {
    /// True or false, for a digital signal.
    Digital(bool),
    /// A number, for an analog signal.
    Analog(f64),
}

impl SignalLevel {
    /// Returns the value as a number: 0 or 1 for a digital signal.
    #[must_use]
    pub const fn number(self) -> f64 {
        match self {
            Self::Digital(true) => 1.0,
            Self::Digital(false) => 0.0,
            Self::Analog(number) => number,
        }
    }
}

impl JsonSchema for SignalLevel {
    fn schema_name() -> Cow<'static, str> {
        "SignalLevel".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": ["boolean", "number"] })
    }
}
