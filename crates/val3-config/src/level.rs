//! What the findings of a rule count as.

use std::fmt;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What the findings of a rule count as.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(inline)]
pub enum Level {
    /// They are not reported.
    Off,
    /// The rule's own level, also where the rule is off until it is asked for.
    On,
    /// Advice.
    Info,
    /// Nearly always a mistake.
    Warning,
    /// The check fails.
    Error,
    /// As if nothing were said.
    Default,
}

impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Off => "off",
            Self::On => "on",
            Self::Info => "info",
            Self::Warning => "warning",
            Self::Error => "error",
            Self::Default => "default",
        })
    }
}
