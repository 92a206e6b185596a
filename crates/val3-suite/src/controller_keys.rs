//! The controller that a test asks for.

use std::collections::BTreeMap;

/// The keys of the file of a test that say how its controller begins, as the options of `val3 run` do.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ControllerKeys {
    /// The arm, by its name.
    pub arm: Option<String>,
    /// The joint position of the arm at the start, in degrees (a stroke in mm), one number an axis.
    pub start: Option<Vec<f64>>,
    /// Whether the arm has power at the start.
    pub power: bool,
    /// The monitor speed in per cent.
    pub monitor_speed: Option<u8>,
    /// The libraries that are loaded in place of others, by identifier, with paths as the file has them.
    pub replace: BTreeMap<String, String>,
}
