//! `val3 test`: executes the tests of applications, each on its own controller in virtual time.

mod asked;
mod cell;
mod coverage;
mod debugging;
mod discovery;
mod distinct;
mod events;
mod github;
mod golden;
mod golden_texts;
mod html;
mod human;
mod identifiers;
mod init;
mod json;
mod json_lines;
mod judged;
mod junit;
mod mutate;
mod new_test;
mod order;
mod previous;
mod record;
mod recorded_file;
mod refused;
mod results;
mod scenarios;
mod script_file;
mod selection;
mod source_line;
mod tap;
mod tested;
mod workers;

use std::collections::BTreeSet;
use std::io;
use std::iter;
use std::ops::ControlFlow;
use std::process::ExitCode;
use std::rc::Rc;

use camino::{Utf8Path, Utf8PathBuf};
use codespan_reporting::term::termcolor::WriteColor;
use val3_suite::TestKind;

use crate::args::{ReportOutput, TestArgs, TestFormat};
use crate::color::Color;
use crate::opening::repository;
use crate::output::{
    Destination, OutputContent, clear_screen, filtered, to_file, to_reader, to_stderr, to_stdout, to_stdout_as,
};
use crate::paths::{Paths, current_folder};
use crate::printable::one_line;
use crate::progress;
use crate::signals::Signals;
use crate::sockets::{ClosedSockets, note_grants};
use crate::user_error::{EXIT_USAGE, UserError};
use crate::watch::FolderWatch;
pub(crate) use debugging::{DebuggedTest, open_test, report};
use discovery::{Listed, Suite, Suites, TestFile, chosen, suites};
use human::Listing;
use mutate::MutationRun;
pub(crate) use order::Shard;
pub(crate) use record::{ServedRun, record_served};
use refused::RefusedTests;
use results::{EarlyEnd, Results};
use tested::FinishedTest;
use workers::{Surroundings, TestEvent};

/// Runs the command.
pub(crate) fn run(args: &TestArgs, color: Color) -> Result<ExitCode, UserError> {
    if args.init {
        return init::run(&args.paths);
    }
    if let Some(name) = &args.new {
        return new_test::run(&args.paths, name, args.of.as_deref());
    }
    if let Some(events) = &args.record {
        return record::run(args, events, args.to.as_deref());
    }
    let current = current_folder()?;
    if args.watch { watched(args, &current, color) } else { once(args, &current, &Signals::catch()?, color) }
}

/// Executes the tests again whenever a cell file changes, until Ctrl-C.
fn watched(args: &TestArgs, current: &Utf8Path, color: Color) -> Result<ExitCode, UserError> {
    let asked: Vec<Utf8PathBuf> = args.paths.iter().map(|path| current.join(path)).collect();
    let mut watch = FolderWatch::start(&asked)?;
    let Suites { opened, refused } = suites(args, current)?;
    for tests in &refused {
        watch.include(tests.path.parent().unwrap_or(&tests.path), true)?;
    }
    for suite in opened {
        suite.folders().into_iter().try_for_each(|(folder, below)| watch.include(&folder, below))?;
    }
    loop {
        clear_screen();
        // A signal has its default effect, which ends the command.
        if let Err(error) = once(args, current, &Signals::default(), color) {
            to_stderr(|out| writeln!(out, "{error}"));
        }
        to_stderr(|out| writeln!(out, "Waiting for changes"));
        watch.changed()?;
    }
}

/// Executes the tests and writes their results.
fn once(args: &TestArgs, current: &Utf8Path, signals: &Signals, color: Color) -> Result<ExitCode, UserError> {
    let paths = Paths::new(&args.paths, current).within(repository(current));
    if args.list {
        return list(args, current, &paths, color);
    }
    let Suites { opened: suites, mut refused } = suites(args, current)?;
    let tests = chosen(args, &suites, &mut refused)?;
    note_unlisted(&suites, &paths);
    let repeated: Vec<TestFile<'_>> =
        tests.iter().flat_map(|test| iter::repeat_n(*test, args.repeat as usize)).collect();
    let bar = progress::DelayedProgress::new("testing", repeated.len(), args.format == TestFormat::Human);
    note_grants(&grants(args, &suites, &tests)?);
    let sockets = ClosedSockets::default();
    let surroundings = Surroundings { sockets: &sockets, signals };
    if args.mutate {
        drop(bar);
        let run = MutationRun { args, surroundings: &surroundings, paths: &paths, color };
        return mutate::run(&run, &tests, refused);
    }
    let mut display = Display { args, paths: &paths, color, listing: Listing::default() };
    display.listing.is_quiet = args.quiet;
    let mut observer = |progress: &TestEvent<'_>| display.observe(progress, &bar);
    let (mut results, counted) = workers::executed(args, &repeated, &surroundings, &mut observer)?;
    for tests in refused.into_iter().map(RefusedTests::into_tested) {
        // The reader may have closed the output. The exit code remains valid.
        let _ = observer(&TestEvent::Finished(&tests))?;
        let _ = observer(&TestEvent::Next(&tests))?;
        results.tested.push(tests);
    }
    drop(bar);
    golden::report(&results.tested, &paths);
    sockets.report();
    note_times(&results.tested);
    write_results(args, &results, &paths, color)?;
    let written = write_reports(args, &results, &paths);
    let is_covered = coverage::report(args, counted, &paths, color)?;
    written.map(|()| exit_code(&results, is_covered))
}

/// Lists the chosen tests without their execution.
fn list(args: &TestArgs, current: &Utf8Path, paths: &Paths, color: Color) -> Result<ExitCode, UserError> {
    if args.format == TestFormat::Json {
        let listed = Listed::all(args, current)?;
        to_stdout_as(OutputContent::Json, color, |out| json::list(&listed, paths, out))?;
        return Ok(ExitCode::SUCCESS);
    }
    let Suites { opened: suites, mut refused } = suites(args, current)?;
    let tests = chosen(args, &suites, &mut refused)?;
    note_unlisted(&suites, paths);
    to_stdout(color, |out| tests.iter().try_for_each(|test| writeln!(out, "{}", one_line(&test.case.shown_name()))))?;
    let is_complete = refused.is_empty();
    for error in refused.into_iter().map(UserError::from) {
        to_stderr(|out| writeln!(out, "{error}"));
    }
    Ok(if is_complete { ExitCode::SUCCESS } else { ExitCode::from(EXIT_USAGE) })
}

/// Writes the results, or their summary in formats whose lines are written during the execution.
fn write_results(args: &TestArgs, results: &Results, paths: &Paths, color: Color) -> Result<(), UserError> {
    to_stdout_as(args.format.content(), color, |out| match args.format {
        TestFormat::Human => {
            human::slowest(results, args.durations as usize, out).and_then(|()| human::summary(results, paths, out))
        }
        TestFormat::JsonLines => json_lines::summary(results, paths, out),
        format => write(format, results, paths, out),
    })?;
    if args.format == TestFormat::Human {
        to_stderr(|out| writeln!(out, "finished in {:.2} s", results.wall.as_secs_f64()));
    }
    Ok(())
}

/// Writes the report files.
///
/// # Errors
/// A file cannot be written. All other files are written in this case.
fn write_reports(args: &TestArgs, results: &Results, paths: &Paths) -> Result<(), UserError> {
    let written = args.output.iter().map(|ReportOutput { format, path }| {
        to_file(path, format.file_kind(), |out| {
            filtered(format.content(), Destination::FILE, out, |out| write(*format, results, paths, out))
        })
    });
    written.collect::<Vec<_>>().into_iter().collect()
}

/// Exit code of a run. A signal has precedence over results.
fn exit_code(results: &Results, is_covered: bool) -> ExitCode {
    let all = |is_good: fn(&FinishedTest) -> bool| results.tested.iter().all(is_good);
    match results.early_end {
        Some(EarlyEnd::Signal(code)) => ExitCode::from(code),
        _ if !all(|test| test.is_executed) => ExitCode::from(EXIT_USAGE),
        _ if is_covered && all(|test| test.result.has_passed()) => ExitCode::SUCCESS,
        _ => ExitCode::FAILURE,
    }
}

/// Descriptions of external access granted to the tests' controllers, without duplicates.
fn grants(args: &TestArgs, suites: &[Suite], tests: &[TestFile<'_>]) -> Result<Vec<String>, UserError> {
    let settings = args.controller.settings(Rc::new(ClosedSockets::default()));
    let tested: BTreeSet<&Utf8Path> = tests.iter().map(|test| test.manifest).collect();
    let mut all = BTreeSet::new();
    for suite in suites.iter().filter(|suite| tested.contains(suite.manifest.as_path())) {
        all.extend(suite.application.grants(&settings)?);
    }
    Ok(all.into_iter().collect())
}

/// Warns about test programs that are not executed, because their projects do not list them.
fn note_unlisted(suites: &[Suite], paths: &Paths) {
    // Scenarios run applications whose programs are no tests.
    let of_tests = suites.iter().filter(|suite| suite.cases.iter().any(|case| case.kind == TestKind::Program));
    for (suite, path) in of_tests.flat_map(|suite| suite.unlisted_tests().into_iter().map(move |path| (suite, path))) {
        let (project, path) = (suite.manifest.file_name().unwrap_or_default(), paths.shown(path));
        to_stderr(|out| writeln!(out, "warning: `{path}` is not executed, because `{project}` does not list it"));
    }
}

/// Notes, once for each arm, that limits of cycle times were compared with model times.
fn note_times(tested: &[FinishedTest]) {
    let notes: BTreeSet<&str> = tested.iter().filter_map(|test| test.result.times_note.as_deref()).collect();
    to_stderr(|out| notes.iter().try_for_each(|note| writeln!(out, "note: {note}")));
}

/// Writes all results in a format.
fn write(format: TestFormat, results: &Results, paths: &Paths, out: &mut dyn WriteColor) -> io::Result<()> {
    match format {
        TestFormat::Human => human::write(results, false, paths, out),
        TestFormat::Html => html::write(results, paths, out),
        TestFormat::Json => json::write(results, paths, out),
        TestFormat::JsonLines => json_lines::document(results, paths, out),
        TestFormat::Junit => junit::write(results, paths, out),
        TestFormat::Tap => tap::write(results, paths, out),
        TestFormat::Github => github::write(results, paths, out),
    }
}

fn advance(bar: &progress::DelayedProgress, progress: &TestEvent<'_>) {
    match progress {
        TestEvent::Started(case) => bar.name(one_line(&case.shown_name()).into_owned()),
        TestEvent::Finished(_) => bar.advance(),
        TestEvent::Next(_) => {}
    }
}

/// Standard output during the execution.
struct Display<'d> {
    args: &'d TestArgs,
    paths: &'d Paths,
    color: Color,
    listing: Listing,
}

impl Display<'_> {
    /// Advances the progress bar, and shows the event.
    fn observe(
        &mut self,
        progress: &TestEvent<'_>,
        bar: &progress::DelayedProgress,
    ) -> Result<ControlFlow<()>, UserError> {
        advance(bar, progress);
        bar.pause(|| self.show(progress))
    }

    /// Shows an event, if the format has output during the execution.
    fn show(&mut self, progress: &TestEvent<'_>) -> Result<ControlFlow<()>, UserError> {
        let paths = self.paths;
        let is_read = match (self.args.format, progress) {
            (TestFormat::JsonLines, TestEvent::Started(_) | TestEvent::Finished(_)) => {
                to_reader(OutputContent::Json, Color::Never, |out| json_lines::write(progress, paths, out))?
            }
            // A closed output (`head`) affects neither the tests nor the report files.
            (TestFormat::Human, TestEvent::Next(tested)) => {
                to_reader(OutputContent::Words, self.color, |out| self.listing.add(tested, paths, out))?;
                true
            }
            _ => true,
        };
        Ok(if is_read { ControlFlow::Continue(()) } else { ControlFlow::Break(()) })
    }
}
