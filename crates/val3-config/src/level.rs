//! Levels of a rule's findings.

use std::fmt;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The level of a rule's findings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(inline)]
pub enum Level {
    /// They are not reported.
    Off,
    /// The rule's own level, or the level it would have if it were not off by default.
    On,
    /// Advice.
    Info,
    /// Nearly always a mistake.
    Warning,
    /// The check fails.
    Error,
    /// The same as no setting.
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
