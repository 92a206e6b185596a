//! Parts of a controller whose version can be queried (8.1), and software licences.

/// A part whose version `getVersion` returns.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Component {
    /// The language: version with date and time of the build.
    Val3,
    /// The controller's software; public programs query it.
    System,
    /// The arm model.
    ArmType,
    /// The tuning of the arm.
    Tuning,
    /// The mounting of the arm: floor, wall or ceiling.
    Mounting,
    /// The serial number of the controller.
    ControllerSerial,
    /// The serial number of the arm.
    ArmSerial,
    /// The firmware of the axis board; empty without a board.
    Starc,
}

/// Parts with the names by which they are queried. The second names of the language and of the serial number are not in
/// the manual; public programs use them.
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

/// Software licences named in the manual.
pub const LICENCES: [&str; 9] =
    [ALTER, COMPLIANCE, ABSOLUTE_ROBOT, CONTINUOUS_AXIS, "remoteMcp", OEM_LICENCE, "plc", "testMode", "mcpMode"];

/// Licence for `alter` (11.2).
pub const ALTER: &str = "alter";

/// Licence for compliant moves (11.1).
pub const COMPLIANCE: &str = "compliance";

/// Licence for `setDH` (11.4). The manual does not state its name.
pub const ABSOLUTE_ROBOT: &str = "absoluteRobot";

/// Licence for `resetTurn` (11.5).
pub const CONTINUOUS_AXIS: &str = "continuousAxis";

/// Licence that is required to test licences of a machine builder (11.3).
pub const OEM_LICENCE: &str = "oemLicence";

impl Component {
    /// Finds the part for a name; other names are licences.
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
