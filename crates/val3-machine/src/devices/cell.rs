//! Settings of the controller in a cell's configuration files.

use val3_kinematics::{Arm, Violation};
use val3_lang::components::Component;
use val3_motion::MillimetresPerSecond;
use val3_syntax::arm_file::ArmFile;
use val3_syntax::xml::{self, XmlElement};

use super::state::DeviceState;

/// Entries that `getVersion` returns, by their names in the files.
const PARTS: [(&str, Component); 2] = [("tuning", Component::Tuning), ("mount", Component::Mounting)];

/// Settings for the arm, its speed and the language in a file such as `arm.cfx` or `cell.cfx`.
#[derive(Debug, Default)]
pub(super) struct CellFile {
    arm: ArmFile,
    /// Languages, versions and speeds, in the order of the file.
    settings: Vec<CellSetting>,
}

#[derive(Debug)]
enum CellSetting {
    Language(String),
    Version(Component, String),
    ManualSpeed(String),
}

impl CellFile {
    /// Reads a file. Entries of other parts are ignored.
    pub(super) fn read(file: &str) -> Self {
        let parse = val3_syntax::parse(file);
        let entries = xml::root(parse.view()).into_iter().flat_map(XmlElement::elements);
        Self { arm: ArmFile::read(file), settings: entries.filter_map(setting).collect() }
    }

    /// Applies the settings, and returns warnings about settings without effect.
    pub(super) fn apply(&self, state: &mut DeviceState) -> Vec<String> {
        if let Some(arm) = self.arm.model.as_ref().filter(|_| !state.arm.is_chosen()) {
            self.set_arm(arm, state);
        }
        let mut warnings = Vec::new();
        for setting in &self.settings {
            match setting {
                CellSetting::Language(language) => {
                    state.languages.install(language);
                    state.languages.change(language);
                }
                CellSetting::Version(part, version) => state.versions.set(*part, version),
                CellSetting::ManualSpeed(speed) => match manual_speed(speed) {
                    Some(speed) => state.robot.set_manual_speed(speed),
                    None => warnings.push(no_speed(speed)),
                },
            }
        }
        let refused = |[lowest, highest]: &[Vec<f64>; 2]| state.arm.narrow(lowest, highest).err();
        warnings.extend(self.arm.ranges.iter().filter_map(refused).map(not_used));
        warnings
    }

    /// Sets the named arm. If it is unknown, the default arm stays.
    fn set_arm(&self, name: &str, state: &mut DeviceState) {
        match Arm::by_settings(name, self.arm.length_axis3.as_deref()) {
            Ok(model) => state.set_arm(model, name),
            Err(_) => state.arm.miss(name),
        }
        state.versions.set(Component::ArmType, name);
    }
}

fn not_used(Violation { axis, position, min, max, unit }: Violation) -> String {
    format!(
        "arm.cfx: the limit {position} of axis {axis} leaves it no range within {min} to {max} {unit}; it is not used"
    )
}

/// Parses a speed above 0, in mm/s.
fn manual_speed(text: &str) -> Option<MillimetresPerSecond> {
    let speed = text.parse().ok().filter(|speed: &f64| speed.is_finite() && *speed > 0.0);
    speed.map(MillimetresPerSecond)
}

fn no_speed(text: &str) -> String {
    format!("cell.cfx: maxManuCartSpeed is `{text}`, not a speed above 0 in mm/s; it is not used")
}

fn setting(entry: XmlElement<'_>) -> Option<CellSetting> {
    let (name, value) = (entry.value("name")?, entry.value("value")?.trim().to_owned());
    if value.is_empty() {
        return None;
    }
    match &*name {
        "language" => Some(CellSetting::Language(value)),
        "maxManuCartSpeed" => Some(CellSetting::ManualSpeed(value)),
        _ => PARTS.iter().find(|(known, _)| *known == name).map(|(_, part)| CellSetting::Version(*part, value)),
    }
}
