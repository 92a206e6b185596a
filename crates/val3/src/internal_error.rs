//! Bug reports: one message per code location, on the standard error output.

use std::collections::BTreeSet;
use std::process::ExitCode;
use std::sync::{Mutex, PoisonError};

use val3_syntax::{Bug, set_bug_hook};

use crate::output::to_stderr;
use crate::user_error::EXIT_USAGE;

/// Reported locations of the source code: file, line, column. A report in a loop is written once.
static REPORTED: Mutex<BTreeSet<(&str, u32, u32)>> = Mutex::new(BTreeSet::new());

/// Connects the hook of [`val3_syntax::never`] with standard error, which editors show in the log of the server.
pub(crate) fn connect() {
    set_bug_hook(report);
}

/// Returns the exit code of a command: 2 after a bug report, because the result may be wrong and must not count as
/// clean.
pub(crate) fn exit_code(code: ExitCode) -> ExitCode {
    let has_reported = !REPORTED.lock().unwrap_or_else(PoisonError::into_inner).is_empty();
    if has_reported { ExitCode::from(EXIT_USAGE) } else { code }
}

fn report(bug: &Bug<'_>) {
    let location = (bug.location.file(), bug.location.line(), bug.location.column());
    if REPORTED.lock().unwrap_or_else(PoisonError::into_inner).insert(location) {
        to_stderr(|out| writeln!(out, "{bug}"));
    }
}

#[cfg(test)]
mod tests {
    use std::panic::Location;

    use super::*;

    #[test]
    fn a_command_with_a_bug_does_not_succeed() {
        let code = || format!("{:?}", exit_code(ExitCode::SUCCESS));
        assert_eq!(code(), format!("{:?}", ExitCode::SUCCESS));
        report(&Bug { location: Location::caller(), message: format_args!("a test") });
        assert_eq!(code(), format!("{:?}", ExitCode::from(2)));
    }
}
