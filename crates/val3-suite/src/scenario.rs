//! Scenario file `NAME.toml`: a script of the cell with expectations.
//!
//! A test program may have such a file next to it. A scenario also names the application that it runs:
//!
//! ```toml
//! application = "../usr/usrapp/palletiser"   # relative to the file
//! program = "start"                          # unless it is another one
//! until = 11                                 # seconds after which the run ends; else the application ends by itself
//! limit = 200                                # seconds after which an application that does not end has failed
//! power = true                               # the controller at the start: also arm, start, monitor_speed
//! skip = "needs the scale"                   # it is not executed
//! known_failure = "the scale is wrong"       # it is executed and has to fail
//!
//! [[at]]                                     # as in the scripts of `val3 run`
//! t = 0.1
//! power = true
//!
//! [expect]
//! screen = ["2 boxes"]
//! ```

use std::collections::BTreeMap;
use std::fmt;
use std::ops::Range;

use serde::Deserialize;
use toml::Spanned;
use val3_lang::ports::Time;
use val3_machine::controller::Controller;
use val3_machine::script::{ReactionRule, Script, Seconds, TimedEntry};

use crate::case::TestKind;
use crate::expect::{Expectations, Fit, Observer};
use crate::source::ExpectationSource;

/// Program that a scenario starts by default.
pub(crate) const START: &str = "start";

/// Content of a file.
#[derive(Debug, Clone, Default)]
pub struct Scenario {
    /// Script of the controller's environment.
    script: Script,
    pub(crate) run: RequestedRun,
    /// Initial state of the controller.
    controller_keys: ControllerKeys,
    /// Timeout of the test, in seconds.
    limit: Option<Seconds>,
    /// Reason why the test is skipped.
    skip: Option<Reason>,
    /// Reason of the known failure.
    known_failure: Option<Reason>,
    /// Tags for the selection of tests.
    tags: Vec<String>,
    pub(crate) expectations: Expectations,
    pub(crate) source: ExpectationSource,
}

/// Requested application run.
#[derive(Debug, Clone, Default)]
pub(crate) struct RequestedRun {
    application: Option<Spanned<String>>,
    pub(crate) program: Option<Spanned<String>>,
    pub(crate) until: Option<Spanned<Seconds>>,
}

/// Keys of a test file that set its controller's initial state, as the options of `val3 run` do.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ControllerKeys {
    /// Arm name.
    pub arm: Option<String>,
    /// Joint position of the arm at the start, in degrees, or in mm for a stroke; one number for each axis.
    pub start: Option<Vec<f64>>,
    /// Whether the arm has power at the start.
    pub power: bool,
    /// Monitor speed in per cent.
    pub monitor_speed: Option<u8>,
    /// File with the things around the arm, or `none`.
    pub cell: Option<String>,
    /// Stand-in libraries by library alias, with paths as in the file.
    pub replace: BTreeMap<String, String>,
}

/// Keys of a file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ScenarioFile {
    application: Option<Spanned<String>>,
    program: Option<Spanned<String>>,
    until: Option<Spanned<Seconds>>,
    limit: Option<Seconds>,
    skip: Option<Reason>,
    known_failure: Option<Reason>,
    arm: Option<String>,
    cell: Option<String>,
    start: Option<Vec<f64>>,
    #[serde(default)]
    power: bool,
    monitor_speed: Option<MonitorSpeed>,
    #[serde(default)]
    tags: Vec<String>,
    #[serde(default)]
    replace: BTreeMap<String, String>,
    #[serde(default)]
    at: Vec<TimedEntry>,
    #[serde(default)]
    when: Vec<Spanned<ReactionRule>>,
    #[serde(default)]
    silent: Vec<String>,
    #[serde(default)]
    expect: Expectations,
}

/// A non-empty reason.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(try_from = "String")]
struct Reason(String);

impl TryFrom<String> for Reason {
    type Error = &'static str;

    fn try_from(text: String) -> Result<Self, Self::Error> {
        if text.trim().is_empty() { Err("write the reason") } else { Ok(Self(text)) }
    }
}

/// Monitor speed in per cent.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(try_from = "i64")]
struct MonitorSpeed(u8);

impl TryFrom<i64> for MonitorSpeed {
    type Error = String;

    fn try_from(speed: i64) -> Result<Self, String> {
        let known = u8::try_from(speed).ok().filter(|speed| *speed <= 100);
        known.map(Self).ok_or_else(|| format!("{speed} is no monitor speed: write 0 to 100 per cent"))
    }
}

/// Role of a TOML file among tests.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TestFileRole {
    /// It names the application that it runs.
    Scenario,
    /// It has expectations, but names no application: it belongs to a test program.
    Expectations,
    /// It is only a script of a controller's environment.
    Script,
    /// It is unrelated to tests.
    Other,
}

/// Reason why a file is invalid, with the location in the file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ScenarioError(String);

impl fmt::Display for ScenarioError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for ScenarioError {}

impl Scenario {
    /// Parses the file at `path`, which failures name.
    ///
    /// # Errors
    /// The text is no TOML, or has an invalid key or value.
    pub fn parse(path: &str, text: &str) -> Result<Self, ScenarioError> {
        let file: ScenarioFile =
            toml::from_str(text).map_err(|error| ScenarioError(error.to_string().trim_end().to_owned()))?;
        let source = ExpectationSource::new(path, text);
        let script = Script::new(file.at, file.when, file.silent, text);
        let run = RequestedRun { application: file.application, program: file.program, until: file.until };
        let ScenarioFile {
            replace,
            tags,
            limit,
            skip,
            known_failure,
            arm,
            cell,
            start,
            power,
            monitor_speed,
            expect: expectations,
            ..
        } = file;
        let controller_keys =
            ControllerKeys { arm, cell, start, power, monitor_speed: monitor_speed.map(|speed| speed.0), replace };
        Ok(Self { script, run, controller_keys, tags, limit, skip, known_failure, expectations, source })
    }

    /// Role of a file in a test folder or next to programs, determined from its text.
    #[must_use]
    pub fn role(text: &str) -> TestFileRole {
        #[derive(Deserialize)]
        struct Probe {
            application: Option<serde::de::IgnoredAny>,
            expect: Option<serde::de::IgnoredAny>,
            at: Option<serde::de::IgnoredAny>,
            when: Option<serde::de::IgnoredAny>,
            silent: Option<serde::de::IgnoredAny>,
        }
        let begins = |word: &str| text.lines().any(|line| line.trim_start().starts_with(word));
        match toml::from_str::<Probe>(text) {
            Ok(Probe { application: Some(_), .. }) => TestFileRole::Scenario,
            Ok(Probe { expect: Some(_), .. }) => TestFileRole::Expectations,
            Ok(Probe { at, when, silent, .. }) if at.or(when).or(silent).is_some() => TestFileRole::Script,
            Ok(_) => TestFileRole::Other,
            // An invalid file that appears to be a scenario is reported.
            Err(_) if begins("application") => TestFileRole::Scenario,
            Err(_) if begins("[expect") || begins("[[expect") => TestFileRole::Expectations,
            Err(_) => TestFileRole::Other,
        }
    }

    /// Application that a scenario runs, relative to its file.
    ///
    /// # Errors
    /// The file names no application.
    pub fn application(&self) -> Result<&str, ScenarioError> {
        let application = self.run.application.as_ref().map(|name| name.get_ref().as_str());
        application.ok_or_else(|| ScenarioError("it names no application, and no test program has its name".to_owned()))
    }

    /// Initial state of the controller.
    #[must_use]
    pub fn controller_keys(&self) -> &ControllerKeys {
        &self.controller_keys
    }

    /// Timeout of the test, on the controller's clock in nanoseconds.
    #[must_use]
    pub fn limit(&self) -> Option<Time> {
        self.limit.map(Seconds::time)
    }

    /// Tags for the selection of tests.
    #[must_use]
    pub fn tags(&self) -> &[String] {
        &self.tags
    }

    /// Reason why the test is skipped.
    #[must_use]
    pub fn skip(&self) -> Option<&str> {
        self.skip.as_ref().map(|reason| reason.0.as_str())
    }

    /// Reason of the known failure.
    pub(crate) fn known_failure(&self) -> Option<String> {
        self.known_failure.as_ref().map(|reason| reason.0.clone())
    }

    /// Script of the controller's environment.
    #[must_use]
    pub fn script(&self) -> &Script {
        &self.script
    }

    /// Prepares a controller that has not executed anything: it follows the script, and lines with input in the script
    /// or with expected output are connected to the test.
    pub fn prepare(&self, controller: &mut Controller) {
        self.expectations.lines().for_each(|link| controller.devices.lines.connect_script(link));
        controller.follow(self.script.clone());
    }

    /// Creates the observer of the expectations.
    pub(crate) fn observer(&self) -> Observer {
        Observer::new(&self.expectations, &self.source)
    }

    /// Faults of the script and the expectations, before the run: unknown variables, signals and other names, values of
    /// the wrong type, and times after the end. `is_resized` returns whether a data item changes its size.
    #[must_use]
    pub fn faults(&self, controller: &Controller, is_resized: &dyn Fn(&str) -> bool) -> Vec<String> {
        let until = self.run.until.as_ref().map(|until| until.get_ref().time());
        let fit = Fit { controller, is_resized, until };
        let worded = |(span, problem): (Range<usize>, String)| format!("line {}: {problem}", self.source.line(span));
        let program = self.run.program.as_ref().and_then(|name| fit.program(name.get_ref(), &name.span()));
        let script = controller.script_faults(&self.script, is_resized).into_iter().map(|fault| fault.to_string());
        script.chain(program.into_iter().chain(self.expectations.faults(&fit)).map(worded)).collect()
    }

    /// Checks that the file has no keys for the other kind of test.
    ///
    /// # Errors
    /// The file belongs to a test program, and states which application to run.
    pub fn check_kind(&self, kind: TestKind) -> Result<(), ScenarioError> {
        let RequestedRun { application, program, until } = &self.run;
        let keys = [
            ("application", application.as_ref().map(Spanned::span)),
            ("program", program.as_ref().map(Spanned::span)),
            ("until", until.as_ref().map(Spanned::span)),
        ];
        let found = keys.into_iter().find_map(|(key, span)| Some((key, span?)));
        match found.filter(|_| kind == TestKind::Program) {
            None => Ok(()),
            Some((key, span)) => Err(ScenarioError(format!(
                "line {}: `{key}` is a key of scenarios, and this file belongs to the test program beside it",
                self.source.line(span)
            ))),
        }
    }
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};

    use super::*;

    #[track_caller]
    fn check_error(text: &str, expected: Expect) {
        expected.assert_eq(&Scenario::parse("tests/a.toml", text).unwrap_err().to_string());
    }

    #[test]
    fn a_scenario_is_read() {
        let text = "application = \"../a\"\nuntil = 2\n[[at]]\nt = 1\npower = true\n[expect]\nscreen = [\"a\"]\n";
        let scenario = Scenario::parse("tests/a.toml", text).unwrap();
        assert_eq!(scenario.application(), Ok("../a"));
        assert_eq!(scenario.script.next_due(), Some(1_000_000_000));
        assert_eq!(scenario.check_kind(TestKind::Scenario), Ok(()));
        let place = Scenario::parse("", "until = 2").unwrap().check_kind(TestKind::Program).unwrap_err();
        assert!(place.to_string().starts_with("line 1: `until` is a key of scenarios"), "{place}");
        assert!(Scenario::default().application().is_err());
    }

    #[test]
    fn files_have_roles() {
        for (text, expected) in [
            ("application = \"a\"", TestFileRole::Scenario),
            ("[[at]]\nt = 1\n[expect]\napplication = \"a\"", TestFileRole::Expectations),
            ("aplication = \"a\"\n[expect]\nprint = []", TestFileRole::Expectations),
            ("[[when]]\n", TestFileRole::Script),
            ("x = 1", TestFileRole::Other),
            ("", TestFileRole::Other),
            ("application = \"a", TestFileRole::Scenario),
            ("[expect]\nprint = [", TestFileRole::Expectations),
            ("no toml", TestFileRole::Other),
        ] {
            assert_eq!(Scenario::role(text), expected, "{text}");
        }
    }

    #[test]
    fn faults_are_shown_with_their_position() {
        check_error(
            "aplication = \"a\"",
            expect![[r#"
                TOML parse error at line 1, column 1
                  |
                1 | aplication = "a"
                  | ^^^^^^^^^^
                unknown field `aplication`, expected one of `application`, `program`, `until`, `limit`, `skip`, `known_failure`, `arm`, `cell`, `start`, `power`, `monitor_speed`, `tags`, `replace`, `at`, `when`, `silent`, `expect`"#]],
        );
        check_error(
            "application = 1",
            expect![[r#"
                TOML parse error at line 1, column 15
                  |
                1 | application = 1
                  |               ^
                invalid type: integer `1`, expected a string"#]],
        );
        check_error(
            "until = 1e300",
            expect![[r#"
                TOML parse error at line 1, column 9
                  |
                1 | until = 1e300
                  |         ^^^^^
                1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000 is not a time: write seconds, 0 or more"#]],
        );
        check_error(
            "[expect]\nscren = [\"a\"]",
            expect![[r#"
                TOML parse error at line 2, column 1
                  |
                2 | scren = ["a"]
                  | ^^^^^
                unknown field `scren`, expected one of `screen`, `screen_file`, `print_file`, `io`, `data`, `print`, `log`, `popup`, `sent`, `errors`, `seen`, `held`, `placed`, `at`, `within`, `order`, `time`, `trace`, `speed`, `inside`, `clear`, `contact`, `clearance`"#]],
        );
        check_error(
            "[expect]\nscreen = \"a\"",
            expect![[r#"
                TOML parse error at line 2, column 10
                  |
                2 | screen = "a"
                  |          ^^^
                invalid type: string "a", expected a sequence"#]],
        );
        check_error(
            "[expect]\nerrors = [{ code = 70000 }]",
            expect![[r#"
                TOML parse error at line 2, column 20
                  |
                2 | errors = [{ code = 70000 }]
                  |                    ^^^^^
                invalid value: integer `70000`, expected u16"#]],
        );
        check_error(
            "[expect]\nerrors = [{ task = \"a\" }]",
            expect![[r#"
                TOML parse error at line 2, column 11
                  |
                2 | errors = [{ task = "a" }]
                  |           ^^^^^^^^^^^^^^
                missing field `code`"#]],
        );
        check_error(
            "[[expect.at]]\nscreen = [\"a\"]",
            expect![[r#"
                TOML parse error at line 1, column 1
                  |
                1 | [[expect.at]]
                  | ^^^^^^^^^^^^^
                missing field `t`"#]],
        );
    }

    #[test]
    fn an_expectation_that_compares_nothing_is_an_error_at_its_place() {
        let lists = ["screen", "print", "log", "popup", "at", "within", "order", "time", "speed", "inside", "clear"];
        let lists = lists.map(|key| format!("[expect]\n{key} = []"));
        let tables = ["io", "data", "sent", "seen", "held", "placed"].map(|key| format!("[expect]\n{key} = {{}}"));
        let timed = ["screen = []", "io = {}", "data = {}", "seen = []", "held = {}", "placed = {}"];
        let timed = timed.map(|key| format!("[[expect.at]]\nt = 0\n{key}"));
        let others = [
            "[expect]\nscreen = [\"a\", \"\"]",
            "[[expect.order]]\nevents = []",
            "[[expect.order]]\nevents = [{ screen = \"\" }]",
            "[[expect.within]]\nseconds = 1\nevent = { io = {} }",
            "[[expect.time]]\nbelow = 1\nto = { data = {} }",
        ];
        let others = others.map(str::to_owned);
        for text in lists.into_iter().chain(tables).chain(timed).chain(others) {
            let error = Scenario::parse("tests/a.toml", &text).unwrap_err().to_string();
            assert!(error.starts_with("TOML parse error at line "), "{text}: {error}");
            let reasons = ["compares nothing", "every page contains the empty text", "a condition needs"];
            assert!(reasons.iter().any(|reason| error.contains(reason)), "{text}: {error}");
        }
        check_error(
            "[expect]\nerrors = []\nscreen = []",
            expect![[r#"
            TOML parse error at line 3, column 10
              |
            3 | screen = []
              |          ^^
            this compares nothing, so it always holds: write what is expected, or remove it"#]],
        );
        check_error(
            "[[expect.order]]\nevents = [{ screen = \"\" }]",
            expect![[r#"
            TOML parse error at line 2, column 11
              |
            2 | events = [{ screen = "" }]
              |           ^^^^^^^^^^^^^^^
            every page contains the empty text, so this always holds: write a text of the page"#]],
        );
        assert!(Scenario::parse("", "[expect]\nerrors = []\nprint = [\"\"]").is_ok());
    }

    #[test]
    fn places_of_parts_and_states_at_times_can_be_in_one_file() {
        let places = "{ \"carton[0]\" = { is = [1, 2, 3] } }";
        let text = format!("[expect]\nplaced = {places}\n[[expect.at]]\nt = 1\nplaced = {places}");
        assert!(Scenario::parse("", &text).is_ok());
        check_error(
            &format!("[expect]\nat = {places}"),
            expect![[r#"
            TOML parse error at line 2, column 6
              |
            2 | at = { "carton[0]" = { is = [1, 2, 3] } }
              |      ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
            invalid type: map, expected tables `[[expect.at]]`, each with a time `t`; the places of parts are in `placed`"#]],
        );
        check_error(
            &format!("[[expect.at]]\nt = 1\nat = {places}"),
            expect![[r#"
            TOML parse error at line 3, column 1
              |
            3 | at = { "carton[0]" = { is = [1, 2, 3] } }
              | ^^
            unknown field `at`, expected one of `t`, `screen`, `io`, `data`, `seen`, `held`, `placed`"#]],
        );
    }
}
