//! Options (licences) of a controller.

use super::cfx::Settings;

/// Options in `controller.cfx` and `options.cfx`, by their names there.
const NAMES: [&str; 8] =
    ["VAL 3", "testMode", "mcpMode", "continuousAxis", "valKernel", "valPlast", "valTending", "uniVAL"];

/// Value for options on trial, and for all options in emulators.
const TRIAL: &str = "Demo";

/// An option.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ControllerOption {
    /// Name, which `getLicence` in programs accepts.
    pub name: String,
    /// State.
    pub state: OptionState,
}

/// Option state. The licence code is not read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OptionState {
    /// A licence code is stored.
    Installed,
    /// The option is on trial.
    Trial,
    /// No licence is stored.
    Missing,
}

impl OptionState {
    /// State in a word.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Installed => "installed",
            Self::Trial => "trial",
            Self::Missing => "missing",
        }
    }
}

/// Returns the known options in the settings.
pub(super) fn options(settings: &Settings) -> Vec<ControllerOption> {
    let known = settings.iter().filter(|setting| setting.kind == "String" && NAMES.contains(&setting.name.as_str()));
    let option = known.map(|setting| ControllerOption { name: setting.name.clone(), state: state(&setting.value) });
    option.collect()
}

fn state(value: &str) -> OptionState {
    match value {
        "" => OptionState::Missing,
        TRIAL => OptionState::Trial,
        _ => OptionState::Installed,
    }
}
