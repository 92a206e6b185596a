//! Paths in the arguments: folders, applications, scenarios, and files of single tests.

use std::collections::BTreeSet;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::paths::{normalise, path_key};
use val3_files::FileClass;
use val3_suite::{Scenario, TestCase, TestFileRole};

use super::refused::RefusedTests;
use super::script_file::program_beside;
use crate::paths::has_extension;
use crate::user_error::UserError;

/// Paths in the arguments.
#[derive(Debug, Default)]
pub(super) struct Asked {
    /// Folders, applications and scenarios, all of whose tests are requested.
    pub(super) folders: Vec<Utf8PathBuf>,
    /// Files of test programs.
    pub(super) programs: Vec<Utf8PathBuf>,
}

impl Asked {
    /// Resolves the paths relative to the current folder. A line number may follow a file name, as editors display
    /// locations. The expectations file next to a test program means this program.
    pub(super) fn new(paths: &[Utf8PathBuf], current: &Utf8Path) -> Self {
        let mut asked = Self::default();
        for path in paths {
            let path = without_line(&normalise(&current.join(path)));
            match program(&path) {
                Some(program) => asked.programs.push(program),
                None => asked.folders.push(path),
            }
        }
        asked
    }

    /// Whether the file of the test is named, for an application that was only found by file names.
    pub(super) fn names(&self, case: &TestCase) -> bool {
        let key = path_key(&case.file);
        self.programs.iter().any(|program| path_key(program.as_str()) == key)
    }

    /// Checks that each named program file is a test. `files` are the files of the found tests; `refused` are the
    /// project files of applications whose tests are unknown.
    ///
    /// # Errors
    /// A file belongs to no test.
    pub(super) fn check_found(&self, files: &BTreeSet<String>, refused: &[RefusedTests]) -> Result<(), UserError> {
        let mut others = self.programs.iter().filter(|program| !files.contains(&path_key(program.as_str())));
        let Some(missing) = others.find(|program| !is_below(program, refused)) else { return Ok(()) };
        Err(UserError::new(format!("`{missing}` is no test")).with_help(
            "a test is a program whose name begins with `test`, in the project of an application that is named `…Test`, lies \
             below a folder `tests`, or is listed by `[test]` of `val3.toml`",
        ))
    }
}

/// Removes `:LINE` from the end of the path, unless a file with this name exists.
fn without_line(path: &Utf8Path) -> Utf8PathBuf {
    let split = path.as_str().rsplit_once(':').filter(|_| !path.exists());
    match split {
        Some((file, line)) if is_line(line) && Utf8Path::new(file).is_file() => file.into(),
        _ => path.to_owned(),
    }
}

fn is_line(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit())
}

/// Whether the program is in the folder of an application whose tests are unknown.
fn is_below(program: &Utf8Path, refused: &[RefusedTests]) -> bool {
    refused.iter().filter_map(|tests| tests.path.parent()).any(|folder| program.starts_with(folder))
}

/// Test program that the file is or belongs to.
fn program(path: &Utf8Path) -> Option<Utf8PathBuf> {
    if !path.is_file() {
        return None;
    }
    if has_extension(path, "pgx") {
        return Some(path.to_owned());
    }
    let beside = program_beside(path);
    (has_extension(path, "toml") && beside.is_file() && !is_scenario(path)).then_some(beside)
}

/// Whether the file can be read and is a scenario, which belongs to no test program.
fn is_scenario(path: &Utf8Path) -> bool {
    let text = val3_files::read_text(path, FileClass::Settings);
    text.is_ok_and(|text| Scenario::role(&text) == TestFileRole::Scenario)
}
