//! Tests with their results.

use std::time::Duration;

use val3_suite::{Exemption, Failure, FailureLocation, TestCase, TestResult};

use super::recorded_file::RecordedFile;
use super::source_line::source_line;
use crate::paths::Paths;

/// A test with its result.
pub(super) struct FinishedTest {
    pub(super) case: TestCase,
    pub(super) result: TestResult,
    /// Recorded motion and texts that `--update` has written.
    pub(super) recorded: Vec<RecordedFile>,
    /// Whether the test could be executed.
    pub(super) is_executed: bool,
    /// Real duration of the test.
    pub(super) wall: Duration,
    /// Results of earlier attempts, all failed; only with `--retries`.
    pub(super) earlier: Vec<TestResult>,
}

impl FinishedTest {
    /// Creates an executed test with its result.
    pub(super) fn of(case: &TestCase, result: TestResult) -> Self {
        let (recorded, earlier) = (Vec::new(), Vec::new());
        Self { case: case.clone(), result, recorded, is_executed: true, wall: Duration::ZERO, earlier }
    }

    /// Number of executions.
    pub(super) fn attempts(&self) -> usize {
        self.earlier.len() + 1
    }

    /// Whether the test has only passed in a retry.
    pub(super) fn is_flaky(&self) -> bool {
        !self.earlier.is_empty() && self.result.has_passed()
    }
}

/// Lines that describe a test's failures and its row's values.
pub(super) fn described(result: &TestResult, paths: &Paths) -> Vec<String> {
    let known = result.exemption.iter().flat_map(|exemption| match exemption {
        Exemption::Skipped { .. } => vec![exemption.label()],
        Exemption::KnownFailure { failures, .. } => {
            let failures = failures.iter().flat_map(|failure| failure.message.lines()).map(str::to_owned);
            [exemption.label()].into_iter().chain(failures).collect()
        }
    });
    let failures = result.failures.iter().flat_map(|failure| lines(failure, paths));
    let failures = known.chain(failures);
    failures.chain(row(result).filter(|_| !result.has_passed())).collect()
}

/// Lines that describe a failure: its message, the source line, and the call stack.
pub(super) fn lines(failure: &Failure, paths: &Paths) -> Vec<String> {
    let mut lines: Vec<String> = failure.message.lines().map(str::to_owned).collect();
    for (number, one) in failure.places.iter().enumerate() {
        lines.push(location(one, paths));
        let code = (number == 0).then(|| source_line(one)).flatten();
        let code = code.filter(|code| !failure.message.contains(code.as_str()));
        lines.extend(code.map(|code| format!("{:>5} │ {code}", one.line)));
    }
    lines
}

/// Line of a call stack; without a file, the program is named only.
fn location(FailureLocation { program, file, line, .. }: &FailureLocation, paths: &Paths) -> String {
    match file.as_str() {
        "" => format!("at {program}:{line}"),
        file => format!("at {program} ({}:{line})", paths.shown(file.into())),
    }
}

/// Line with the values of a test's row.
fn row(result: &TestResult) -> Option<String> {
    let values: Vec<String> = result.row.iter().map(|(column, value)| format!("{column} = {value}")).collect();
    (!values.is_empty()).then(|| format!("row: {}", values.join(", ")))
}

#[cfg(test)]
pub(super) mod examples {
    use val3_suite::{TestKind, TestResult};

    use super::*;

    /// A test of which two attempts have failed and the third has passed.
    pub(crate) fn flaky() -> FinishedTest {
        let case = TestCase {
            kind: TestKind::Program,
            application: "pal".to_owned(),
            program: "testHost".to_owned(),
            file: String::new(),
            line: 3,
            row: None,
            application_path: None,
            scenario_path: None,
            columns: Vec::new(),
            refusal: None,
        };
        let earlier = vec![failed("no <answer>"), failed("it was late")];
        FinishedTest { earlier, ..FinishedTest::of(&case, TestResult::default()) }
    }

    fn failed(message: &str) -> TestResult {
        let failure = Failure { message: message.to_owned(), places: Vec::new() };
        TestResult { failures: vec![failure], ..TestResult::default() }
    }
}
