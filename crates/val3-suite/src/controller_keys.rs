//! Controller properties in a test file.

use std::collections::BTreeMap;

/// Keys of a test file that set its controller's initial state, as the options of `val3 run` do.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ControllerKeys {
    /// Arm name.
    pub arm: Option<String>,
    /// Joint position of the arm at the start, in degrees, or in mm for a stroke; one number for each axis.
    pub start: Option<Vec<f64>>,
    /// Whether the arm has power at the start.
    pub power: bool,
    /// Monitor speed in per cent.
    pub monitor_speed: Option<u8>,
    /// Stand-in libraries by library alias, with paths as in the file.
    pub replace: BTreeMap<String, String>,
}
