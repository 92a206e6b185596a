//! File of a test: a scenario file, or the script next to a test program.

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::load::files;
use val3_analysis::paths::{normalise, with_manifest};
use val3_analysis::system::Disk;
use val3_suite::{ControllerKeys, Scenario, TestCase, TestKind};

use super::cell::{check_link, check_project};
use crate::paths::from_here;
use crate::run::{read_script, unusable_script};
use crate::user_error::UserError;

/// File of a test, with its content. It is optional for a test program.
pub(super) struct ScriptFile {
    pub(super) path: Utf8PathBuf,
    pub(super) scenario: Scenario,
    /// Requested controller properties, with absolute paths.
    pub(super) keys: ControllerKeys,
}

impl ScriptFile {
    /// Reads the file of a test.
    ///
    /// # Errors
    /// The file cannot be read, or has a key or value that is invalid for this kind of test.
    pub(super) fn of(case: &TestCase) -> Result<Self, UserError> {
        let Some(path) = path(case) else {
            return Ok(Self {
                path: Utf8PathBuf::new(),
                scenario: Scenario::default(),
                keys: ControllerKeys::default(),
            });
        };
        let folder = path.parent().unwrap_or(Utf8Path::new("."));
        check_link(folder, &path)?;
        let shown = from_here(&path)?;
        let scenario = read_script(&shown)?;
        scenario.check_kind(case.kind).map_err(|error| unusable_script(&shown, &error))?;
        let mut keys = scenario.controller_keys().clone();
        if let Some(cell) = keys.cell.as_mut().filter(|cell| *cell != "none") {
            *cell = normalise(&folder.join(&*cell)).into_string();
        }
        for library in keys.replace.values_mut() {
            *library = stand_in(folder, &shown, library)?.into_string();
        }
        Ok(Self { path: shown, scenario, keys })
    }
}

/// Project file of a library that the file of a test in `folder` names as a stand-in.
fn stand_in(folder: &Utf8Path, script: &Utf8Path, library: &str) -> Result<Utf8PathBuf, UserError> {
    let manifest = with_manifest(normalise(&folder.join(library)));
    check_project(folder, &manifest, "replace")?;
    if manifest.is_file() {
        return Ok(manifest);
    }
    Err(UserError::new(format!("the script `{script}` cannot be used: there is no library `{library}`"))
        .with_help("name the folder of a library or its `.pjx`, relative to the script"))
}

/// Path of the test's file: `testSum[2].toml` for a row, otherwise `testSum.toml`.
fn path(case: &TestCase) -> Option<Utf8PathBuf> {
    if case.kind == TestKind::Scenario {
        return Some(case.file.clone().into());
    }
    let program = Utf8Path::new(&case.file);
    let name = program.file_stem().unwrap_or_default();
    let of_row = case.row.map(|row| program.with_file_name(format!("{name}[{row}].toml")));
    of_row.into_iter().chain([program.with_extension("toml")]).find(|path| path.is_file())
}

/// Path of the test program to which a script belongs: `testSum.pgx` for `testSum.toml` and `testSum[2].toml`.
pub(super) fn program_beside(path: &Utf8Path) -> Utf8PathBuf {
    let name = path.file_stem().unwrap_or_default();
    path.with_file_name(format!("{}.pgx", row(name).map_or(name, |(program, _)| program)))
}

/// Program and row in a name such as `testSum[2]`.
fn row(name: &str) -> Option<(&str, u32)> {
    let (program, row) = name.strip_suffix(']')?.split_once('[')?;
    Some((program, row.parse().ok()?))
}

/// Scripts for rows that do not exist in the application's tests, each with an error.
pub(super) fn without_row(manifest: &Utf8Path, cases: &[TestCase]) -> Vec<(Utf8PathBuf, UserError)> {
    let folder = manifest.parent().unwrap_or(Utf8Path::new("."));
    // Folders that cannot be listed are reported by the search for applications.
    let scripts =
        files(&Disk, folder, "toml", &mut Vec::new()).into_iter().filter(|path| path.parent() == Some(folder));
    scripts.filter_map(|path| missing_row(&path, cases).map(|error| (path, error))).collect()
}

/// Error about a script for a row that does not exist; `None` for a usable script.
fn missing_row(script: &Utf8Path, cases: &[TestCase]) -> Option<UserError> {
    let (program, row) = row(script.file_stem()?)?;
    let of_program = || cases.iter().filter(|case| case.program == program);
    if !program_beside(script).is_file() || of_program().any(|case| case.row == Some(row)) {
        return None;
    }
    let rows = match of_program().filter(|case| case.row.is_some()).count() {
        0 => "no table".to_owned(),
        count => format!("{count} rows, counted from 0"),
    };
    let shown = from_here(script).ok()?;
    Some(UserError::new(format!("the script `{shown}` belongs to no test: `{program}` has {rows}")))
}
