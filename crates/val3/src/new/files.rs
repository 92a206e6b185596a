//! Files of a new application and its test.

use val3_kinematics::Arm;
use val3_lang::versions::Version;
use val3_suite::library::{self, TestApplication};

use super::data;
use super::positions::NewPositions;

/// Reserved names in the test application, which its library aliases cannot use.
pub(super) const TEST_NAMES: [&str; 4] = ["start", "stop", TEST, library::ALIAS];

/// Name of the test.
const TEST: &str = "testAbove";

/// Programs that are independent of the arm.
const PROGRAMS: [(&str, &str); 3] = [
    ("above.pgx", include_str!("template/above.pgx")),
    ("start.pgx", include_str!("template/start.pgx")),
    ("stop.pgx", include_str!("template/stop.pgx")),
];

/// A new application.
pub(super) struct Application<'a> {
    /// Application name.
    pub(super) name: &'a str,
    /// Declared version.
    pub(super) version: Version,
    /// Positions.
    pub(super) positions: &'a NewPositions,
}

impl Application<'_> {
    /// Returns all files' names and texts.
    pub(super) fn files(&self, arm: &Arm) -> Vec<(String, String)> {
        let programs = PROGRAMS.map(|(file, text)| (file.to_owned(), text.replace("{name}", self.name)));
        let project = include_str!("template/application.pjx");
        let project = project.replace("{name}", self.name).replace("{version}", &self.version.to_string());
        let mut files = Vec::from(programs);
        files.push((format!("{}.dtx", self.name), data::file(arm, self.positions)));
        files.push((format!("{}.pjx", self.name), project));
        files
    }

    /// Returns all test files' names and texts.
    pub(super) fn test_files(&self) -> Vec<(String, String)> {
        let test = TestApplication { application: self.name, alias: self.name, version: self.version };
        test.files(TEST, include_str!("template/testAbove.pgx"))
    }
}
