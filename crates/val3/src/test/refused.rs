//! Tests that cannot be executed: those of an application that cannot be read or that the compiler refuses, and scenarios at
//! fault. They are failures among the results of the others.

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::db::Database;
use val3_analysis::items::project::program_files;
use val3_check::diagnostic::Diagnostic;
use val3_lang::test_names::is_test;
use val3_lines::LineIndex;
use val3_session::Application;
use val3_suite::{Failure, Place, TestCase, TestKind, TestResult};

use super::tested::Tested;
use crate::user_error::UserError;

/// The name of the failure that stands for all tests of an application.
const ALL: &str = "(all tests)";

/// Findings of the compiler that become failures. Further ones mostly follow from these.
const SHOWN: usize = 10;

/// The reason why the tests of an application cannot be executed.
#[derive(Debug)]
pub(super) struct Refusal {
    error: UserError,
    /// The findings of the compiler.
    findings: Vec<Failure>,
    /// The names of its test programs; none if the application cannot be read.
    programs: Vec<String>,
}

impl From<UserError> for Refusal {
    fn from(error: UserError) -> Self {
        Self { error, findings: Vec::new(), programs: Vec::new() }
    }
}

impl From<Refusal> for UserError {
    fn from(refusal: Refusal) -> Self {
        refusal.error
    }
}

impl From<RefusedTests> for UserError {
    fn from(tests: RefusedTests) -> Self {
        tests.refusal.error
    }
}

impl Refusal {
    /// The refusal of an application that can be read.
    pub(super) fn new(error: UserError, findings: &[Diagnostic], application: &Application) -> Self {
        let (db, project) = (application.db(), application.project());
        let stems = program_files(db, project).iter().filter_map(|file| file.path(db).file_stem());
        let programs = stems.filter(|name| is_test(name)).map(str::to_owned).collect();
        let findings = findings.iter().take(SHOWN).map(|finding| failure(db, finding)).collect();
        Self { error, findings, programs }
    }
}

/// A finding of the compiler as a failure.
fn failure(db: &Database, finding: &Diagnostic) -> Failure {
    let file = finding.place.file;
    let line = LineIndex::new(file.text(db)).line(finding.place.range.start().into()) + 1;
    let line = u32::try_from(line).unwrap_or(u32::MAX);
    let place = Place { program: finding.rule.code.to_owned(), file: file.path(db).as_str().to_owned(), line };
    Failure { message: finding.message.clone(), places: vec![place] }
}

/// The tests of an application that cannot be executed, or a scenario that cannot.
#[derive(Debug)]
pub(super) struct RefusedTests {
    /// The project file of the application, or the file of the scenario.
    pub(super) path: Utf8PathBuf,
    /// The failure that stands for them.
    case: TestCase,
    refusal: Refusal,
}

impl RefusedTests {
    /// All tests of an application.
    pub(super) fn of_application(manifest: &Utf8Path, refusal: Refusal) -> Self {
        let application = manifest.parent().and_then(Utf8Path::file_name).unwrap_or_default();
        let case = TestCase { kind: TestKind::Program, ..TestCase::scenario(application, ALL, manifest.as_str()) };
        Self { path: manifest.to_owned(), case, refusal }
    }

    /// A scenario.
    pub(super) fn of_scenario(path: &Utf8Path, error: UserError) -> Self {
        let folder = path.parent().and_then(Utf8Path::file_name).unwrap_or_default();
        let case = TestCase::scenario(folder, path.file_stem().unwrap_or_default(), path.as_str());
        Self { path: path.to_owned(), case, refusal: error.into() }
    }

    /// The project file of the application, or the file of the scenario, and the failure that stands for the tests.
    pub(super) fn case_mut(&mut self) -> (Utf8PathBuf, &mut TestCase) {
        (self.path.clone(), &mut self.case)
    }

    /// Whether one of the tests is chosen. All of them count where their names are not known.
    pub(super) fn has(&self, is_chosen: impl Fn(&TestCase) -> bool) -> bool {
        let is_named = |program: &String| is_chosen(&TestCase { program: program.clone(), ..self.case.clone() });
        match self.case.kind {
            TestKind::Scenario => is_chosen(&self.case),
            TestKind::Program => self.refusal.programs.is_empty() || self.refusal.programs.iter().any(is_named),
        }
    }

    /// The failures that stand for the tests.
    pub(super) fn into_tested(self) -> Tested {
        let Self { case, refusal: Refusal { error, mut findings, .. }, .. } = self;
        let place = Place { program: case.program.clone(), file: case.file.clone(), line: case.line };
        findings.insert(0, Failure { message: error.lines(), places: vec![place] });
        let result = TestResult { failures: findings, ..TestResult::default() };
        Tested { is_executed: false, ..Tested::of(&case, result) }
    }
}

impl Tested {
    /// A test whose script cannot be used.
    pub(super) fn unusable(case: &TestCase, error: &UserError) -> Self {
        let place = Place { program: case.program_name(), file: case.file.clone(), line: case.line };
        let failure = Failure { message: error.lines(), places: vec![place] };
        let result = TestResult { failures: vec![failure], ..TestResult::default() };
        Self { is_executed: false, ..Self::of(case, result) }
    }
}
