//! The settings of the controller in the configuration files of a cell.

use val3_lang::components::Component;
use val3_syntax::xml::{self, Element};

use super::Devices;
use crate::arm::JointLimits;

/// The entries that `getVersion` shows, by their names in the files.
const PARTS: [(&str, Component); 2] = [("tuning", Component::Tuning), ("mount", Component::Mounting)];

impl Devices {
    /// Takes over what a file such as `arm.cfx` or `cell.cfx` says of the arm and of the language; the rest of it is
    /// passed over.
    pub fn describe(&mut self, file: &str) {
        let parse = val3_syntax::parse(file);
        let entries = || xml::root(parse.view()).into_iter().flat_map(Element::elements);
        for entry in entries() {
            if let (Some(name), Some(value)) = (entry.value("name"), entry.value("value")) {
                self.entry(&name, value.trim());
            }
        }
        for list in entries() {
            match list.value("name").as_deref() {
                Some("minArmJointPos") => self.state.arm.limits.raise(axes(list, f64::NEG_INFINITY)),
                Some("maxArmJointPos") => self.state.arm.limits.lower(axes(list, f64::INFINITY)),
                _ => {}
            }
        }
    }

    /// Gives the controller an arm of this model, with the known limits of its axes.
    pub fn set_arm(&mut self, model: &str) {
        self.state.versions.set(Component::ArmType, model);
        self.state.arm.limits = JointLimits::of_model(model);
    }

    fn entry(&mut self, name: &str, value: &str) {
        if value.is_empty() {
            return;
        }
        if name == "language" {
            self.state.languages.install(value);
            self.state.languages.change(value);
        } else if name == "arm" {
            self.set_arm(value);
        } else if let Some((_, part)) = PARTS.iter().find(|(known, _)| *known == name) {
            self.state.versions.set(*part, value);
        }
    }
}

/// The numbers of a list, one an axis; `missing` for those that it leaves out.
fn axes(list: Element<'_>, missing: f64) -> [f64; 6] {
    let mut axes = [missing; 6];
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
