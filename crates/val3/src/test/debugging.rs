//! Tests with a debug client.

use std::rc::Rc;

use serde_json::Value;
use val3_lang::suggest::{proposals, question};
use val3_machine::sio::SocketGuard;
use val3_suite::{Stages, TestCase, TestResult};

use super::discovery::{Opening, Suite, open};
use super::json;
use super::judged::judged;
use super::script_file::ScriptFile;
use super::tested::described;
use super::workers::Bench;
use crate::args::{EVENTS, RunArgs};
use crate::paths::{Paths, current_folder};
use crate::run::ReadyApplication;
use crate::sockets::Announcements;
use crate::user_error::UserError;
use val3_session::CodeForm;

/// Opens a test application, and starts a test's first program, as `val3 test` does.
///
/// # Errors
/// The application cannot be loaded, the compiler rejects it, or it has no such test.
pub(crate) fn open_test(args: &RunArgs, name: &str) -> Result<ReadyApplication, UserError> {
    let opening =
        Opening { controller: &args.controller, limit: None, form: CodeForm::Debugged, replace: None, edited: &[] };
    let suite = open(opening, &current_folder()?.join(&args.application))?;
    let case = find(&suite, name)?.clone();
    let announcements = Rc::new(Announcements::of_test());
    let file = ScriptFile::of(&case)?;
    let guard = Rc::clone(&announcements) as Rc<dyn SocketGuard>;
    let mut bench = Bench::open(opening, &suite.manifest, &file.keys, guard)?;
    bench.prepare(&file)?;
    let Bench { suite, mut controller, .. } = bench;
    if let Some(reason) = &case.refusal {
        return Err(UserError::new(format!("the test `{}` cannot be executed: {reason}", case.name())));
    }
    controller.outlive_tasks();
    let test = Stages::start(&mut controller, case, &file.scenario);
    Ok(ReadyApplication {
        controller,
        application: suite.application,
        test: Some(test),
        announcements,
        checked: None,
        options: None,
        _unpacked: None,
    })
}

/// Finds a test by name, with or without the application's name. For the name of a table, the first row is used.
fn find<'s>(suite: &'s Suite, name: &str) -> Result<&'s TestCase, UserError> {
    let whole = format!("{}:{name}", suite.image.name);
    let is_meant = |found: &str| found == name || found == whole;
    let by_name = suite.cases.iter().find(|case| is_meant(&case.name()));
    let by_program = || suite.cases.iter().find(|case| is_meant(&case.program_name()));
    by_name.or_else(by_program).ok_or_else(|| {
        let names: Vec<String> = suite.cases.iter().map(TestCase::name).collect();
        let help = question(proposals(&whole, names.iter().map(String::as_str)));
        let error = UserError::new(format!("`{}` has no test `{name}`", suite.manifest));
        help.into_iter().fold(error, UserError::with_help)
    })
}

/// Result of a debugged test.
pub(crate) struct DebuggedTest {
    pub(crate) has_passed: bool,
    /// Text for the user.
    pub(crate) text: String,
    /// JSON object for the client.
    pub(crate) object: Value,
}

/// Returns the result of a debugged test.
///
/// # Errors
/// The current folder is unknown.
pub(crate) fn report(case: &TestCase, result: TestResult) -> Result<DebuggedTest, UserError> {
    let paths = Paths::new(&[], &current_folder()?);
    let tested = judged(case, result, false, EVENTS);
    let name = tested.case.name();
    let text = match described(&tested.result, &paths).join("\n").as_str() {
        "" => format!("{name} has passed\n"),
        lines if tested.result.has_passed() => format!("{name}: {lines}\n"),
        lines => format!("{name} has failed\n{lines}\n"),
    };
    Ok(DebuggedTest { has_passed: tested.result.has_passed(), text, object: json::described(&tested, &paths) })
}
