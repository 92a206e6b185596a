//! Versions of the controller's components, and licences (`getVersion` 8.1, `getLicence` 11.3.2).

use std::collections::BTreeMap;

use val3_kinematics::DEFAULT_SIX_AXIS;
use val3_lang::components::{Component, LICENCES, OEM_LICENCE};
use val3_lang::versions::Version;

/// The state of a licence.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Licence {
    /// Usable for a limited time.
    Demo,
    /// Installed.
    Enabled,
}

impl Licence {
    /// Value that programs read.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::Demo => "demo",
            Self::Enabled => "enabled",
        }
    }
}

/// Result of `getLicence` if no licence of a machine builder can be tested.
const OEM_DISABLED: &str = "oemLicenceDisabled";

/// A licence that a machine builder made.
#[derive(Debug, Clone, PartialEq, Eq)]
struct OemLicence {
    password: String,
    state: Licence,
}

/// Initial versions of the components: a controller of the manual's language with an arm from its examples, and no
/// board.
const AT_FIRST: [(Component, &str); 7] = [
    (Component::Val3, "s7.11.0 - Jan 01 2024 - 00:00:00"),
    (Component::System, "s7.11.0"),
    (Component::ArmType, DEFAULT_SIX_AXIS),
    (Component::Tuning, "R1"),
    (Component::Mounting, "floor"),
    (Component::ControllerSerial, "F24_000001_C_01"),
    (Component::ArmSerial, "F24_000001_A_01"),
];

/// Versions and licences that were set, initially with the licences that the manual names.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ControllerVersions {
    parts: Vec<(Component, String)>,
    licences: BTreeMap<String, Licence>,
    oem: BTreeMap<String, OemLicence>,
}

impl Default for ControllerVersions {
    fn default() -> Self {
        let licences = LICENCES.map(|name| (name.to_owned(), Licence::Enabled)).into();
        let parts = AT_FIRST.map(|(part, version)| (part, version.to_owned())).to_vec();
        Self { parts, licences, oem: BTreeMap::new() }
    }
}

impl ControllerVersions {
    /// Sets the version of a component, as `getVersion` returns it: for the language `s7.11.3 - Jan 01 2024 -
    /// 00:00:00`.
    pub fn set(&mut self, part: Component, version: &str) {
        self.parts.retain(|(known, _)| *known != part);
        self.parts.push((part, version.to_owned()));
    }

    /// Sets the version of the language and of the system, which are the same.
    pub fn set_language(&mut self, version: Version) {
        let Version { major, minor, patch, .. } = version;
        let number = format!("s{major}.{minor}.{patch}");
        self.set(Component::Val3, &format!("{number} - Jan 01 2024 - 00:00:00"));
        self.set(Component::System, &number);
    }

    /// Installs or removes a licence.
    pub fn set_licence(&mut self, name: &str, licence: Option<Licence>) {
        match licence {
            Some(licence) => self.licences.insert(name.to_owned(), licence),
            None => self.licences.remove(name),
        };
    }

    /// Installs a licence that a machine builder made with a password.
    pub fn set_oem_licence(&mut self, name: &str, password: &str, state: Licence) {
        self.oem.insert(name.to_owned(), OemLicence { password: password.to_owned(), state });
    }

    /// Returns the state of a licence; `None` if it is missing, so that its instructions are run-time error 250.
    #[must_use]
    pub fn licence(&self, name: &str) -> Option<Licence> {
        self.licences.get(name).copied()
    }

    /// `getVersion`: returns the version of a component, empty if it is not set; for any other name the state of the
    /// licence, empty if it is missing.
    #[must_use]
    pub fn version(&self, component: &str) -> &str {
        match Component::from_name(component) {
            Some(part) => self.parts.iter().find(|(known, _)| *known == part).map_or("", |(_, version)| version),
            None => self.licence(component).map_or("", Licence::text),
        }
    }

    /// `getLicence`.
    #[must_use]
    pub fn oem_licence(&self, name: &str, password: &str) -> &'static str {
        if self.licence(OEM_LICENCE).is_none() {
            return OEM_DISABLED;
        }
        let licence = self.oem.get(name).filter(|licence| licence.password == password);
        licence.map_or("", |licence| licence.state.text())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_components_of_the_manual() {
        let mut versions = ControllerVersions::default();
        let parts = [
            ("VAL 3", Component::Val3, "s7.0 - Jun 18 2010 - 16:01:17"),
            ("ArmType", Component::ArmType, "rs60-S1-D20-L200"),
            ("Tuning", Component::Tuning, "R3"),
            ("Mounting", Component::Mounting, "ceiling"),
            ("ControllerSN", Component::ControllerSerial, "F07_12R3A1_C_01"),
            ("ArmSN", Component::ArmSerial, "F07_12R3A1_A_01"),
            ("Starc", Component::Starc, "1.16.3 - Sep 27 2007 - 16:01:17"),
        ];
        for (name, part, version) in parts {
            assert_ne!(versions.version(name), version);
            versions.set(part, version);
            assert_eq!(versions.version(name), version);
        }
        assert_eq!(ControllerVersions::default().version("Starc"), "");
        versions.set(Component::Tuning, "R4");
        assert_eq!(versions.version("Tuning"), "R4");
    }

    #[test]
    fn the_version_of_the_language_is_that_of_the_system() {
        let mut versions = ControllerVersions::default();
        assert_eq!((versions.version("VAL3").get(..7), versions.version("System")), (Some("s7.11.0"), "s7.11.0"));
        versions.set_language(Version::new(8, 13, 1));
        assert_eq!(versions.version("VAL 3"), "s8.13.1 - Jan 01 2024 - 00:00:00");
        assert_eq!(versions.version("System"), "s8.13.1");
    }

    #[test]
    fn a_licence_is_missing_a_demo_or_enabled() {
        let mut versions = ControllerVersions::default();
        assert_eq!(versions.version("compliance"), "enabled");
        versions.set_licence("compliance", Some(Licence::Demo));
        assert_eq!(versions.version("compliance"), "demo");
        versions.set_licence("compliance", None);
        assert_eq!((versions.version("compliance"), versions.licence("compliance")), ("", None));
        assert_eq!(versions.version("nonsense"), "");
    }

    #[test]
    fn every_result_of_a_licence_of_a_machine_builder() {
        let mut versions = ControllerVersions::default();
        versions.set_oem_licence("palletiser", "secret", Licence::Enabled);
        versions.set_oem_licence("vision", "secret", Licence::Demo);
        assert_eq!(versions.oem_licence("palletiser", "secret"), "enabled");
        assert_eq!(versions.oem_licence("vision", "secret"), "demo");
        assert_eq!(versions.oem_licence("palletiser", "wrong"), "");
        assert_eq!(versions.oem_licence("unknown", "secret"), "");
        versions.set_licence("oemLicence", None);
        assert_eq!(versions.oem_licence("palletiser", "secret"), "oemLicenceDisabled");
    }
}
