//! Controller state: power, modes, speed, versions, users, dates (4.3, 8).

use super::Time;
use crate::values::Text;
use crate::values::date::DateTime;

/// Controller state.
pub trait Robot {
    /// Switches the arm's power on, if this is allowed (`enablePower`).
    fn enable_power(&mut self);

    /// Starts to switch the arm's power off (`disablePower`).
    fn disable_power(&mut self);

    /// Whether the power is off and is not being switched on.
    fn is_power_off(&mut self) -> bool;

    /// Whether the arm has power (`isPowered`).
    fn is_powered(&mut self) -> bool;

    /// Whether all axes are calibrated (`isCalibrated`).
    fn is_calibrated(&mut self) -> bool;

    /// `workingMode`: returns the mode, 0 to 4, and the state in this mode.
    fn working_mode(&mut self) -> (u8, u8);

    /// `esStatus`: returns 0 to 2.
    fn es_status(&mut self) -> u8;

    /// `safetyFault`: returns the faulty signal's name; `None` without a fault.
    fn safety_fault(&mut self) -> Option<Text>;

    /// `getMonitorSpeed`: returns the monitor speed in per cent.
    fn monitor_speed(&mut self) -> f64;

    /// `setMonitorSpeed`: returns -3 to 0.
    fn set_monitor_speed(&mut self, speed: f64) -> i8;

    /// `getVersion`: returns the version of a controller component or the state of a licence; empty if it is unknown.
    fn version(&mut self, component: &str) -> Text;

    /// `getLicence`: returns the state of a machine builder's licence.
    fn oem_licence(&mut self, name: &str, password: &str) -> Text;

    /// Returns date and time at `now`, in nanoseconds since the controller's start (`getDate`).
    fn date(&mut self, now: Time) -> DateTime;

    /// Writes a message to the event log, with level 1 to 3. `false` if the message is lost (`logMsg`).
    fn log(&mut self, text: &str, level: f64) -> bool;

    /// `getProfile`: returns the active profile's name.
    fn profile(&mut self) -> Text;

    /// `setProfile`: returns 0 to 4.
    fn set_profile(&mut self, login: &str, password: &str) -> u8;

    /// `getLanguage`: returns the active language.
    fn language(&mut self) -> Text;

    /// `setLanguage`: returns `false` for a language that is not installed.
    fn set_language(&mut self, language: &str) -> bool;

    /// `getSafeRefStatus`: returns the state of the safety referencing (s8).
    fn safe_reference(&mut self) -> f64;

    /// Whether the processor has a separate power supply (`hasCpuExtPowerSupply`; s8).
    fn has_external_supply(&mut self) -> bool;

    /// `setSafetyRestart`: whether the restart is accepted (s8).
    fn restart_safety(&mut self) -> bool;

    /// `wakeUpRobot`: returns its result (s8).
    fn wake_up(&mut self) -> f64;

    /// `getJntRef`: returns the reference position with this name; zeros for an unknown name (s8).
    fn reference_position(&mut self, name: &str) -> [f64; 6];
}
