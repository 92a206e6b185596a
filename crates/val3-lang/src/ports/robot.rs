//! Power, modes, speed, versions, users and dates of the controller (4.3, 8).

use super::Time;
use crate::values::Text;
use crate::values::date::DateTime;

/// The state of the controller.
pub trait Robot {
    /// Switches the power of the arm on where that is allowed (`enablePower`).
    fn enable_power(&mut self);

    /// Begins to cut the power of the arm (`disablePower`).
    fn disable_power(&mut self);

    /// The power is cut, and does not come on.
    fn is_power_off(&mut self) -> bool;

    /// `isPowered`.
    fn is_powered(&mut self) -> bool;

    /// `isCalibrated`.
    fn is_calibrated(&mut self) -> bool;

    /// `workingMode`: the mode, 0 to 4, and the state within it.
    fn working_mode(&mut self) -> (u8, u8);

    /// `esStatus`: 0 to 2.
    fn es_status(&mut self) -> u8;

    /// `safetyFault`: the name of the faulty signal; `None` without a fault.
    fn safety_fault(&mut self) -> Option<Text>;

    /// `getMonitorSpeed`, in per cent.
    fn monitor_speed(&mut self) -> f64;

    /// `setMonitorSpeed`: its result, -3 to 0.
    fn set_monitor_speed(&mut self, speed: f64) -> i8;

    /// `getVersion`: of a part of the controller or of a licence; empty where there is none.
    fn version(&mut self, component: &str) -> Text;

    /// `getLicence`: the state of a licence that a machine builder made.
    fn oem_licence(&mut self, name: &str, password: &str) -> Text;

    /// Date and time at `now`, nanoseconds since the controller was started (`getDate`).
    fn date(&mut self, now: Time) -> DateTime;

    /// Writes to the event log; `level` is the kind, 1 to 3. `false` if the message is lost (`logMsg`).
    fn log(&mut self, text: &str, level: f64) -> bool;

    /// `getProfile`.
    fn profile(&mut self) -> Text;

    /// `setProfile`: its result, 0 to 4.
    fn set_profile(&mut self, login: &str, password: &str) -> u8;

    /// `getLanguage`.
    fn language(&mut self) -> Text;

    /// `setLanguage`: `false` for a language that is not installed.
    fn set_language(&mut self, language: &str) -> bool;

    /// `getSafeRefStatus` (s8).
    fn safe_reference(&mut self) -> f64;

    /// `hasCpuExtPowerSupply` (s8).
    fn has_external_supply(&mut self) -> bool;

    /// `setSafetyRestart`: whether the restart is accepted (s8).
    fn restart_safety(&mut self) -> bool;

    /// `wakeUpRobot`: its result (s8).
    fn wake_up(&mut self) -> f64;

    /// `getJntRef`: a reference position by its name; zero for any other name (s8).
    fn reference_position(&mut self, name: &str) -> [f64; 6];
}
