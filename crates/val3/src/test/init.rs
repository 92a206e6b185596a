//! `--init`: writes the library `val3assert` and a first test next to an application.

use std::fs;
use std::process::ExitCode;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::items::project::items;
use val3_analysis::load::load;
use val3_analysis::system::Disk;
use val3_files::{Unwritable, replace};
use val3_lang::keywords::{is_identifier, reserved};
use val3_lang::types::Arm;
use val3_lang::versions::Version;
use val3_suite::library::{self, TestApplication};

use crate::output::to_stderr;
use crate::paths::{Paths, current_folder};
use crate::user_error::UserError;

/// Minimum version of a test, because the assertions use libraries and user types. Otherwise, a test has the version of
/// its application.
const VERSION: Version = Version::new(7, 0, 0);

/// Default library alias, if the application's name is not a valid alias.
const ALIAS: &str = "app";

/// Names used by the test application.
const TAKEN: [&str; 4] = ["start", "stop", library::FIRST_TEST, library::ALIAS];

/// Writes the files. Existing files are never replaced.
///
/// # Errors
/// The path is not an application, or a folder cannot be written.
pub(super) fn run(paths: &[Utf8PathBuf]) -> Result<ExitCode, UserError> {
    let [path] = paths else {
        return Err(UserError::new("--init needs one application").with_help("val3 test --init usr/usrapp/main"));
    };
    let current = current_folder()?;
    let application = current.join(path);
    let application = application.canonicalize_utf8().map_err(|error| UserError::new(format!("`{path}`: {error}")))?;
    let (Some(name), Some(parent)) = (application.file_name(), application.parent()) else {
        return Err(UserError::new(format!("`{path}` is not an application")));
    };
    if !application.join(format!("{name}.pjx")).is_file() {
        return Err(UserError::new(format!("`{path}` is not an application: it has no `{name}.pjx`"))
            .with_help("name the folder of an application"));
    }
    let tested = tested(&application, name)?;
    let version = tested.version.max(VERSION);
    let test = TestApplication { application: name, alias: alias(name, version), version };
    let first = test.files(library::FIRST_TEST, library::FIRST_TEST_PROGRAM);
    let first: Vec<(&str, &str)> = first.iter().map(|(file, text)| (file.as_str(), text.as_str())).collect();
    let tests = parent.join(test.name());
    let paths = Paths::new(&[], &current);
    let assertions = library::files(tested.arm);
    let assertions: Vec<(&str, &str)> = assertions.iter().map(|(file, text)| (*file, text.as_str())).collect();
    write(&parent.join(library::NAME), &assertions, &paths)?;
    write(&tests, &first, &paths)?;
    to_stderr(|out| writeln!(out, "run the tests: val3 test {}", paths.shown(&tests)));
    Ok(ExitCode::SUCCESS)
}

/// Properties of the tested application that its test shares.
struct TestedProperties {
    /// Arm kind of the application's positions, otherwise of its configuration or cell.
    arm: Arm,
    version: Version,
}

fn tested(application: &Utf8Path, name: &str) -> Result<TestedProperties, UserError> {
    let workspace = load(&Disk, &[application.to_owned()]).map_err(|error| UserError::new(error.to_string()))?;
    let db = &workspace.db;
    let manifest = application.join(format!("{name}.pjx"));
    let project = workspace.projects.iter().copied().find(|project| *project.manifest(db).path(db) == manifest);
    let items = project.map(|project| items(db, project));
    let arm = items.and_then(|items| items.arm).unwrap_or(Arm::SixAxis);
    Ok(TestedProperties { arm, version: items.map_or(VERSION, |items| items.version) })
}

/// Library alias of the application in its test: its name, if that is a valid alias.
fn alias(name: &str, version: Version) -> &str {
    let limit = version.identifier_limit().unwrap_or(usize::MAX);
    let is_usable = is_identifier(name) && reserved(name).is_none() && name.len() <= limit && !TAKEN.contains(&name);
    if is_usable { name } else { ALIAS }
}

fn write(folder: &Utf8Path, files: &[(&str, &str)], paths: &Paths) -> Result<(), UserError> {
    let shown = paths.shown(folder);
    let refused = |reason: Unwritable| UserError::new(format!("cannot write `{shown}`: {reason}"));
    if folder.exists() {
        to_stderr(|out| writeln!(out, "note: `{shown}` exists and stays unchanged"));
        return Ok(());
    }
    fs::create_dir_all(folder).map_err(|error| refused(error.into()))?;
    files.iter().try_for_each(|(name, text)| replace(&folder.join(name), text.as_bytes())).map_err(refused)?;
    to_stderr(|out| writeln!(out, "wrote {shown}"));
    Ok(())
}
