//! Additional features of CS9 controllers (s8). They are not in the manual: plain values that are set from outside.

use std::collections::BTreeMap;

/// Additional features, initially with nothing to report.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Cs9 {
    /// `getSafeRefStatus`: state of the safety referencing.
    pub safe_reference: f64,
    /// `hasCpuExtPowerSupply`: whether the processor has a separate power supply.
    pub external_supply: bool,
    /// `wakeUpRobot`: result of the instruction.
    pub wake_up: f64,
    /// `setSafetyRestart`: whether a restart is accepted.
    pub accepts_restart: bool,
    /// `getJntRef`: reference positions by name, in degrees, or millimetres of linear axes; any other name is zero.
    pub references: BTreeMap<String, Vec<f64>>,
}
