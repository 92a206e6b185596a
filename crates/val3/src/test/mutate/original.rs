//! Tests without a mistake: executed lines, duration and final state of each test.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::Ordering;
use std::time::Instant;

use val3_coverage::{Coverage, ProgramCoverage};
use val3_lang::ports::Time;
use val3_suite::FinalState;

use super::executor::{Conditions, Execution, Executor};
use super::used_names::UsedNames;
use crate::args::TestFormat;
use crate::printable::one_line;
use crate::progress::DelayedProgress;
use crate::test::discovery::TestFile;
use crate::test::results::{EarlyEnd, Results};
use crate::test::tested::FinishedTest;

/// Factor by which a test may be slower with a mistake.
const SLOWNESS: Time = 10;

/// Minimum timeout of a test with a mistake, in nanoseconds.
const LEAST: Time = 100_000_000;

/// Tests without a mistake.
pub(super) struct Originals<'t> {
    /// Passed tests.
    pub(super) tests: Vec<Original<'t>>,
    /// Joint coverage of these tests.
    pub(super) coverage: Coverage,
}

/// Test without a mistake.
pub(super) struct Original<'t> {
    pub(super) test: TestFile<'t>,
    /// Timeout for its programs with a mistake, in nanoseconds.
    pub(super) limit: Time,
    pub(super) state: FinalState,
    /// Variables that the test uses.
    pub(super) used: UsedNames,
    /// Lines that the test executes, by file.
    lines: BTreeMap<String, BTreeSet<u32>>,
}

impl Original<'_> {
    /// Whether the test executes a line of a file.
    pub(super) fn executes(&self, file: &str, line: u32) -> bool {
        self.lines.get(file).is_some_and(|lines| lines.contains(&line))
    }

    /// Displayed name of the test.
    pub(super) fn name(&self) -> String {
        one_line(&self.test.case.shown_name()).into_owned()
    }
}

/// Executes tests with the original programs. Returns the passed tests and all results. Skipped tests and tests with a
/// known failure find no mistakes.
pub(super) fn originals<'t>(conditions: Conditions<'_>, tests: &[TestFile<'t>]) -> (Originals<'t>, Results) {
    let start = Instant::now();
    let bar = DelayedProgress::new("testing", tests.len(), conditions.args.format == TestFormat::Human);
    let mut executor = Executor::counting(conditions);
    let mut all = Originals { tests: Vec::new(), coverage: Coverage::default() };
    let mut tested = Vec::new();
    for test in tests {
        if conditions.is_interrupted.load(Ordering::Relaxed) {
            break;
        }
        bar.name(one_line(&test.case.shown_name()).into_owned());
        let begun = Instant::now();
        match executor.execute(test, None) {
            Ok(Some(execution)) => {
                let result = execution.result.clone();
                if result.has_passed() && result.exemption.is_none() {
                    all.coverage.merge(execution.coverage.clone());
                    all.tests.push(original(*test, execution));
                }
                tested.push(FinishedTest { wall: begun.elapsed(), ..FinishedTest::of(test.case, result) });
            }
            Ok(None) => break,
            Err(error) => tested.push(FinishedTest::unusable(test.case, &error)),
        }
        bar.advance();
    }
    let not_run = tests.iter().skip(tested.len()).map(|test| test.case.clone()).collect();
    let early_end = conditions.surroundings.signals.exit_code().map(EarlyEnd::Signal);
    (all, Results { tested, not_run, early_end, wall: start.elapsed() })
}

fn original(test: TestFile<'_>, execution: Execution) -> Original<'_> {
    let Execution { result, state, coverage, used, limit } = execution;
    let lines = coverage.programs().map(|(file, program)| (file.to_owned(), executed_lines(program))).collect();
    let limit = result.duration.saturating_mul(SLOWNESS).max(LEAST).min(limit);
    Original { test, limit, state, used, lines }
}

fn executed_lines(program: &ProgramCoverage) -> BTreeSet<u32> {
    program.lines.iter().filter(|(_, hits)| **hits > 0).map(|(line, _)| *line).collect()
}
