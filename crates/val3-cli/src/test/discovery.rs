//! The applications with tests below the paths asked for.

use std::sync::Arc;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::load::load;
use val3_analysis::system::Disk;
use val3_analysis::test_applications::has_tests;
use val3_bytecode::Image;
use val3_lang::suggest::{proposals, question};
use val3_session::{Application, SessionError};
use val3_suite::{TestCase, cases};

use crate::args::{ControllerArgs, TestArgs};
use crate::user_error::UserError;

/// An application with tests.
pub(super) struct Suite {
    pub(super) manifest: Utf8PathBuf,
    pub(super) application: Application,
    pub(super) image: Arc<Image>,
    pub(super) cases: Vec<TestCase>,
}

/// A test of an application.
#[derive(Clone, Copy)]
pub(super) struct TestFile<'s> {
    pub(super) manifest: &'s Utf8Path,
    pub(super) case: &'s TestCase,
}

/// An application whose tests are listed.
pub(super) struct Listed {
    pub(super) manifest: Utf8PathBuf,
    /// Its tests, or the reason why they cannot be executed.
    pub(super) cases: Result<Vec<TestCase>, String>,
}

impl Listed {
    /// All applications with tests; possibly none.
    ///
    /// # Errors
    /// A path does not exist.
    pub(super) fn all(args: &TestArgs, current: &Utf8Path) -> Result<Vec<Self>, UserError> {
        let listed = |manifest: Utf8PathBuf| {
            let cases = open(&args.controller, &manifest).map(|suite| suite.cases).map_err(|error| error.to_string());
            let cases = cases.map(|cases| cases.into_iter().filter(|case| is_wanted(args, case)).collect());
            Self { manifest, cases }
        };
        Ok(manifests(args, current)?.into_iter().map(listed).collect())
    }
}

/// The tests of applications that the arguments ask for.
///
/// # Errors
/// A test that the arguments name does not exist.
pub(super) fn chosen<'s>(args: &TestArgs, suites: &'s [Suite]) -> Result<Vec<TestFile<'s>>, UserError> {
    let all =
        suites.iter().flat_map(|suite| suite.cases.iter().map(|case| TestFile { manifest: &suite.manifest, case }));
    let all: Vec<TestFile<'s>> = all.collect();
    let names: Vec<String> = all.iter().map(|test| test.case.name()).collect();
    if let Some(unknown) = args.exact.iter().find(|exact| !names.contains(exact)) {
        let help = question(proposals(unknown, names.iter().map(String::as_str)));
        return Err(UserError::new(format!("there is no test `{unknown}`"))
            .with_help(help.unwrap_or_else(|| "`val3 test --list` shows the names".to_owned())));
    }
    let wanted = all.into_iter().filter(|test| is_wanted(args, test.case)).enumerate();
    let here = wanted.filter(|(number, _)| args.shard.is_none_or(|shard| shard.has(*number)));
    Ok(here.map(|(_, test)| test).collect())
}

fn is_wanted(args: &TestArgs, case: &TestCase) -> bool {
    let name = case.name();
    let is_named = args.exact.is_empty() || args.exact.contains(&name);
    is_named && args.filter.as_ref().is_none_or(|filter| name.contains(filter.as_str()))
}

/// The applications with tests, in the order of their folders.
///
/// # Errors
/// There is none, one cannot be read, or the compiler refuses it.
pub(super) fn suites(args: &TestArgs, current: &Utf8Path) -> Result<Vec<Suite>, UserError> {
    let manifests = manifests(args, current)?;
    if manifests.is_empty() {
        return Err(UserError::new("no application here has tests").with_help(
            "tests are programs `test…` of applications that are named `…Test` or lie below a folder `tests`; \
             `val3 test --init APP` writes the first one",
        ));
    }
    manifests.iter().map(|manifest| open(&args.controller, manifest)).collect()
}

/// The project files of the applications with tests.
///
/// # Errors
/// A path does not exist.
fn manifests(args: &TestArgs, current: &Utf8Path) -> Result<Vec<Utf8PathBuf>, UserError> {
    let asked: Vec<Utf8PathBuf> = args.paths.iter().map(|path| current.join(path)).collect();
    let workspace = load(&Disk, &asked).map_err(SessionError::Load)?;
    let db = &workspace.db;
    let mut manifests: Vec<Utf8PathBuf> = workspace
        .projects
        .iter()
        .filter(|project| has_tests(db, **project))
        .map(|project| project.manifest(db).path(db).clone())
        .collect();
    manifests.sort();
    Ok(manifests)
}

/// Reads and compiles an application.
///
/// # Errors
/// It cannot be read, or the compiler refuses it.
pub(super) fn open(controller: &ControllerArgs, manifest: &Utf8Path) -> Result<Suite, UserError> {
    let mut application = Application::open(&Disk, manifest, None)?;
    if let Some(arm) = &controller.arm {
        application.set_arm(arm)?;
    }
    let faulty = |reason: String| {
        UserError::new(format!("the tests of `{manifest}` cannot be executed: {reason}"))
            .with_help(format!("val3 check {}", manifest.parent().unwrap_or(manifest)))
    };
    if let Some(refusal) = application.refusals().first() {
        return Err(faulty(format!("the compiler refuses the application: {}", refusal.message)));
    }
    let image = application.compile().map_err(|error| faulty(error.to_string()))?;
    let cases = cases(&image);
    Ok(Suite { manifest: manifest.to_owned(), application, image, cases })
}
