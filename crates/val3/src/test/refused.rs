//! Tests that cannot be executed, because their application cannot be loaded or compiled, or their scenario is invalid.
//! They are reported as failures among the other results.

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::db::Database;
use val3_analysis::items::project::program_files;
use val3_check::diagnostic::Diagnostic;
use val3_lang::test_names::is_test;
use val3_lines::LineIndex;
use val3_session::Application;
use val3_suite::{Failure, FailureLocation, TestCase, TestKind, TestResult};

use super::judged;
use super::tested::FinishedTest;
use crate::user_error::UserError;

/// Test name of the failure that represents all of an application's tests.
const ALL: &str = "(all tests)";

/// Maximum number of compiler findings that become failures. Further findings are mostly consequences.
const SHOWN: usize = 10;

/// Reason why an application's tests cannot be executed.
#[derive(Debug)]
pub(super) struct Refusal {
    error: UserError,
    /// Findings of the compiler.
    findings: Vec<Failure>,
    /// Names of the test programs; empty if the application cannot be loaded.
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
    /// Creates the reason for an application that can be loaded.
    pub(super) fn new(error: UserError, findings: &[Diagnostic], application: &Application) -> Self {
        let (db, project) = (application.db(), application.project());
        let stems = program_files(db, project).iter().filter_map(|file| file.path(db).file_stem());
        let programs = stems.filter(|name| is_test(name)).map(str::to_owned).collect();
        let findings = findings.iter().take(SHOWN).map(|finding| failure(db, finding)).collect();
        Self { error, findings, programs }
    }
}

/// Converts a compiler finding to a failure.
fn failure(db: &Database, finding: &Diagnostic) -> Failure {
    let file = finding.place.file;
    let line = LineIndex::new(file.text(db)).line(finding.place.range.start().into()) + 1;
    let line = u32::try_from(line).unwrap_or(u32::MAX);
    let place =
        FailureLocation { program: finding.rule.code.to_owned(), file: file.path(db).as_str().to_owned(), line };
    Failure { message: finding.message.clone(), places: vec![place] }
}

/// Tests in an application that cannot be tested, or an invalid scenario.
#[derive(Debug)]
pub(super) struct RefusedTests {
    /// Project file of the application, or scenario file.
    pub(super) path: Utf8PathBuf,
    /// Test case of the failure that represents them.
    case: TestCase,
    refusal: Refusal,
}

impl RefusedTests {
    /// Represents all of an application's tests.
    pub(super) fn of_application(manifest: &Utf8Path, refusal: Refusal) -> Self {
        let application = manifest.parent().and_then(Utf8Path::file_name).unwrap_or_default();
        let case = TestCase { kind: TestKind::Program, ..TestCase::scenario(application, ALL, manifest.as_str()) };
        Self { path: manifest.to_owned(), case, refusal }
    }

    /// Represents an invalid scenario.
    pub(super) fn of_scenario(path: &Utf8Path, error: UserError) -> Self {
        let folder = path.parent().and_then(Utf8Path::file_name).unwrap_or_default();
        let case = TestCase::scenario(folder, path.file_stem().unwrap_or_default(), path.as_str());
        Self { path: path.to_owned(), case, refusal: error.into() }
    }

    /// Project file of the application, or scenario file, and the test case.
    pub(super) fn case_mut(&mut self) -> (Utf8PathBuf, &mut TestCase) {
        (self.path.clone(), &mut self.case)
    }

    /// Whether one of the tests is selected. If their names are unknown, all tests count as selected.
    pub(super) fn has(&self, is_chosen: impl Fn(&TestCase) -> bool) -> bool {
        let is_named = |program: &String| is_chosen(&TestCase { program: program.clone(), ..self.case.clone() });
        match self.case.kind {
            TestKind::Scenario => is_chosen(&self.case),
            TestKind::Program => self.refusal.programs.is_empty() || self.refusal.programs.iter().any(is_named),
        }
    }

    /// Converts the tests to a failure.
    pub(super) fn into_tested(self) -> FinishedTest {
        let Self { case, refusal: Refusal { error, mut findings, .. }, .. } = self;
        let place = FailureLocation { program: case.program.clone(), file: case.file.clone(), line: case.line };
        findings.insert(0, Failure { message: error.lines(), places: vec![place] });
        let result = TestResult { failures: findings, ..TestResult::default() };
        FinishedTest { is_executed: false, ..FinishedTest::of(&case, result) }
    }
}

impl FinishedTest {
    /// Creates a failed test for an invalid script.
    pub(super) fn unusable(case: &TestCase, error: &UserError) -> Self {
        let result = TestResult { failures: vec![judged::failure(case, error)], ..TestResult::default() };
        Self { is_executed: false, ..Self::of(case, result) }
    }
}
