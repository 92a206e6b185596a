//! Access of instructions to power, modes, speed, versions, users and dates (4.3, 8.1).

use val3_lang::ports::{Robot, Time};
use val3_lang::values::Text;
use val3_lang::values::date::DateTime;

use super::Devices;
use super::part_events::logged;
use crate::controller_state::MessageSeverity;

impl Robot for Devices {
    fn enable_power(&mut self) {
        let now = self.now();
        let request = self.state.robot.enable_power(now);
        if let Some(refusal) = request.refusal() {
            self.report_here(refusal, MessageSeverity::Warning);
        }
    }

    fn disable_power(&mut self) {
        self.state.robot.disable_power(self.now());
    }

    fn is_power_off(&mut self) -> bool {
        self.state.robot.is_power_off()
    }

    fn is_powered(&mut self) -> bool {
        self.state.robot.is_powered()
    }

    fn is_calibrated(&mut self) -> bool {
        self.state.robot.is_calibrated()
    }

    fn working_mode(&mut self) -> (u8, u8) {
        (self.state.robot.working_mode().number(), self.state.robot.mode_state())
    }

    fn es_status(&mut self) -> u8 {
        self.state.robot.es_status() as u8
    }

    fn safety_fault(&mut self) -> Option<Text> {
        self.state.robot.safety_fault().map(Text::from)
    }

    fn monitor_speed(&mut self) -> f64 {
        self.state.robot.monitor_speed()
    }

    fn set_monitor_speed(&mut self, speed: f64) -> i8 {
        let operator_controls = self.state.profiles.active().controls_speed;
        self.state.robot.set_monitor_speed(speed, operator_controls) as i8
    }

    fn version(&mut self, component: &str) -> Text {
        Text::from(self.state.versions.version(component))
    }

    fn oem_licence(&mut self, name: &str, password: &str) -> Text {
        Text::from(self.state.versions.oem_licence(name, password))
    }

    fn date(&mut self, now: Time) -> DateTime {
        self.state.calendar.after(now)
    }

    fn log(&mut self, text: &str, level: f64) -> bool {
        let written = self.state.log.log(text, MessageSeverity::from_number(level), self.now());
        let entries = logged(&mut self.state.log);
        self.record_all(entries);
        written
    }

    fn profile(&mut self) -> Text {
        Text::from(self.state.profiles.active().name.as_str())
    }

    fn set_profile(&mut self, login: &str, password: &str) -> u8 {
        self.state.profiles.change(login, password) as u8
    }

    fn language(&mut self) -> Text {
        Text::from(self.state.languages.active())
    }

    fn set_language(&mut self, language: &str) -> bool {
        self.state.languages.change(language)
    }

    fn safe_reference(&mut self) -> f64 {
        self.state.cs9.safe_reference
    }

    fn has_external_supply(&mut self) -> bool {
        self.state.cs9.external_supply
    }

    fn restart_safety(&mut self) -> bool {
        self.state.cs9.accepts_restart
    }

    fn wake_up(&mut self) -> f64 {
        self.state.cs9.wake_up
    }

    fn reference_position(&mut self, name: &str) -> [f64; 6] {
        let mut joint = [0.0; 6];
        let known = self.state.cs9.references.get(name).into_iter().flatten();
        joint.iter_mut().zip(known).for_each(|(axis, position)| *axis = *position);
        joint
    }
}
