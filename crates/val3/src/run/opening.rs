//! Opens an application for `val3 run`: from the arguments to a controller with the application in memory.

use std::io;
use std::rc::Rc;

use codespan_reporting::term::termcolor::WriteColor;
use val3_analysis::application::{START, STOP};
use val3_analysis::db::Project;
use val3_analysis::resizing::is_resized;
use val3_analysis::system::Disk;
use val3_compile::CompileError;
use val3_lang::suggest::{proposals, question};
use val3_machine::controller::{Controller, NotStarted};
use val3_machine::sio::SocketGuard;
use val3_session::{Application, CodeForm, ControllerSettings, Tape};
use val3_suite::{Scenario, Stages};

use super::outside;
use super::recorded_options::RecordedOptions;
use super::unpacked::Unpacked;
use crate::args::RunArgs;
use crate::engine::Session;
use crate::format::human;
use crate::opening::OpenRequest;
use crate::paths::{Paths, current_folder};
use crate::report::{Finding, FindingSeverity};
use crate::sockets::{AnnouncementReader, Announcements};
use crate::summary;
use crate::user_error::{EXIT_USAGE, UserError};

/// Exit code for an application that the controller's compiler rejects.
const EXIT_REFUSED: u8 = 1;

/// Result of opening an application.
pub(crate) enum OpenedApplication {
    /// The application is in memory.
    Ready(Box<ReadyApplication>),
    /// The application has faults, which were displayed.
    Faulty {
        /// Exit code of the command.
        code: u8,
        /// Errors of the check: file, line and message.
        errors: Vec<String>,
    },
}

/// An application in memory, with its database.
pub(crate) struct ReadyApplication {
    pub(crate) controller: Controller,
    pub(crate) application: Application,
    /// Debugged test.
    pub(crate) test: Option<Stages>,
    /// Options for the event record; `None` if a test is debugged.
    pub(crate) options: Option<RecordedOptions>,
    /// Announcements of sockets whose ports only the cell names.
    pub(crate) announcements: Rc<Announcements>,
    /// Note with the number of findings; `None` if a test is debugged.
    pub(crate) checked: Option<String>,
    /// Unpacked archive files.
    pub(crate) _unpacked: Option<Unpacked>,
}

/// Function that displays a text to the user.
pub(crate) type Show<'a> = &'a mut dyn FnMut(&dyn Fn(&mut dyn WriteColor) -> io::Result<()>);

/// Loads, checks and compiles the application. `reader` receives announcements of opened sockets.
pub(crate) fn open(args: &RunArgs, reader: AnnouncementReader, show: Show<'_>) -> Result<OpenedApplication, UserError> {
    let path = current_folder()?.join(&args.application);
    let unpacked = Unpacked::of(&path)?;
    let path = unpacked.as_ref().map_or(path, |unpacked| unpacked.path.clone());
    let mut application = Application::open(&Disk, &path, Some(&args.program))?;
    let script = args.script.as_deref().map(outside::read_script).transpose()?;
    let keys = script.as_ref().map(Scenario::controller_keys).cloned().unwrap_or_default();
    let chosen = args.controller.with(&keys);
    if let Some(name) = &chosen.arm {
        application.set_arm(name)?;
    }
    let project = application.project();
    let asked = if unpacked.is_some() { path } else { args.application.clone() };
    let request = OpenRequest { asked: vec![asked], ..OpenRequest::default() };
    let mut session = Session::with_workspace(&request, application.into_workspace())?;
    let checked = show_faults(&mut session, project, show)?;
    if let Some(code) = checked.refusal {
        return Ok(OpenedApplication::Faulty { code, errors: checked.errors });
    }
    let application = Application::of(session.into_workspace(), project);
    application.check_readable()?;
    let is_debugged =
        matches!(reader, AnnouncementReader::Debugger) || args.debug_port.is_some() || args.soap.is_some();
    let form = if is_debugged { CodeForm::Debugged } else { CodeForm::Plain };
    let image = match application.compile_as(form) {
        Ok(image) => image,
        Err(error) => {
            show_limit(&error, show)?;
            let errors = vec![format!("this controller cannot load the application: {}", error.limit)];
            return Ok(OpenedApplication::Faulty { code: EXIT_REFUSED, errors });
        }
    };
    let programs: Vec<String> = image.programs.iter().map(|program| program.name.clone()).collect();
    check_stop(&args.program, &programs)?;
    // A compared run's recording contains its lines' external input, so this run records it, too.
    let tape = Tape { records: args.events.is_some() || args.replay.is_some(), replays: args.replay.as_deref() };
    let announcements = Rc::new(Announcements::new(reader));
    let settings = chosen.settings(Rc::clone(&announcements) as Rc<dyn SocketGuard>);
    let settings = ControllerSettings { form, ..settings };
    let mut controller = application.controller(&settings, tape, image)?;
    for grant in application.grants(&settings)? {
        show(&|out| writeln!(out, "note: {grant}"));
    }
    if let Some((message, help)) = application.missing_io_library() {
        show(&|out| writeln!(out, "note: {message}\n  help: {help}"));
    }
    let is_resized = |data: &str| is_resized(application.db(), project, data);
    if let Some(note) = outside::arrange(&mut controller, args, script.as_ref(), &is_resized)? {
        show(&|out| writeln!(out, "note: {note}"));
    }
    let options = Some(RecordedOptions::of(&args.program, &chosen, &controller));
    start(&mut controller, &args.program, &programs)?;
    Ok(OpenedApplication::Ready(Box::new(ReadyApplication {
        controller,
        application,
        test: None,
        options,
        announcements,
        checked: Some(checked.counts),
        _unpacked: unpacked,
    })))
}

/// Checks that an application with `start` also has `stop`. Controllers do not start other applications (2.1.2).
fn check_stop(program: &str, programs: &[String]) -> Result<(), UserError> {
    let has = |name: &str| programs.iter().any(|known| known == name);
    if program != START || !has(START) || has(STOP) {
        return Ok(());
    }
    Err(UserError::new("the application has the program `start` but no program `stop`, so no controller starts it")
        .with_help("add a program `stop`, which may be empty"))
}

fn start(controller: &mut Controller, program: &str, programs: &[String]) -> Result<(), UserError> {
    controller.start(program).map(drop).map_err(|reason| match reason {
        NotStarted::NoProgram => UserError::new(format!("the application has no program `{program}`"))
            .with_help(programs_to_name(program, programs)),
        NotStarted::HasParameters => {
            UserError::new(format!("a run cannot start `{program}`, because it has parameters")).with_help(format!(
                "start a program without parameters that calls it, or call it: val3 eval --app DIR 'call {program}(…)'"
            ))
        }
        NotStarted::Fault(fault) => UserError::new(format!("`{program}` cannot be started: error {}", fault.0))
            .with_help(format!("`val3 explain {}` explains it", fault.0)),
    })
}

/// Lists programs that `--program` can name in place of the unknown program.
fn programs_to_name(unknown: &str, programs: &[String]) -> String {
    let mut names: Vec<&str> = programs.iter().map(String::as_str).collect();
    if names.is_empty() {
        return "it has no program that can be started".to_owned();
    }
    names.sort_unstable_by_key(|name| name.to_lowercase());
    let meant = question(proposals(unknown, names.iter().copied())).map(|question| format!("{question} "));
    format!("{}choose one of its programs with --program: {}", meant.unwrap_or_default(), names.join(", "))
}

/// Shows a limit of this controller that the application exceeds.
fn show_limit(error: &CompileError, show: Show<'_>) -> Result<(), UserError> {
    let paths = Paths::new(&[], &current_folder()?);
    let path = paths.to_open(error.file.as_str().into());
    let label = match &error.variable {
        Some(name) => format!("`{name}` exceeds a limit of the controller"),
        None => "exceeds a limit of the controller".to_owned(),
    };
    let fault = human::ProgramError {
        code: None,
        message: format!("this controller cannot load the application: {}", error.limit),
        help: error.limit.help(),
        label: &label,
        path: &path,
        line: error.row,
    };
    show(&|out| human::write_program_error(&fault, out));
    Ok(())
}

/// Result of the check before a run.
struct Checked {
    /// Exit code, if the controller's compiler rejects the application.
    refusal: Option<u8>,
    /// Note with the number of findings.
    counts: String,
    /// Errors: file, line and message.
    errors: Vec<String>,
}

/// Shows why the controller's compiler rejects the application, and the other errors.
fn show_faults(session: &mut Session<'_>, project: Project, show: Show<'_>) -> Result<Checked, UserError> {
    let mut outcomes = session.check()?;
    let refusals = val3_check::refusals(session.db(), project);
    let is_refused = !refusals.is_empty();
    // The report keeps the first of equal findings; settings may change the level of the second.
    outcomes.diagnostics.splice(0..0, refusals);
    let mut report = session.report(outcomes);
    let counts = summary::of_checked_run(&report);
    report.findings.retain(|finding| finding.severity == FindingSeverity::Error);
    show(&|out| human::write(&report, out));
    let code = if report.is_complete() { EXIT_REFUSED } else { EXIT_USAGE };
    let errors = report.findings.iter().map(located).collect();
    Ok(Checked { refusal: is_refused.then_some(code), counts, errors })
}

fn located(finding: &Finding) -> String {
    format!("{}:{}: {}", finding.place.file.path, finding.place.start().line, finding.message)
}
