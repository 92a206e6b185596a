//! The additions of CS9 controllers (s8). They are not in the manual: plain values that are set from outside.

use std::collections::BTreeMap;

/// The additions; they start with nothing to report.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Cs9 {
    /// `getSafeRefStatus`: the state of the safety referencing.
    pub safe_reference: f64,
    /// `hasCpuExtPowerSupply`: the processor has a power supply of its own.
    pub external_supply: bool,
    /// `wakeUpRobot`: what it gives.
    pub wake_up: f64,
    /// `setSafetyRestart`: whether a restart is accepted.
    pub accepts_restart: bool,
    /// `getJntRef`: reference positions by name, in degrees, or millimetres of linear axes; any other name is zero.
    pub references: BTreeMap<String, Vec<f64>>,
}
