//! Applications of listings on a controller that returns to its initial state before each test.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::sync::Arc;

use camino::Utf8PathBuf;
use tempfile::TempDir;
use val3_analysis::system::Disk;
use val3_bytecode::Image;
use val3_lang::ports::{SECOND, Time};
use val3_lang::types::Arm;
use val3_machine::controller::{Controller, Snapshot};
use val3_machine::event::shown_seconds;
use val3_session::{Application, CodeForm, ControllerSettings, LineCondition, Tape};
use val3_suite::{Failure, Scenario, Supervision, TestCase, TestResult, TestSettings, cases, execute, library};
use val3_test::Fixture;

/// Timeout of a test.
const LIMIT: Time = 60 * SECOND;

/// An application on a controller.
pub(crate) struct Bench {
    root: Utf8PathBuf,
    pub(crate) application: Application,
    pub(crate) image: Arc<Image>,
    pub(crate) controller: Controller,
    initial: Snapshot,
    /// Timeout of a test, in nanoseconds.
    pub(crate) limit: Time,
    /// Conditions that a task is said to wait for.
    pub(crate) conditions: Vec<LineCondition>,
    _folder: TempDir,
}

impl Bench {
    /// Opens the application with this name in a listing, with counters of lines and branches. `val3assert` is in the
    /// same folder.
    #[track_caller]
    pub(crate) fn open(listing: &str, name: &str) -> Self {
        let folder = TempDir::new().unwrap();
        let root = Utf8PathBuf::try_from(folder.path().canonicalize().unwrap()).unwrap();
        for (path, text) in Fixture::parse(listing).files {
            write(&root.join(path), &text);
        }
        for (file, text) in library::files(Arm::SixAxis) {
            write(&root.join("usrapp/val3assert").join(file), &text);
        }
        let manifest = root.join(format!("usrapp/{name}/{name}.pjx"));
        let application = Application::open_with_stand_ins(&Disk, &manifest, &BTreeMap::new()).unwrap();
        let refusals = application.refusals();
        assert!(refusals.is_empty(), "{refusals:?}");
        let image = application.compile_as(CodeForm::Counted).unwrap();
        let settings = ControllerSettings { form: CodeForm::Counted, ..ControllerSettings::default() };
        let mut controller = application.controller(&settings, Tape::default(), image.clone()).unwrap();
        let initial = controller.snapshot();
        Self { root, application, image, controller, initial, limit: LIMIT, conditions: Vec::new(), _folder: folder }
    }

    /// Executes a test from the initial state.
    #[track_caller]
    pub(crate) fn run(&mut self, case: &TestCase, scenario: &Scenario) -> TestResult {
        self.controller.begin_again(&self.initial);
        let faults = self.faults(scenario);
        assert!(faults.is_empty(), "{faults:?}");
        scenario.prepare(&mut self.controller);
        let conditions = self.conditions.clone();
        let supervision = Supervision {
            settings: TestSettings { limit: self.limit },
            may_go_on: &|| true,
            conditions: &mut |_, _| conditions.clone(),
        };
        execute(&mut self.controller, case, scenario, supervision).unwrap()
    }

    /// Returns the faults of a scenario for this application.
    pub(crate) fn faults(&self, scenario: &Scenario) -> Vec<String> {
        scenario.faults(&self.controller, &|_| false)
    }

    /// Executes the scenario `cell.toml` with this text.
    #[track_caller]
    pub(crate) fn scenario(&mut self, text: &str) -> TestResult {
        let scenario = Scenario::parse("cell.toml", text).unwrap();
        self.run(&TestCase::scenario("main", "cell", "cell.toml"), &scenario)
    }

    /// Returns the tests of the application.
    pub(crate) fn cases(&self) -> Vec<TestCase> {
        cases(&self.application, &self.image)
    }

    /// Executes the test with this title, next to a file with expectations.
    #[track_caller]
    pub(crate) fn test(&mut self, title: &str, expectations: &str) -> TestResult {
        let case = self.cases().into_iter().find(|case| case.title() == title).unwrap();
        self.run(&case, &Scenario::parse("test.toml", expectations).unwrap())
    }

    /// Executes all tests, and formats their results.
    #[track_caller]
    pub(crate) fn tests(&mut self) -> String {
        let mut text = String::new();
        for case in self.cases() {
            let result = self.run(&case, &Scenario::default());
            writeln!(text, "{}: {}", case.title(), self.shown(&result)).unwrap();
        }
        text
    }

    /// Formats a result: its duration, and each failure with its places.
    pub(crate) fn shown(&self, result: &TestResult) -> String {
        let failures: String = result.failures.iter().map(|failure| self.failure(failure)).collect();
        let state = result.exemption.as_ref().map_or_else(
            || if failures.is_empty() { "ok".to_owned() } else { "failed".to_owned() },
            val3_suite::Exemption::label,
        );
        format!("{state}, {} s{failures}", shown_seconds(result.duration))
    }

    fn failure(&self, failure: &Failure) -> String {
        let places = failure.places.iter().map(|place| {
            let file = place.file.strip_prefix(self.root.as_str()).unwrap_or(&place.file);
            format!("\n  at {} ({}:{})", place.program, file.trim_start_matches("/usrapp/"), place.line)
        });
        format!("\n{}{}", failure.message, places.collect::<String>())
    }
}

fn write(path: &Utf8PathBuf, text: &str) {
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, text).unwrap();
}
