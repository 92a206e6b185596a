//! Subject of a message: application, task, program, line, run-time error.

use val3_lang::log_messages::{APPLICATION_STARTED, APPLICATION_STOPPED, COMPILE_ERROR, NOT_LOADED, RUNTIME_ERROR};

/// Subject of a message. Each field is `None` if the text does not contain it.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Subject {
    /// Name of the application.
    pub application: Option<String>,
    /// Name of the task.
    pub task: Option<String>,
    /// Name of the program.
    pub program: Option<String>,
    /// Line of the program's code, from 1 at `begin`.
    pub code_line: Option<usize>,
    /// Token that the compiler rejects.
    pub token: Option<String>,
    /// Number of the run-time error.
    pub error: Option<u16>,
}

impl Subject {
    /// Reads the text of a message.
    pub(super) fn of(code: Option<&str>, text: &str) -> Self {
        let has = |known: &str| code.is_some_and(|code| code.eq_ignore_ascii_case(known));
        if let Some(subject) = rejected_line(text) {
            return subject;
        }
        if has(APPLICATION_STARTED) || has(APPLICATION_STOPPED) {
            return Self { application: named_application(text), ..Self::default() };
        }
        if has(NOT_LOADED) {
            return Self { application: loaded_application(text), ..Self::default() };
        }
        if has(RUNTIME_ERROR) {
            return runtime_error(text);
        }
        Self::default()
    }
}

/// Returns the code that a text without a code has in later versions. s6 writes no codes.
pub(super) fn code_of_text(text: &str) -> Option<&'static str> {
    if rejected_line(text).is_some() {
        return Some(COMPILE_ERROR);
    }
    if text.strip_prefix("ERR ").is_some_and(|rest| rest.starts_with(|letter: char| letter.is_ascii_digit())) {
        return Some(RUNTIME_ERROR);
    }
    let endings = [(" application started", APPLICATION_STARTED), (" application stopped", APPLICATION_STOPPED)];
    endings.into_iter().find(|(ending, _)| text.trim_end().ends_with(ending)).map(|(_, code)| code)
}

/// Reads `(File start.pgx-line 5) 'pik' : undefined program`. A text without a token is possible.
fn rejected_line(text: &str) -> Option<Subject> {
    let (place, message) = text.strip_prefix("(File ")?.split_once(')')?;
    let (file, line) = place.rsplit_once("-line ")?;
    let program = file.rsplit_once('.').map_or(file, |(program, _)| program);
    let token = message.trim_start().strip_prefix('\'').and_then(|rest| rest.split_once("' :"));
    Some(Subject {
        program: Some(program.to_owned()),
        code_line: Some(line.trim().parse().ok()?),
        token: token.map(|(token, _)| token.to_owned()),
        ..Subject::default()
    })
}

/// Reads `Application 'demo' started.` (s8) or `demo application started` (s7).
fn named_application(text: &str) -> Option<String> {
    let quoted = text.strip_prefix("Application '").and_then(|rest| rest.rsplit_once('\''));
    let plain = || text.split_once(" application ");
    quoted.or_else(plain).map(|(name, _)| name.to_owned())
}

/// Reads `Cannot load application 'Disk://demo/demo.pjx' - …`.
fn loaded_application(text: &str) -> Option<String> {
    let path = text.split('\'').nth(1)?;
    let file = path.rsplit(['/', '\\']).next()?;
    Some(file.rsplit_once('.').map_or(file, |(name, _)| name).to_owned()).filter(|name| !name.is_empty())
}

/// Reads `ERR 123 IO not linked to a hardware input-output.. TASK. `, or the s8 text without a number.
fn runtime_error(text: &str) -> Subject {
    let error = text.strip_prefix("ERR ").and_then(|rest| rest.split_whitespace().next()?.parse().ok());
    let text = text.trim_end().trim_end_matches('.');
    let task = text.rsplit_once(". ").map(|(_, task)| task.to_owned()).filter(|task| !task.contains(' '));
    let application = task.as_deref().and_then(|task| task.strip_suffix('~')).map(str::to_owned);
    // The first task of the application `demo` is called `demo~` and executes `start`. A click on a user page starts the
    // program `clkReset` in a task such as `first.btnReset.click_clkReset`.
    let clicked = task.as_deref().and_then(|task| task.rsplit_once('.')?.1.split_once('_'));
    let program = clicked.map(|(_, program)| program.to_owned());
    Subject { application, task, program, error, ..Subject::default() }
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};

    use super::*;

    fn check(code: &str, text: &str, expected: Expect) {
        let Subject { application, task, program, code_line, token, error } = Subject::of(Some(code), text);
        let shown = [
            ("application", application),
            ("task", task),
            ("program", program),
            ("line", code_line.map(|line| line.to_string())),
            ("token", token),
            ("error", error.map(|error| error.to_string())),
        ];
        let shown = shown.into_iter().filter_map(|(name, value)| Some(format!("{name} {}", value?)));
        expected.assert_eq(&shown.collect::<Vec<_>>().join(", "));
    }

    #[test]
    fn a_rejected_line_has_program_line_and_token() {
        let text = "(File start.pgx-line 5) 'pik' : undefined program";
        check("0x5405", text, expect!["program start, line 5, token pik"]);
        let text = "(File a.b.pgx-line 12) '[nIdx,' : missing bracket ']'";
        check("0x5405", text, expect!["program a.b, line 12, token [nIdx,"]);
        check("0x5405", "(File x.pgx-line 8) Missing keyword : 'begin'", expect!["program x, line 8"]);
        check("0x5405", "(File x.pgx-line 99999999999999999999999) y", expect![""]);
    }

    #[test]
    fn applications_are_named_in_each_version() {
        check("0x5402", "Application 'demo' started.", expect!["application demo"]);
        check("0x5403", "demo application stopped", expect!["application demo"]);
        check("0x7807", "Cannot load application 'Disk://demo/demo.pjx' - error", expect!["application demo"]);
    }

    #[test]
    fn a_run_time_error_has_number_and_task() {
        let text = "ERR 123 IO not linked to a hardware input-output.. demo~. ";
        check("0x5404", text, expect!["application demo, task demo~, error 123"]);
        let text = "ERR 531 Cartesian position out of joint limits.. first.btn.click_clkPark. ";
        check("0x5404", text, expect!["task first.btn.click_clkPark, program clkPark, error 531"]);
        let text = "VAL3 runtime error. Orientation unreachable with this arm.. tServer. ";
        check("0x5404", text, expect!["task tServer"]);
        let text = "ERR 102 'decel' field in mdesc is negative, too high, or lower than 'vel' field. motion. ";
        check("0x5404", text, expect!["task motion, error 102"]);
    }
}
