//! `val3assert`, the assertion library: plain VAL 3, so that the same tests run on a real controller.

use val3_lang::types::Arm;
use val3_lang::versions::Version;

/// Name of the library.
pub use val3_lang::test_names::ASSERTIONS as NAME;

/// Prefix of the message that a failure writes to the event log.
pub(crate) const FAILURE: &str = "val3assert failure: ";

/// Prefix of the message with which a test expects a run-time error.
pub(crate) const EXPECTATION: &str = "val3assert expects: ";

/// Prefix of the message with which a test skips itself.
pub(crate) const SKIP: &str = "val3assert skips: ";

/// Prefix of the message with which a test states a known failure.
pub(crate) const KNOWN_FAILURE: &str = "val3assert knows a failure: ";

/// Text of a library message after its prefix. Date, time and the mark `USR` precede the message.
pub(crate) fn after(text: &str, beginning: &str) -> Option<String> {
    text.split_once(beginning).map(|(_, message)| message.trim().to_owned())
}

/// Files of the library for an application with positions of this kind of arm: name and content.
#[must_use]
pub fn files(arm: Arm) -> Vec<(&'static str, String)> {
    let files = FILES.iter().map(|(name, content)| {
        let content = match (arm, *name) {
            (Arm::Scara, "equalJoint.pgx") => include_str!("../library/val3assert/scara/equalJoint.pgx").to_owned(),
            (Arm::Scara, "equalPose.pgx") => content.replace("type=\"point\"", "type=\"pointRs\""),
            _ => (*content).to_owned(),
        };
        (*name, content)
    });
    files.collect()
}

/// Files of the library for six axes: name and content.
const FILES: &[(&str, &str)] = &[
    ("val3assert.pjx", include_str!("../library/val3assert/val3assert.pjx")),
    ("val3assert.dtx", include_str!("../library/val3assert/val3assert.dtx")),
    ("about.pgx", include_str!("../library/val3assert/about.pgx")),
    ("contains.pgx", include_str!("../library/val3assert/contains.pgx")),
    ("equalAxis.pgx", include_str!("../library/val3assert/equalAxis.pgx")),
    ("equalBool.pgx", include_str!("../library/val3assert/equalBool.pgx")),
    ("equalJoint.pgx", include_str!("../library/val3assert/equalJoint.pgx")),
    ("equalNum.pgx", include_str!("../library/val3assert/equalNum.pgx")),
    ("equalNums.pgx", include_str!("../library/val3assert/equalNums.pgx")),
    ("equalPose.pgx", include_str!("../library/val3assert/equalPose.pgx")),
    ("equalSize.pgx", include_str!("../library/val3assert/equalSize.pgx")),
    ("equalString.pgx", include_str!("../library/val3assert/equalString.pgx")),
    ("equalStrings.pgx", include_str!("../library/val3assert/equalStrings.pgx")),
    ("equalTrsf.pgx", include_str!("../library/val3assert/equalTrsf.pgx")),
    ("expectError.pgx", include_str!("../library/val3assert/expectError.pgx")),
    ("fail.pgx", include_str!("../library/val3assert/fail.pgx")),
    ("isTrue.pgx", include_str!("../library/val3assert/isTrue.pgx")),
    ("knownFailure.pgx", include_str!("../library/val3assert/knownFailure.pgx")),
    ("notEqualNum.pgx", include_str!("../library/val3assert/notEqualNum.pgx")),
    ("notEqualString.pgx", include_str!("../library/val3assert/notEqualString.pgx")),
    ("skip.pgx", include_str!("../library/val3assert/skip.pgx")),
    ("text.pgx", include_str!("../library/val3assert/text.pgx")),
];

/// Library alias of [`NAME`] in a test application.
pub const ALIAS: &str = "assert";

/// First test for an application without known programs.
pub const FIRST_TEST: &str = "testFirst";

/// Text of the program [`FIRST_TEST`].
pub const FIRST_TEST_PROGRAM: &str = include_str!("../library/first/testFirst.pgx");

/// An application with a first test, next to the tested application.
#[derive(Debug, Clone, Copy)]
pub struct TestApplication<'a> {
    /// Name of the tested application.
    pub application: &'a str,
    /// Library alias of the tested application.
    pub alias: &'a str,
    /// VAL 3 version that both declare.
    pub version: Version,
}

impl TestApplication<'_> {
    /// Name of the test application.
    #[must_use]
    pub fn name(&self) -> String {
        format!("{}Test", self.application)
    }

    /// Returns all files' names and texts. `program` is the text of the program `test`, with `{alias}` for the
    /// library alias of the tested application.
    #[must_use]
    pub fn files(&self, test: &str, program: &str) -> Vec<(String, String)> {
        let name = self.name();
        let templates = [
            (format!("{name}.pjx"), include_str!("../library/first/first.pjx")),
            (format!("{name}.dtx"), include_str!("../library/first/first.dtx")),
            ("start.pgx".to_owned(), include_str!("../library/first/start.pgx")),
            ("stop.pgx".to_owned(), include_str!("../library/first/stop.pgx")),
            (format!("{test}.pgx"), program),
        ];
        templates.into_iter().map(|(file, template)| (file, self.filled(template, test))).collect()
    }

    /// Replaces the placeholders in a file's text. `test` is the name of the test program.
    fn filled(&self, template: &str, test: &str) -> String {
        let text = template.replace("{version}", &self.version.to_string()).replace("{test}", test);
        let text = text.replace("{name}", &self.name()).replace("{alias}", self.alias);
        text.replace("{application}", self.application)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_programs_about_positions_depend_on_the_arm() {
        let (six, scara) = (files(Arm::SixAxis), files(Arm::Scara));
        let other = six.iter().zip(&scara).filter(|(one, other)| one != other).map(|((name, _), _)| *name);
        assert_eq!(other.collect::<Vec<_>>(), ["equalJoint.pgx", "equalPose.pgx"]);
        let pose =
            |files: &[(&str, String)]| files.iter().find(|(name, _)| *name == "equalPose.pgx").unwrap().1.clone();
        assert_eq!(pose(&scara), pose(&six).replace("type=\"point\"", "type=\"pointRs\""));
    }

    #[test]
    fn a_test_application_is_filled_with_names_and_version() {
        let version = Version::parse("s8.3").unwrap();
        let files = TestApplication { application: "pal", alias: "box", version }.files(FIRST_TEST, FIRST_TEST_PROGRAM);
        let names: Vec<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, ["palTest.pjx", "palTest.dtx", "start.pgx", "stop.pgx", "testFirst.pgx"]);
        let text: String = files.iter().map(|(_, text)| text.as_str()).collect();
        for filled in [
            "version=\"s8.3\"",
            "palTest.dtx",
            "alias=\"box\" path=\"../pal/pal.pjx\"",
            "call testFirst()",
            "`call box:program()`",
        ] {
            assert!(text.contains(filled), "{filled}: {text}");
        }
        assert!(!text.contains('{'), "{text}");
    }

    #[test]
    fn a_message_is_the_text_after_its_prefix() {
        let logged = "2026-11-27 10:00:00 USR val3assert failure: 1 instead of 2 ";
        assert_eq!(after(logged, FAILURE).as_deref(), Some("1 instead of 2"));
        assert_eq!(after(logged, SKIP), None);
    }
}
