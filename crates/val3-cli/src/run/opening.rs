//! From the arguments of `val3 run` to a controller with the application in memory.

use std::process::ExitCode;

use val3_compile::CompileError;
use val3_machine::controller::{Controller, NotStarted};

use super::outside;
use crate::application::{Tape, compile, controller, only_application, set_arm};
use crate::args::{Color, RunArgs};
use crate::engine::Session;
use crate::format::{self, Format, human};
use crate::opening::{Request, current_folder};
use crate::output::{to_stderr_in_color, to_stdout};
use crate::paths::Paths;
use crate::report::Severity;
use crate::user_error::{EXIT_USAGE, UserError};

/// What opening an application comes to.
pub(crate) enum Opened {
    /// It is in memory.
    Ready(Box<Controller>),
    /// It has faults, which were shown.
    Faulty(ExitCode),
}

/// Reads, checks and compiles the application.
pub(crate) fn open(args: &RunArgs, color: Color) -> Result<Opened, UserError> {
    let request = Request { asked: vec![args.application.clone()], ..Request::default() };
    let alone;
    let mut session = Session::open(&request)?;
    let mut project = only_application(&session, &args.application, Some(&args.program))?;
    if session.projects().len() > 1 {
        // Faults of the others beside it do not count.
        let manifest = project.manifest(session.db()).path(session.db()).clone();
        alone = Request { asked: vec![manifest.clone()], ..Request::default() };
        session = Session::open(&alone)?;
        project = only_application(&session, &manifest, None)?;
    }
    if let Some(name) = &args.controller.arm {
        set_arm(session.db_mut(), project, name)?;
    }
    if show_errors(&mut session, color)? {
        return Ok(Opened::Faulty(ExitCode::FAILURE));
    }
    let db = session.db();
    let image = match compile(db, project) {
        Ok(image) => image,
        Err(error) => {
            show_limit(&error, color)?;
            return Ok(Opened::Faulty(ExitCode::from(EXIT_USAGE)));
        }
    };
    let tape = Tape { records: args.events.is_some(), replays: args.replay.as_deref() };
    let mut controller = controller(&args.controller, tape, (db, project), image)?;
    outside::arrange(&mut controller, args)?;
    start(&mut controller, &args.program)?;
    Ok(Opened::Ready(Box::new(controller)))
}

fn start(controller: &mut Controller, program: &str) -> Result<(), UserError> {
    controller.start(program).map(drop).map_err(|reason| match reason {
        NotStarted::NoProgram => UserError::new(format!("the application has no program `{program}`"))
            .with_help("name the program to start with by --program"),
        NotStarted::HasParameters => {
            UserError::new(format!("`{program}` has parameters, and a run cannot give them values")).with_help(format!(
                "start a program without parameters that calls it, or call it: val3 eval --app DIR 'call {program}(…)'"
            ))
        }
        NotStarted::Fault(fault) => UserError::new(format!("`{program}` cannot be started: error {}", fault.0))
            .with_help(format!("`val3 explain {}` tells what it means", fault.0)),
    })
}

/// Shows a limit of this controller where the application exceeds it.
fn show_limit(error: &CompileError, color: Color) -> Result<(), UserError> {
    let paths = Paths::new(&[], &current_folder()?);
    let path = paths.shown(error.file.as_str().into());
    let fault = human::Fault {
        code: None,
        message: format!("this controller cannot load the application: {}", error.limit),
        help: error.limit.help(),
        label: "more than it can hold",
        path: &path,
        line: error.row,
    };
    to_stderr_in_color(color, |out| human::write_fault(&fault, out));
    Ok(())
}

/// Shows the findings of level error; whether there are any.
fn show_errors(session: &mut Session<'_>, color: Color) -> Result<bool, UserError> {
    let found = session.check()?;
    let mut report = session.report(found);
    report.findings.retain(|finding| finding.severity == Severity::Error);
    if report.findings.is_empty() {
        return Ok(false);
    }
    to_stdout(color, |out| format::write(Format::Human, &report, &format::val3check::Template::default(), out))?;
    Ok(true)
}
