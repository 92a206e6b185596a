//! `--new`: writes a test into a test application.

use std::fmt::Display;
use std::process::ExitCode;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::db::{Database, File, FileStatus, Project};
use val3_analysis::items::project::folder;
use val3_analysis::load::load;
use val3_analysis::system::Disk;
use val3_analysis::test_applications::has_tests;
use val3_files::{FileClass, replace, replace_unchanged};
use val3_ide::{FileEdit, SourceChange};
use val3_syntax::encoding::Encoding;

use crate::fixing::{encoded, unencodable};
use crate::output::to_stderr;
use crate::paths::{Paths, current_folder};
use crate::user_error::UserError;

/// Writes the test `name` for the program `tested` into the test application at the path, or next to the application at
/// the path.
///
/// # Errors
/// There is no such application, the test exists, or a file cannot be written.
pub(super) fn run(paths: &[Utf8PathBuf], name: &str, tested: Option<&str>) -> Result<ExitCode, UserError> {
    let [path] = paths else {
        return Err(UserError::new("--new needs one test application")
            .with_help("val3 test --new testTotal usr/usrapp/palTest"));
    };
    let current = current_folder()?;
    let application = application(&current.join(path))?;
    let workspace =
        load(&Disk, std::slice::from_ref(&application)).map_err(|error| UserError::new(error.to_string()))?;
    let db = &workspace.db;
    let here = |project: &&Project| folder(db, **project) == application && has_tests(db, **project);
    let project = workspace.projects.iter().find(here).copied();
    let shown = Paths::new(&[], &current);
    let folder = shown.shown(&application);
    let refused = |reason: String| UserError::new(format!("cannot write the test `{name}` into `{folder}`: {reason}"));
    let project = project.ok_or_else(|| {
        refused("it is no test application".to_owned()).with_help("`val3 test --init APPLICATION` writes one")
    })?;
    let change = val3_ide::new_test(db, project, name, tested).map_err(|error| refused(error.0))?;
    write(db, &change, &shown)?;
    let program = application.join(name).with_extension("pgx");
    to_stderr(|out| writeln!(out, "execute it: val3 test {}", shown.shown(&program)));
    Ok(ExitCode::SUCCESS)
}

/// Folder of the test application: the folder next to the path whose name ends with `Test`, or the path itself.
fn application(path: &Utf8Path) -> Result<Utf8PathBuf, UserError> {
    let path = path.canonicalize_utf8().map_err(|error| UserError::new(format!("`{path}`: {error}")))?;
    let beside = path.file_name().map(|name| path.with_file_name(format!("{name}Test")));
    Ok(beside.filter(|beside| beside.is_dir()).unwrap_or(path))
}

/// Writes new files, then edited files. Nothing is written if one of them cannot be written.
fn write(db: &Database, change: &SourceChange, shown: &Paths) -> Result<(), UserError> {
    if let Some((path, _)) = change.creates.iter().find(|(path, _)| path.exists()) {
        return Err(unwritable(&shown.shown(path), &"the file exists"));
    }
    let edits = change.edits.chunk_by(|one, other| one.file == other.file);
    let edited: Vec<(File, Vec<u8>)> = edits.map(|edits| edited(db, edits, shown)).collect::<Result<_, _>>()?;
    for (path, text) in &change.creates {
        let shown = shown.shown(path);
        replace(path, text.as_bytes()).map_err(|error| unwritable(&shown, &error))?;
        to_stderr(|out| writeln!(out, "wrote {shown}"));
    }
    for (file, bytes) in edited {
        let (path, shown) = (file.path(db), shown.shown(file.path(db)));
        let before = encoding(db, file).encode(file.text(db));
        replace_unchanged(path, FileClass::Program, &before, &bytes).map_err(|error| unwritable(&shown, &error))?;
        to_stderr(|out| writeln!(out, "changed {shown}"));
    }
    Ok(())
}

fn unwritable(path: &str, reason: &dyn Display) -> UserError {
    UserError::new(format!("cannot write `{path}`: {reason}"))
}

/// Returns a file and its bytes after edits.
fn edited(db: &Database, edits: &[FileEdit], shown: &Paths) -> Result<(File, Vec<u8>), UserError> {
    let file = edits.first().map(|edit| edit.file).ok_or_else(|| UserError::new("a file without an edit"))?;
    let text = FileEdit::apply_all(file.text(db), edits);
    let bytes = encoded(encoding(db, file), &text).ok_or_else(|| unencodable(&shown.shown(file.path(db))))?;
    Ok((file, bytes))
}

/// File encoding. An unreadable file is not edited.
fn encoding(db: &Database, file: File) -> Encoding {
    match file.status(db) {
        FileStatus::Read { encoding, .. } => *encoding,
        FileStatus::Unreadable(_) => Encoding::Utf8,
    }
}
