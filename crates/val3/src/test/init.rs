//! `--init`: the library `val3assert` and a first test beside an application.

use std::fs;
use std::process::ExitCode;

use camino::{Utf8Path, Utf8PathBuf};
use val3_files::{Unwritable, replace};
use val3_suite::library;

use crate::output::to_stderr;
use crate::paths::current_folder;
use crate::user_error::UserError;

/// Writes the files. Existing ones are never replaced.
///
/// # Errors
/// The path is not an application, or a folder cannot be written.
pub(super) fn run(paths: &[Utf8PathBuf]) -> Result<ExitCode, UserError> {
    let [path] = paths else {
        return Err(UserError::new("--init needs one application").with_help("val3 test --init usr/usrapp/main"));
    };
    let application = current_folder()?.join(path);
    let application = application.canonicalize_utf8().map_err(|error| UserError::new(format!("`{path}`: {error}")))?;
    let (Some(name), Some(parent)) = (application.file_name(), application.parent()) else {
        return Err(UserError::new(format!("`{path}` is not an application")));
    };
    if !application.join(format!("{name}.pjx")).is_file() {
        return Err(UserError::new(format!("`{path}` is not an application: it has no `{name}.pjx`"))
            .with_help("name the folder of an application"));
    }
    let tests = format!("{name}Test");
    let first = library::first_test(&tests);
    let first: Vec<(&str, &str)> = first.iter().map(|(file, text)| (file.as_str(), text.as_str())).collect();
    write(&parent.join(library::NAME), library::FILES)?;
    write(&parent.join(&tests), &first)?;
    to_stderr(|out| writeln!(out, "run the tests: val3 test {}", parent.join(&tests)));
    Ok(ExitCode::SUCCESS)
}

fn write(folder: &Utf8Path, files: &[(&str, &str)]) -> Result<(), UserError> {
    let refused = |reason: Unwritable| UserError::new(format!("cannot write `{folder}`: {reason}"));
    if folder.exists() {
        to_stderr(|out| writeln!(out, "note: `{folder}` exists and stays as it is"));
        return Ok(());
    }
    fs::create_dir_all(folder).map_err(|error| refused(error.into()))?;
    files.iter().try_for_each(|(name, text)| replace(&folder.join(name), text.as_bytes())).map_err(refused)?;
    to_stderr(|out| writeln!(out, "wrote {folder}"));
    Ok(())
}
