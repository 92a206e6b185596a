//! The controller that applications run on.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The controller that `val3 run` executes applications on: the table `[run]`. Arguments of the command win.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct Run {
    /// What serial lines and sockets are connected to, by their links: `{ 'Socket\host' = "server:2000" }`.
    pub lines: BTreeMap<String, String>,
    /// Sockets reach other machines and are reached by them. Without it every address means this machine.
    pub network: bool,
    /// What a line of code takes on the controller's clock, in microseconds; without it 2.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "f64")]
    pub line_cost: Option<f64>,
    /// The monitor speed at the start, 0 to 100 per cent; without it 100.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "u8", range(max = 100))]
    pub monitor_speed: Option<u8>,
    /// The user profile that is active at the start; without it `default`.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "String")]
    pub profile: Option<String>,
    /// User profiles that programs may choose, besides `default`.
    pub profiles: BTreeMap<String, Profile>,
    /// Licences that are not as usual: `{ alter = "demo", compliance = "missing" }`.
    pub licences: BTreeMap<String, Licence>,
}

/// A user profile.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
#[schemars(inline)]
pub struct Profile {
    /// Its password.
    pub password: String,
    /// The operator may change the monitor speed, so that programs cannot raise it.
    pub controls_speed: bool,
}

/// The state of a licence.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(inline)]
pub enum Licence {
    /// It is installed.
    Enabled,
    /// It may be used for a while.
    Demo,
    /// It is not there, or its time is over.
    Missing,
}
