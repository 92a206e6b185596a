//! Finds scenarios in the requested paths.

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::load::{LoadError, files, is_below_tests, nearest_configuration};
use val3_analysis::paths::normalise;
use val3_analysis::system::{Disk, System as _};
use val3_config::{ConfigFile, FILE_NAME};
use val3_files::{FileClass, Unreadable};
use val3_session::{Application, SessionError};
use val3_suite::{Scenario, TestCase, TestFileRole};

use super::cell::check_project;
use super::discovery::{Opening, Suite, Suites, open};
use super::refused::RefusedTests;
use super::script_file::program_beside;
use crate::args::TestArgs;
use crate::paths::{from_here, has_extension};
use crate::run::unusable_script;
use crate::user_error::UserError;

/// Returns the requested scenario files: files in the paths, and files that the arguments name.
///
/// # Errors
/// A `val3.toml` is invalid.
pub(super) fn find(asked: &[Utf8PathBuf]) -> Result<Vec<Utf8PathBuf>, UserError> {
    let mut found = Vec::new();
    for path in asked {
        if is_named(path) {
            found.push(path.clone());
            continue;
        }
        // The loader reports folders that cannot be listed.
        for file in files(&Disk, path, "toml", &mut Vec::new()) {
            if is_scenario(path, &file)? && !is_excluded(path, &file)? {
                found.push(file);
            }
        }
    }
    found.sort();
    found.dedup();
    Ok(found)
}

/// Paths to search for test programs: paths that contain more than scenarios.
pub(super) fn without(asked: &[Utf8PathBuf], scenarios: &[Utf8PathBuf]) -> Vec<Utf8PathBuf> {
    let has_scenarios = |path: &Utf8Path| scenarios.iter().any(|scenario| scenario.starts_with(path));
    let has_projects = |path: &Utf8Path| !files(&Disk, path, "pjx", &mut Vec::new()).is_empty();
    asked.iter().filter(|path| !is_named(path) && (!has_scenarios(path) || has_projects(path))).cloned().collect()
}

/// Adds the applications that scenarios run, each with its scenarios.
pub(super) fn add_suites(args: &TestArgs, scenarios: &[Utf8PathBuf], suites: &mut Suites) {
    let mut found: Vec<Suite> = Vec::new();
    for path in scenarios {
        let manifest = match application(path) {
            Ok(manifest) => manifest,
            Err(error) => {
                suites.refused.push(RefusedTests::of_scenario(path, error));
                continue;
            }
        };
        let known = found.iter().position(|suite| suite.manifest == manifest);
        let opened = known.map_or_else(|| open(Opening::of(args), &manifest), |known| Ok(found.remove(known)));
        match opened {
            Ok(suite) => {
                let cases = if known.is_some() { suite.cases } else { Vec::new() };
                let cases = cases.into_iter().chain([case(&manifest, path)]).collect();
                found.push(Suite { cases, ..suite });
            }
            Err(refusal) => suites.refused.push(RefusedTests::of_scenario(path, refusal.into())),
        }
    }
    suites.opened.append(&mut found);
}

/// Test case of a scenario; `manifest` is its application's project file.
pub(super) fn case(manifest: &Utf8Path, path: &Utf8Path) -> TestCase {
    let application = manifest.parent().and_then(Utf8Path::file_name).unwrap_or_default();
    TestCase::scenario(application, path.file_stem().unwrap_or_default(), path.as_str())
}

/// Project file of the application that a scenario runs.
///
/// # Errors
/// The scenario cannot be read, or names no application.
pub(super) fn application(path: &Utf8Path) -> Result<Utf8PathBuf, UserError> {
    let shown = from_here(path)?;
    let unusable = |reason: String| UserError::new(format!("the scenario `{shown}` cannot be executed: {reason}"));
    let scenario = match val3_files::read_text(path, FileClass::Settings) {
        Err(reason) => {
            let error = UserError::new(format!("cannot read `{shown}`, which may be a test: {reason}"));
            return Err(error.with_help("allow reading it, or move it away from the tests"));
        }
        Ok(text) => Scenario::parse(shown.as_str(), &text).map_err(|error| unusable_script(&shown, &error))?,
    };
    let beside = path.with_extension("pgx");
    let help = format!(
        "write `application = \"FOLDER\"` before the first table, or name it as the test program that it belongs to, which \
         would be `{}`",
        beside.file_name().unwrap_or_default()
    );
    let named = scenario.application().map_err(|error| unusable(error.to_string()).with_help(help))?;
    let folder = path.parent().unwrap_or(Utf8Path::new("."));
    let application = normalise(&folder.join(named));
    check_project(folder, &application, "application")?;
    let application = Application::open(&Disk, &application, None)
        .map_err(|error| unusable(error.to_string()).with_help(error.help()))?;
    Ok(application.project().manifest(application.db()).path(application.db()).clone())
}

/// Whether the path is a scenario file that an argument names.
fn is_named(path: &Utf8Path) -> bool {
    has_extension(path, "toml") && path.is_file()
}

/// Whether a file in the paths is a scenario: it is in a folder `tests` and names an application. A file with
/// expectations, or a script in such a folder, is also a scenario if it belongs to no test program, because otherwise
/// it would never be executed. A file that cannot be read counts as a scenario, which is reported as a failed test.
///
/// # Errors
/// A `val3.toml` is invalid.
fn is_scenario(asked: &Utf8Path, path: &Utf8Path) -> Result<bool, UserError> {
    let folder = path.parent().unwrap_or(path);
    let configuration = configuration(folder)?;
    let base = asked.parent().unwrap_or(asked);
    let is_below = is_below_tests(&Disk, folder, configuration.as_ref().map(ConfigFile::folder), base);
    let is_other = path.file_name() == Some(FILE_NAME) || program_beside(path).is_file();
    if is_other || !is_below && !is_beside_programs(path) {
        return Ok(false);
    }
    match val3_files::read_text(path, FileClass::Settings) {
        Ok(text) => Ok(match Scenario::role(&text) {
            TestFileRole::Scenario | TestFileRole::Script => is_below,
            TestFileRole::Expectations => true,
            TestFileRole::Other => false,
        }),
        Err(Unreadable::Missing) => Ok(false),
        // Every scenario is UTF-8.
        Err(Unreadable::NotUtf8) => Ok(is_below),
        // It may be a test that would not be executed.
        Err(_) => Ok(true),
    }
}

fn is_beside_programs(path: &Utf8Path) -> bool {
    path.parent().is_some_and(|folder| has_file(folder, "pgx"))
}

fn has_file(folder: &Utf8Path, extension: &str) -> bool {
    Disk.list(folder).is_ok_and(|names| names.iter().any(|name| has_extension(name.as_str().into(), extension)))
}

/// Whether a `val3.toml` excludes a file from a search in `asked`.
fn is_excluded(asked: &Utf8Path, path: &Utf8Path) -> Result<bool, UserError> {
    let folder = path.parent().unwrap_or(Utf8Path::new("."));
    Ok(configuration(folder)?.is_some_and(|file| file.excludes(path) && folder != asked && !file.excludes(asked)))
}

/// The `val3.toml` for a folder.
fn configuration(folder: &Utf8Path) -> Result<Option<ConfigFile>, UserError> {
    let fault = |error| SessionError::from(LoadError::Configuration(vec![error]));
    Ok(nearest_configuration(&Disk, folder).map_err(fault)?)
}
