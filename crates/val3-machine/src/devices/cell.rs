//! The settings of the controller in the configuration files of a cell.

use val3_kinematics::{Arm, Violation};
use val3_lang::components::Component;
use val3_syntax::xml::{self, Element};

use super::Devices;
use crate::arm::RobotArm;
use crate::controller_state::Severity;

/// The entries that `getVersion` shows, by their names in the files.
const PARTS: [(&str, Component); 2] = [("tuning", Component::Tuning), ("mount", Component::Mounting)];

impl Devices {
    /// Takes over what a file such as `arm.cfx` or `cell.cfx` says of the arm and of the language; the rest of it is
    /// passed over.
    pub fn describe(&mut self, file: &str) {
        let parse = val3_syntax::parse(file);
        let entries = || xml::root(parse.view()).into_iter().flat_map(Element::elements);
        let value = |name: &str| {
            let named = entries().find(|entry| entry.value("name").as_deref() == Some(name));
            named.and_then(|entry| entry.value("value")).map(|value| value.trim().to_owned())
        };
        if let Some(arm) = value("arm").filter(|arm| !arm.is_empty() && !self.state.arm.is_chosen()) {
            self.set_named_arm(&arm, value("lengthAxis3").as_deref());
        }
        for entry in entries() {
            if let (Some(name), Some(value)) = (entry.value("name"), entry.value("value")) {
                self.entry(&name, value.trim());
            }
        }
        for list in entries() {
            match list.value("name").as_deref() {
                Some("minArmJointPos") => self.narrow(&axes(list), &[]),
                Some("maxArmJointPos") => self.narrow(&[], &axes(list)),
                _ => {}
            }
        }
    }

    /// Gives the controller an arm.
    pub fn set_arm(&mut self, model: Arm) {
        self.state.versions.set(Component::ArmType, model.name());
        self.state.arm = RobotArm::new(model);
    }

    /// The arm that a file of the cell names; the default arm stays where it is not known.
    fn set_named_arm(&mut self, name: &str, length_axis3: Option<&str>) {
        match Arm::by_settings(name, length_axis3) {
            Ok(model) => self.set_arm(model),
            Err(_) => self.state.arm.miss(name),
        }
        self.state.versions.set(Component::ArmType, name);
    }

    /// Narrows the limits of the arm to those of its file.
    fn narrow(&mut self, lowest: &[f64], highest: &[f64]) {
        if let Err(Violation { axis, position, min, max }) = self.state.arm.narrow(lowest, highest) {
            let text = format!(
                "arm.cfx: the limit {position} of axis {axis} leaves it no range within {min} to {max}; it is not used"
            );
            self.report(&text, Severity::Warning, 0);
        }
    }

    fn entry(&mut self, name: &str, value: &str) {
        if value.is_empty() {
            return;
        }
        if name == "language" {
            self.state.languages.install(value);
            self.state.languages.change(value);
        } else if let Some((_, part)) = PARTS.iter().find(|(known, _)| *known == name) {
            self.state.versions.set(*part, value);
        }
    }
}

/// The numbers of a list, one an axis; NaN for those that it leaves out.
fn axes(list: Element<'_>) -> [f64; 6] {
    let mut axes = [f64::NAN; 6];
    for entry in list.elements() {
        let number = |name| entry.value(name).map(|text| text.trim().to_owned());
        let (index, value) = (number("index").and_then(|text| text.parse::<usize>().ok()), number("value"));
        let slot = index.and_then(|index| axes.get_mut(index));
        if let (Some(slot), Some(value)) = (slot, value.and_then(|text| text.parse().ok())) {
            *slot = value;
        }
    }
    axes
}
