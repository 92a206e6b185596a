//! The settings of the controller in the configuration files of a cell.

use val3_kinematics::{Arm, Violation};
use val3_lang::components::Component;
use val3_syntax::arm_file::ArmFile;
use val3_syntax::xml::{self, Element};

use super::state::State;

/// The entries that `getVersion` shows, by their names in the files.
const PARTS: [(&str, Component); 2] = [("tuning", Component::Tuning), ("mount", Component::Mounting)];

/// The settings of a file such as `arm.cfx` or `cell.cfx` that concern the arm and the language.
#[derive(Debug, Default)]
pub(super) struct CellFile {
    arm: ArmFile,
    /// Languages and versions, in the order of the file.
    settings: Vec<Setting>,
}

#[derive(Debug)]
enum Setting {
    Language(String),
    Version(Component, String),
}

impl CellFile {
    /// Reads a file. Entries of other parts are ignored.
    pub(super) fn read(file: &str) -> Self {
        let parse = val3_syntax::parse(file);
        let entries = xml::root(parse.view()).into_iter().flat_map(Element::elements);
        Self { arm: ArmFile::read(file), settings: entries.filter_map(setting).collect() }
    }

    /// Gives the controller these settings, and returns warnings about those without effect.
    pub(super) fn apply(&self, state: &mut State) -> Vec<String> {
        if let Some(arm) = self.arm.model.as_ref().filter(|_| !state.arm.is_chosen()) {
            self.set_arm(arm, state);
        }
        for setting in &self.settings {
            match setting {
                Setting::Language(language) => {
                    state.languages.install(language);
                    state.languages.change(language);
                }
                Setting::Version(part, version) => state.versions.set(*part, version),
            }
        }
        let refused = |[lowest, highest]: &[Vec<f64>; 2]| state.arm.narrow(lowest, highest).err();
        self.arm.ranges.iter().filter_map(refused).map(not_used).collect()
    }

    /// The default arm stays if the named one is not known.
    fn set_arm(&self, name: &str, state: &mut State) {
        match Arm::by_settings(name, self.arm.length_axis3.as_deref()) {
            Ok(model) => state.set_arm(model, name),
            Err(_) => state.arm.miss(name),
        }
        state.versions.set(Component::ArmType, name);
    }
}

fn not_used(Violation { axis, position, min, max }: Violation) -> String {
    format!("arm.cfx: the limit {position} of axis {axis} leaves it no range within {min} to {max}; it is not used")
}

fn setting(entry: Element<'_>) -> Option<Setting> {
    let (name, value) = (entry.value("name")?, entry.value("value")?.trim().to_owned());
    if value.is_empty() {
        return None;
    }
    if name == "language" {
        return Some(Setting::Language(value));
    }
    PARTS.iter().find(|(known, _)| *known == name).map(|(_, part)| Setting::Version(*part, value))
}
