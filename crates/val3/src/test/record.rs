//! `--record`: creates a scenario from an event record.
//!
//! External input becomes `[[at]]`, and the effects of the run become `[expect]`. To make sure that the scenario
//! passes, it is executed before it is written, and an expectation that the execution does not meet becomes a comment.

mod draft;
mod run_record;
mod served;
mod toml_text;
mod trial;

use std::fs;
use std::process::ExitCode;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::paths::normalise;
use val3_analysis::system::Disk;
use val3_files::{FileClass, replace};
use val3_lang::test_names::TESTS;
use val3_session::Application;

use self::draft::{Draft, NOTHING_EXPECTED};
use self::run_record::RunRecord;
pub(crate) use self::served::{ServedRun, record_served};
use self::trial::ScenarioTrial;
use super::cell::check_project;
use crate::args::{ControllerArgs, TestArgs};
use crate::output::to_stderr;
use crate::paths::{Paths, current_folder, relative};
use crate::user_error::UserError;

/// Maximum number of executions until the scenario passes.
const TRIALS: usize = 4;

/// Scenario to be written.
struct NewScenario<'r> {
    run: &'r RunRecord,
    /// First line of the file, a comment.
    heading: String,
    manifest: &'r Utf8Path,
    /// Absolute path of the scenario.
    path: &'r Utf8Path,
    /// Path of the scenario in messages.
    shown: &'r Utf8Path,
    controller: ControllerArgs,
}

/// Scenario that was written.
#[derive(Debug)]
struct WrittenScenario {
    text: String,
    /// Differences from the run: input that is not repeated, and output that is not expected.
    remarks: Vec<String>,
}

/// Writes a scenario from the event record in the file `record`.
///
/// # Errors
/// A file cannot be read or written, a scenario with this name exists, or a scenario cannot repeat the run.
pub(super) fn run(args: &TestArgs, record: &Utf8Path, to: Option<&Utf8Path>) -> Result<ExitCode, UserError> {
    let usage = "val3 test --record run.jsonl --to tests/twoBoxes.toml usr/usrapp/palletiser";
    let ([application], Some(to)) = (args.paths.as_slice(), to) else {
        return Err(UserError::new("--record needs --to and one application").with_help(usage));
    };
    let current = current_folder()?;
    let shown = Paths::new(&[], &current);
    let path = normalise(&current.join(to));
    check_new(&path, to)?;
    let text =
        val3_files::read_text(record, FileClass::Record).map_err(|error| unusable(record, &error.to_string()))?;
    let run = RunRecord::read(&text).map_err(|reason| unusable(record, &reason))?;
    let manifest = manifest(&current.join(application))?;
    let heading = format!("Recorded from {}", record.file_name().unwrap_or_default());
    let controller = args.controller.clone();
    let new = NewScenario { run: &run, heading, manifest: &manifest, path: &path, shown: to, controller };
    for remark in new.write()?.remarks {
        to_stderr(|out| writeln!(out, "note: {remark}; the scenario has a comment about it"));
    }
    if !path.ancestors().skip(1).any(|folder| folder.file_name() == Some(TESTS)) {
        to_stderr(|out| {
            writeln!(out, "note: `val3 test` finds scenarios in folders `{TESTS}` only, unless they are named")
        });
    }
    to_stderr(|out| writeln!(out, "wrote {}", shown.shown(&path)));
    to_stderr(|out| writeln!(out, "execute it: val3 test {}", shown.shown(&path)));
    Ok(ExitCode::SUCCESS)
}

impl NewScenario<'_> {
    /// Writes the scenario after it has passed in an execution.
    ///
    /// # Errors
    /// The application is outside of the cell, the scenario cannot repeat the run, or the file cannot be written.
    fn write(self) -> Result<WrittenScenario, UserError> {
        let Self { run, heading, manifest, path, shown, controller } = self;
        let folder = path.parent().unwrap_or(path);
        check_project(folder, manifest, "application")?;
        let application = relative(folder, manifest.parent().unwrap_or(manifest));
        let draft = Draft::new(&heading, &application, run, controller.with(&run.controller_keys()));
        let draft = tried(draft, &ScenarioTrial { manifest, path })?;
        let text = draft.text();
        fs::create_dir_all(folder).map_err(|error| refused(shown, &error.to_string()))?;
        replace(path, text.as_bytes()).map_err(|error| refused(shown, &error.to_string()))?;
        let nothing = draft.expects_nothing().then(|| NOTHING_EXPECTED.to_owned());
        Ok(WrittenScenario { text, remarks: draft.remarks().iter().cloned().chain(nothing).collect() })
    }
}

/// Executes the scenario until it passes. Expectations that an execution does not meet become comments.
fn tried<'r>(mut draft: Draft<'r>, trial: &ScenarioTrial<'_>) -> Result<Draft<'r>, UserError> {
    draft.add_outputs(&trial.opened()?.controller);
    for number in 0..TRIALS {
        let outcome = trial.execute(draft.text())?;
        let is_met = outcome.failures.is_empty();
        let other = draft.comment_out(&outcome.failures);
        if let Some(failure) = other {
            return Err(UserError::new("a scenario cannot repeat this run, so none is written")
                .with_details(failure.message.clone())
                .with_help("the application may differ from the one of the run, or a line may have had another end"));
        }
        match number {
            // If the execution differs from the run, the run may have shown another page.
            0 if is_met => draft.add_screen(&outcome.screen),
            0 => draft.remark("the page at the end is left out, because the execution differs from the run".to_owned()),
            _ if is_met => return Ok(draft),
            _ => {}
        }
    }
    Err(UserError::new("the scenario gives another result each time, so none is written")
        .with_help("lines with a peer outside of the test make runs differ"))
}

/// Checks that a scenario can be written to this path.
fn check_new(path: &Utf8Path, to: &Utf8Path) -> Result<(), UserError> {
    if path.extension() != Some("toml") {
        return Err(refused(to, "the file of a scenario ends with `.toml`"));
    }
    match path.symlink_metadata() {
        Ok(_) => Err(refused(to, "it exists, and is not replaced").with_help("name another file, or remove this one")),
        Err(_) => Ok(()),
    }
}

/// Project file of the application.
fn manifest(path: &Utf8Path) -> Result<Utf8PathBuf, UserError> {
    let application = Application::open(&Disk, path, None)?;
    Ok(normalise(application.project().manifest(application.db()).path(application.db())))
}

fn unusable(record: &Utf8Path, reason: &str) -> UserError {
    UserError::new(format!("cannot record a scenario from `{record}`: {reason}"))
        .with_help("name a file that `val3 run --events` has written")
}

fn refused(to: &Utf8Path, reason: &str) -> UserError {
    UserError::new(format!("cannot write the scenario `{to}`: {reason}"))
}
