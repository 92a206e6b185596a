//! The applications with tests below the paths asked for.

use std::sync::Arc;

use camino::{Utf8Component, Utf8Path, Utf8PathBuf};
use val3_analysis::items::project::folder;
use val3_analysis::load::load;
use val3_analysis::system::Disk;
use val3_bytecode::Image;
use val3_session::{Application, SessionError};
use val3_suite::{TestCase, cases, is_test_application};

use crate::args::TestArgs;
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

/// The tests of applications that the arguments ask for.
pub(super) fn chosen<'s>(args: &TestArgs, suites: &'s [Suite]) -> Vec<TestFile<'s>> {
    let is_wanted = |case: &TestCase| args.filter.as_ref().is_none_or(|filter| case.name().contains(filter.as_str()));
    let all =
        suites.iter().flat_map(|suite| suite.cases.iter().map(|case| TestFile { manifest: &suite.manifest, case }));
    let wanted = all.filter(|test| is_wanted(test.case)).enumerate();
    let here = wanted.filter(|(number, _)| args.shard.is_none_or(|shard| shard.has(*number)));
    here.map(|(_, test)| test).collect()
}

/// The applications with tests, in the order of their folders.
///
/// # Errors
/// There is none, one cannot be read, or the compiler refuses it.
pub(super) fn suites(args: &TestArgs, current: &Utf8Path) -> Result<Vec<Suite>, UserError> {
    let asked: Vec<Utf8PathBuf> = args.paths.iter().map(|path| current.join(path)).collect();
    let workspace = load(&Disk, &asked).map_err(SessionError::Load)?;
    let db = &workspace.db;
    let mut manifests: Vec<Utf8PathBuf> = workspace
        .projects
        .iter()
        .filter(|project| is_test_application(folder(db, **project).components().filter_map(name)))
        .map(|project| project.manifest(db).path(db).clone())
        .collect();
    manifests.sort();
    if manifests.is_empty() {
        return Err(UserError::new("no application here has tests").with_help(
            "tests are programs `test…` of applications that are named `…Test` or lie below a folder `tests`; \
             `val3 test --init APP` writes the first one",
        ));
    }
    manifests.iter().map(|manifest| open(args, manifest)).collect()
}

fn name(component: Utf8Component<'_>) -> Option<&str> {
    match component {
        Utf8Component::Normal(name) => Some(name),
        _ => None,
    }
}

/// Reads and compiles an application.
///
/// # Errors
/// It cannot be read, or the compiler refuses it.
pub(super) fn open(args: &TestArgs, manifest: &Utf8Path) -> Result<Suite, UserError> {
    let mut application = Application::open(&Disk, manifest, None)?;
    if let Some(arm) = &args.controller.arm {
        application.set_arm(arm)?;
    }
    let faulty = |reason: String| {
        UserError::new(format!("the tests of `{manifest}` cannot be executed: {reason}"))
            .with_help(format!("val3 check {}", manifest.parent().unwrap_or(manifest)))
    };
    if let Some(refusal) = application.refusals().first() {
        return Err(faulty(format!("the compiler refuses the application: {}", refusal.message)));
    }
    let image = if args.coverage.is_wanted() { application.compile_counted() } else { application.compile() };
    let image = image.map_err(|error| faulty(error.to_string()))?;
    let cases = cases(&image);
    Ok(Suite { manifest: manifest.to_owned(), application, image, cases })
}
