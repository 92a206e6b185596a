//! Checks that files named by tests are inside the test's cell.

use camino::Utf8Path;
use val3_analysis::load::{LoadError, cell_around, leads_outside, nearest_configuration, refused_link};
use val3_analysis::system::{Disk, System as _};
use val3_config::trust;
use val3_lang::test_names::TESTS;
use val3_session::SessionError;

use crate::user_error::UserError;

/// Checks that the application or library that `key` of a test in `folder` names is in the cell: the repository that
/// contains the test, otherwise the parent of its folder `tests`, or of its own folder.
///
/// # Errors
/// The path is outside, and the user does not trust the folder.
pub(super) fn check_project(folder: &Utf8Path, path: &Utf8Path, key: &str) -> Result<(), UserError> {
    let tests = folder.ancestors().find(|folder| folder.file_name() == Some(TESTS));
    let above = tests.unwrap_or(folder).parent().unwrap_or(folder);
    check(folder, &cell_around(&Disk, above), path, key)
}

/// Checks that a file that the expectation `key` of a test in `folder` names is in the cell: the repository that
/// contains the test, otherwise the folder of its `val3.toml`, otherwise the folder of the test.
///
/// # Errors
/// The path is outside and the user does not trust the folder, or a `val3.toml` is invalid.
pub(super) fn check_file(folder: &Utf8Path, path: &Utf8Path, key: &str) -> Result<(), UserError> {
    let file = nearest_configuration(&Disk, folder)
        .map_err(|error| SessionError::Load(LoadError::Configuration(vec![error])))?;
    let above = file.as_ref().map_or(folder, |file| file.folder());
    check(folder, &cell_around(&Disk, above), path, key)
}

fn check(folder: &Utf8Path, cell: &Utf8Path, path: &Utf8Path, key: &str) -> Result<(), UserError> {
    if !leads_outside(&Disk, cell, path) || trust::is_trusted(&Disk.target(folder)) {
        return Ok(());
    }
    Err(UserError::new(format!("`{key}` names `{path}`, outside of the cell `{cell}`"))
        .with_help(format!("name a path in the cell, or trust its author: {}", trust::trust_command(folder))))
}

/// Checks that a file of a test is no link to a file outside of the cell.
///
/// # Errors
/// The file is such a link, and the user does not trust the folder.
pub(super) fn check_link(folder: &Utf8Path, path: &Utf8Path) -> Result<(), UserError> {
    let refusal = |reason| Err(UserError::new(format!("the script `{path}` is not read: {reason}")));
    refused_link(&Disk, folder, path).map_or(Ok(()), refusal)
}
