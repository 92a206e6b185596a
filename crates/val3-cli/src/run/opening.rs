//! From the arguments of `val3 run` to a controller with the application in memory.

use std::process::ExitCode;

use val3_machine::controller::Controller;
use val3_machine::devices::Devices;

use super::settings::Settings;
use super::{lines, outside};
use crate::application::{Images, Media, compile, only_application, set_arm};
use crate::args::{Color, RunArgs};
use crate::engine::Session;
use crate::format::{self, Format};
use crate::opening::Request;
use crate::output::to_stdout;
use crate::report::Severity;
use crate::user_error::UserError;

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
    if let Some(name) = &args.arm {
        set_arm(session.db_mut(), project, name)?;
    }
    if show_errors(&mut session, color)? {
        return Ok(Opened::Faulty(ExitCode::FAILURE));
    }
    let db = session.db();
    let image = compile(db, project).map_err(UserError::new)?;
    let settings = Settings::of(args, project.configuration(db).map(|configuration| configuration.file(db)))?;
    let mut media = Media::of(db, project)?;
    settings.roots.iter().try_for_each(|root| media.mount(&root.name, &root.folder))?;
    let Media { roots, disk, application } = media;
    let mut devices = Devices::new(roots, Box::new(Images::new(disk.clone())));
    outside::declare_io(&mut devices, db, project);
    outside::describe(&mut devices, &disk, args);
    settings.apply(&mut devices);
    lines::connect(&mut devices.lines, &disk, args, &settings)?;
    let mut controller = Controller::new(devices, image, application, settings.line_cost);
    outside::arrange(&mut controller, args)?;
    started(controller, args)
}

fn started(mut controller: Controller, args: &RunArgs) -> Result<Opened, UserError> {
    if !controller.start(&args.program) {
        let message = format!("the application has no program `{}` without parameters", args.program);
        return Err(UserError::new(message).with_help("name the program to start with by --program"));
    }
    Ok(Opened::Ready(Box::new(controller)))
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
