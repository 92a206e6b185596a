//! Verdict on an executed test: its recorded files are compared, or recorded once more (`--update`).

use val3_suite::{Failure, FailureLocation, TestCase, TestResult};

use super::recorded_file::RecordedFile;
use super::tested::FinishedTest;
use super::{golden, golden_texts};
use crate::user_error::UserError;

/// Compares the motion and texts of a test with the files that its expectations name, or records them there, and keeps
/// at most `events` last events. A file that cannot be used is a failure of this test only, which no known failure
/// excuses.
pub(super) fn judged(case: &TestCase, mut result: TestResult, update: bool, events: u32) -> FinishedTest {
    let mut recorded = Vec::new();
    let unusable = judge(case, &mut result, update, &mut recorded).err();
    match &unusable {
        None => result.judge_known_failure(),
        Some(error) => result.failures.push(failure(case, error)),
    }
    result.keep_last_events(events as usize);
    FinishedTest { recorded, is_executed: unusable.is_none(), ..FinishedTest::of(case, result) }
}

fn judge(
    case: &TestCase,
    result: &mut TestResult,
    update: bool,
    recorded: &mut Vec<RecordedFile>,
) -> Result<(), UserError> {
    // Texts first: a motion is only recorded if the texts are correct.
    golden_texts::judge(case, result, update, recorded)?;
    recorded.extend(golden::judge(case, result, update)?);
    Ok(())
}

/// Failure of a test because of an error of its file.
pub(super) fn failure(case: &TestCase, error: &UserError) -> Failure {
    let place = FailureLocation { program: case.program_name(), file: case.file.clone(), line: case.line };
    Failure { message: error.lines(), places: vec![place] }
}
