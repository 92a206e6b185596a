//! The parts of a controller whose version can be asked (8.1), and its software licences.

/// A part whose version `getVersion` gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Component {
    /// The language: its version with date and time of the build.
    Val3,
    /// The controller's software; public programs ask for it.
    System,
    /// The model of the arm.
    ArmType,
    /// The tuning of the arm.
    Tuning,
    /// How the arm is mounted: floor, wall or ceiling.
    Mounting,
    /// The serial number of the controller.
    ControllerSerial,
    /// The serial number of the arm.
    ArmSerial,
    /// The firmware of the axis board; empty where there is no board.
    Starc,
}

/// Each part with the names by which it is asked for. The second names of the language and of the serial number are
/// not the manual's; public programs use them.
static NAMES: [(&str, Component); 10] = [
    ("VAL 3", Component::Val3),
    ("VAL3", Component::Val3),
    ("System", Component::System),
    ("ArmType", Component::ArmType),
    ("Tuning", Component::Tuning),
    ("Mounting", Component::Mounting),
    ("ControllerSN", Component::ControllerSerial),
    ("serialNumber", Component::ControllerSerial),
    ("ArmSN", Component::ArmSerial),
    ("Starc", Component::Starc),
];

/// The software licences that the manual names.
pub const LICENCES: [&str; 9] =
    [ALTER, COMPLIANCE, ABSOLUTE_ROBOT, CONTINUOUS_AXIS, "remoteMcp", OEM_LICENCE, "plc", "testMode", "mcpMode"];

/// The licence of `alter` (11.2).
pub const ALTER: &str = "alter";

/// The licence of compliant moves (11.1).
pub const COMPLIANCE: &str = "compliance";

/// The licence of `setDH` (11.4). The manual does not print its name.
pub const ABSOLUTE_ROBOT: &str = "absoluteRobot";

/// The licence of `resetTurn` (11.5).
pub const CONTINUOUS_AXIS: &str = "continuousAxis";

/// The licence without which no licence of a machine builder can be tested (11.3).
pub const OEM_LICENCE: &str = "oemLicence";

impl Component {
    /// The part that `name` asks for; any other name is that of a licence.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        NAMES.iter().find(|(known, _)| *known == name).map(|(_, component)| *component)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_and_licences_have_different_names() {
        assert_eq!(Component::from_name("VAL 3"), Some(Component::Val3));
        assert_eq!(Component::from_name("serialNumber"), Component::from_name("ControllerSN"));
        assert!(LICENCES.iter().all(|name| Component::from_name(name).is_none()));
    }
}
