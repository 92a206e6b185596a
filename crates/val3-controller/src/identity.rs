//! Identity of a controller: its serial numbers.

use serde::{Deserialize, Serialize};

/// Serial numbers of a controller and its arm.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct ControllerIdentity {
    /// Serial number of the controller; empty if it has none, for example on an emulator.
    pub serial: String,
    /// Serial number of the arm; empty if it is unknown.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub arm: String,
}
