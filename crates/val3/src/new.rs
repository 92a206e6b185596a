//! `val3 new`: an application that can be run immediately, with a test.

mod cell;
mod data;
mod files;
mod name;
mod place;
mod positions;
mod things;

use std::fs;
use std::process::ExitCode;

use camino::Utf8Path;
use serde_json::json;
use val3_files::{Unwritable, replace};
use val3_suite::library;

use crate::args::{NewArgs, NewFormat};
use crate::color::Color;
use crate::output::{OutputContent, to_stderr, to_stdout_as};
use crate::paths::{Paths, current_folder};
use crate::user_error::UserError;

use cell::Controller;
use files::Application;
use place::NewLocation;
use positions::NewPositions;

/// Runs the command.
///
/// # Errors
/// The name, the version or the arm is invalid, a folder exists, or a file cannot be written.
pub(crate) fn run(args: &NewArgs, color: Color) -> Result<ExitCode, UserError> {
    let current = current_folder()?;
    let place = NewLocation::find(&current.join(&args.folder), &args.name)?;
    let paths = Paths::new(&[], &current);
    let controller = Controller::of(&place, args, &paths)?;
    name::check(&args.name, controller.version)?;
    let positions = NewPositions::of(&controller.arm)?;
    let application = Application { name: &args.name, version: controller.version, positions: &positions };
    let (folder, tests) = (place.folder(&args.name), place.folder(&format!("{}Test", args.name)));
    place.check_absent(&[&folder, &tests], &paths)?;

    if let Some(settings) = &controller.settings {
        write(settings.folder(), &[(settings.file_name().to_owned(), settings.text())], &paths)?;
        say(&paths.shown(&settings.path));
        let things = settings.folder().join(things::FILE_NAME);
        if !things.exists() {
            let file = (things::FILE_NAME.to_owned(), things::text(&positions, &controller.arm));
            write(settings.folder(), &[file], &paths)?;
            say(&paths.shown(&things));
        }
    }
    let assertions = place.folder(library::NAME);
    for (folder, files) in [(&folder, application.files(&controller.arm)), (&tests, application.test_files())] {
        write(folder, &files, &paths)?;
        say(&paths.shown(folder));
    }
    if !assertions.exists() {
        let files: Vec<_> =
            library::files(controller.kind()).into_iter().map(|(name, text)| (name.to_owned(), text)).collect();
        write(&assertions, &files, &paths)?;
        say(&paths.shown(&assertions));
    }
    let power = if controller.has_power { "" } else { " --power" };
    let runnable = place.cell.as_ref().filter(|_| !place.exists).unwrap_or(&folder);
    match args.format {
        NewFormat::Human => to_stderr(|out| {
            writeln!(out, "the application is for a {} and VAL 3 {}", controller.arm.name(), controller.version)?;
            writeln!(out, "  run it:   val3 run {}{power} --screen", quoted(&paths.shown(runnable)))?;
            writeln!(out, "  test it:  val3 test {}", quoted(&paths.shown(&tests)))?;
            writeln!(out, "  check it: val3 check --motion {}", quoted(&paths.shown(&folder)))
        }),
        NewFormat::Json => {
            let written = json!({
                "version": 1,
                "application": folder,
                "tests": tests,
                "arm": controller.arm.name(),
                "val3": controller.version.to_string(),
            });
            to_stdout_as(OutputContent::Json, color, |out| writeln!(out, "{written}"))?;
        }
    }
    Ok(ExitCode::SUCCESS)
}

/// Reports a written file or folder.
fn say(path: &str) {
    to_stderr(|out| writeln!(out, "wrote {path}"));
}

/// Quotes a path as an argument in a shell.
fn quoted(path: &str) -> String {
    if path.contains(|char: char| char.is_whitespace()) { format!("\"{path}\"") } else { path.to_owned() }
}

/// Writes files to a folder, which is created with its parent folders.
fn write(folder: &Utf8Path, files: &[(String, String)], paths: &Paths) -> Result<(), UserError> {
    fs::create_dir_all(folder).map_err(|error| unwritable(&paths.shown(folder), &error.into()))?;
    let written = files.iter().try_for_each(|(name, text)| replace(&folder.join(name), text.as_bytes()));
    written.map_err(|reason| unwritable(&paths.shown(folder), &reason))
}

fn unwritable(folder: &str, reason: &Unwritable) -> UserError {
    UserError::new(format!("cannot write `{folder}`: {reason}"))
        .with_help("name a folder that you may write to: --folder DIR")
}
