//! From the arguments of `val3 run` to a controller with the application in memory.

use std::process::ExitCode;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::db::{Database, Project};
use val3_analysis::items::project::{folder, items};
use val3_machine::controller::Controller;
use val3_machine::devices::Devices;
use val3_machine::files::Roots;

use super::images::Images;
use super::{arm, lines, outside};
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
    let manifest = manifest(args)?;
    let request = Request { asked: vec![manifest.clone()], ..Request::default() };
    let mut session = Session::open(&request)?;
    let project = only_application(&session, &manifest, None)?;
    if let Some(name) = &args.arm {
        arm::set(session.db_mut(), project, name)?;
    }
    if show_errors(&mut session, color)? {
        return Ok(Opened::Faulty(ExitCode::FAILURE));
    }
    let db = session.db();
    let image = val3_compile::compile(db, project).map_err(|error| UserError::new(error.to_string()))?;
    let (roots, path, disk) = roots(db, project, args)?;
    let mut devices = Devices::new(roots, Box::new(Images::new(disk.clone())));
    outside::declare_io(&mut devices, db, project);
    lines::connect(&mut devices.lines, &disk, args)?;
    let mut controller = Controller::new(devices, image.into(), path, args.line_cost);
    outside::arrange(&mut controller, args)?;
    started(controller, args)
}

/// The project file of the application, so that faults of others beside it do not count.
fn manifest(args: &RunArgs) -> Result<Utf8PathBuf, UserError> {
    let request = Request { asked: vec![args.application.clone()], ..Request::default() };
    let session = Session::open(&request)?;
    let project = only_application(&session, &args.application, Some(&args.program))?;
    Ok(project.manifest(session.db()).path(session.db()).clone())
}

fn started(mut controller: Controller, args: &RunArgs) -> Result<Opened, UserError> {
    if !controller.start(&args.program) {
        let message = format!("the application has no program `{}`", args.program);
        return Err(UserError::new(message).with_help("name the program to start with by --program"));
    }
    Ok(Opened::Ready(Box::new(controller)))
}

/// The application that is meant: the only one there, or the only one with a program of this name.
pub(crate) fn only_application(
    session: &Session<'_>,
    asked: &Utf8Path,
    program: Option<&str>,
) -> Result<Project, UserError> {
    let (projects, db) = (session.projects(), session.db());
    let has_program = |project: &&Project| program.is_some_and(|name| items(db, **project).programs.contains_key(name));
    let starting: Vec<Project> = projects.iter().filter(has_program).copied().collect();
    match (projects, starting.as_slice()) {
        ([project], _) | (_, [project]) => Ok(*project),
        (_, several) => {
            let shown = if several.is_empty() { projects } else { several };
            let names: Vec<&str> = shown.iter().filter_map(|project| folder(db, *project).file_name()).collect();
            let help = format!("name the folder of one of them: {}", names.join(", "));
            Err(UserError::new(format!("`{asked}` holds {} applications", shown.len())).with_help(help))
        }
    }
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

/// The media, the path of the application on them, and the folder of `Disk`.
fn roots(db: &Database, project: Project, args: &RunArgs) -> Result<(Roots, String, Utf8PathBuf), UserError> {
    let application = folder(db, project);
    let disk = project.disk(db).or(application.parent()).unwrap_or(application).to_owned();
    let mut roots = Roots::default();
    mount(&mut roots, "Disk", &disk)?;
    args.root.iter().try_for_each(|root| mount(&mut roots, &root.name, &root.folder))?;
    let inside = application.strip_prefix(&disk).unwrap_or(Utf8Path::new(""));
    Ok((roots, format!("Disk://{inside}"), disk))
}

fn mount(roots: &mut Roots, name: &str, folder: &Utf8Path) -> Result<(), UserError> {
    roots.mount(name, folder).map_err(|error| {
        UserError::new(format!("cannot open the folder `{folder}` for `{name}://`: {error}"))
            .with_help("name a folder that you may read")
    })
}
