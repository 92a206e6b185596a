//! Finds applications with tests in the requested paths.

use std::collections::BTreeMap;
use std::sync::Arc;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::db::Sources;
use val3_analysis::items::project::folder;
use val3_analysis::load::{LoadError, load};
use val3_analysis::paths::path_key;
use val3_analysis::system::{Disk, OverlayFs};
use val3_analysis::test_applications::has_tests;
use val3_bytecode::Image;
use val3_lang::ports::nanoseconds;
use val3_lang::suggest::{proposals, question};
use val3_lang::test_names::is_test;
use val3_session::{Application, CodeForm, SessionError};
use val3_suite::{TestCase, TestSettings, cases};

use super::asked::Asked;
use super::distinct::distinguish;
use super::refused::{Refusal, RefusedTests};
use super::selection::{TestSelection, is_called};
use super::{identifiers, scenarios, script_file};
use crate::args::{ControllerArgs, LIMITS, TestArgs};
use crate::paths::{Paths, from_here, has_extension};
use crate::user_error::UserError;

/// Default timeout of a test, in seconds of the controller's clock.
const DEFAULT_LIMIT: f64 = 60.0;

/// Applications with tests.
pub(super) struct Suites {
    pub(super) opened: Vec<Suite>,
    /// Tests that cannot be executed.
    pub(super) refused: Vec<RefusedTests>,
}

/// An application with tests.
pub(super) struct Suite {
    pub(super) manifest: Utf8PathBuf,
    pub(super) application: Application,
    pub(super) image: Arc<Image>,
    pub(super) cases: Vec<TestCase>,
    pub(super) settings: TestSettings,
}

impl Suite {
    /// Test program files in the application's folder that its project does not list, sorted.
    pub(super) fn unlisted_tests(&self) -> Vec<&Utf8Path> {
        let db = self.application.db();
        let unlisted = Sources::get(db).unlisted(db).values().map(|file| file.path(db).as_path());
        let programs = unlisted.filter(|path| path.parent() == self.manifest.parent() && has_extension(path, "pgx"));
        let mut tests: Vec<&Utf8Path> = programs.filter(|path| path.file_stem().is_some_and(is_test)).collect();
        tests.sort_unstable();
        tests
    }

    /// Folders on which the tests depend, and whether their subfolders are included: the parent of the application with
    /// the tested applications, the folders of tests and libraries, and the folder of the configuration.
    pub(super) fn folders(&self) -> Vec<(Utf8PathBuf, bool)> {
        let (db, project) = (self.application.db(), self.application.project());
        let around = self.manifest.parent().and_then(Utf8Path::parent);
        let read = Sources::get(db).projects(db).values().map(|project| (folder(db, *project).to_owned(), true));
        let configuration = project.configuration(db).map(|found| (found.file(db).folder().to_owned(), false));
        let around = around.into_iter().chain(self.cases.iter().filter_map(|case| Utf8Path::new(&case.file).parent()));
        around.map(|folder| (folder.to_owned(), true)).chain(read).chain(configuration).collect()
    }
}

/// An application's test.
#[derive(Clone, Copy)]
pub(super) struct TestFile<'s> {
    pub(super) manifest: &'s Utf8Path,
    pub(super) case: &'s TestCase,
}

/// An application whose tests are listed.
pub(super) struct Listed {
    pub(super) manifest: Utf8PathBuf,
    /// Tests, or the reason why they cannot be executed.
    pub(super) cases: Result<Vec<TestCase>, String>,
}

impl Listed {
    /// Lists all applications with tests; the list may be empty.
    ///
    /// # Errors
    /// A path does not exist.
    pub(super) fn all(args: &TestArgs, current: &Utf8Path) -> Result<Vec<Self>, UserError> {
        let selection = TestSelection::of(args)?;
        let asked = Asked::new(&args.paths, current);
        let scenarios = scenarios::find(&asked.folders)?;
        let found = found_applications(&asked, &scenarios)?;
        let mut all: Vec<Self> = Vec::new();
        for FoundApplication { manifest, is_whole } in found {
            let cases = open(Opening::of(args), &manifest).map(|suite| suite.cases).map_err(UserError::from);
            let requested = cases.map(|cases| cases.into_iter().filter(|case| is_whole || asked.names(case)).collect());
            all.push(Self::of(&selection, manifest, requested));
        }
        all.extend(scenarios.iter().map(|path| Self::of_scenario(&selection, path)));
        all.sort_by(|one, other| one.manifest.cmp(&other.manifest));
        all.dedup_by(|next, known| known.takes(next));
        let listed = all.iter_mut().flat_map(|listed| {
            let manifest = &listed.manifest;
            listed.cases.iter_mut().flatten().map(move |case| (manifest.clone(), case))
        });
        distinguish(listed.collect(), &Paths::new(&args.paths, current));
        Ok(all)
    }

    fn of_scenario(selection: &TestSelection<'_>, path: &Utf8Path) -> Self {
        match scenarios::application(path) {
            Ok(manifest) => {
                let case = scenarios::case(&manifest, path);
                Self::of(selection, manifest, Ok(vec![case]))
            }
            Err(error) => Self::of(selection, path.to_owned(), Err(error)),
        }
    }

    fn of(selection: &TestSelection<'_>, manifest: Utf8PathBuf, cases: Result<Vec<TestCase>, UserError>) -> Self {
        let wanted = |cases: Vec<TestCase>| cases.into_iter().filter(|case| selection.has(case)).collect();
        Self { manifest, cases: cases.map(wanted).map_err(|error| error.to_string()) }
    }

    /// Moves the tests of `next` into this entry, if both belong to the same application. Returns whether they do.
    fn takes(&mut self, next: &mut Self) -> bool {
        match (&mut self.cases, &mut next.cases) {
            (Ok(cases), Ok(more)) if self.manifest == next.manifest => {
                cases.append(more);
                true
            }
            _ => false,
        }
    }
}

/// Returns the requested tests. Requested tests that cannot be executed remain in `refused`.
///
/// # Errors
/// A test that an argument names does not exist, or no test remains.
pub(super) fn chosen<'s>(
    args: &TestArgs,
    suites: &'s [Suite],
    refused: &mut Vec<RefusedTests>,
) -> Result<Vec<TestFile<'s>>, UserError> {
    let selection = TestSelection::of(args)?;
    let all =
        suites.iter().flat_map(|suite| suite.cases.iter().map(|case| TestFile { manifest: &suite.manifest, case }));
    let all: Vec<TestFile<'s>> = all.collect();
    let is_test = |name: &str| all.iter().any(|test| is_called(test.case, name));
    let is_refused = |name: &str| refused.iter().any(|tests| tests.has(|case| is_called(case, name)));
    if let Some(unknown) = args.exact.iter().find(|exact| !is_test(exact) && !is_refused(exact)) {
        let names: Vec<String> = all.iter().map(|test| test.case.name()).collect();
        let help = question(proposals(unknown, names.iter().map(String::as_str)));
        return Err(UserError::new(format!("there is no test `{unknown}`"))
            .with_help(help.unwrap_or_else(|| "`val3 test --list` shows the names".to_owned())));
    }
    refused.retain(|tests| tests.has(|case| selection.has_refused(case)));
    let wanted: Vec<_> = all.into_iter().filter(|test| selection.has(test.case)).collect();
    if wanted.is_empty() && refused.is_empty() {
        return Err(UserError::new(format!("there is no test{}", selection.described()))
            .with_help("`val3 test --list` shows the names, and tests are programs whose names begin with `test`"));
    }
    Ok(selection.part(wanted, |test| test.case))
}

/// Finds and opens the applications with tests, in folder order.
///
/// # Errors
/// There is no such application, or a folder cannot be searched.
pub(super) fn suites(args: &TestArgs, current: &Utf8Path) -> Result<Suites, UserError> {
    let asked = Asked::new(&args.paths, current);
    let scenarios = scenarios::find(&asked.folders)?;
    let found = found_applications(&asked, &scenarios)?;
    if found.is_empty() && scenarios.is_empty() && asked.programs.is_empty() {
        return Err(UserError::new("there are no tests here").with_help(
            "tests are programs `test…` of applications that are named `…Test` or lie below a folder `tests`, and files \
             `tests/NAME.toml` that name an application; `val3 test --init APP` writes the first test; `[test]` of \
             `val3.toml` lists further applications",
        ));
    }
    let mut suites = Suites { opened: Vec::new(), refused: Vec::new() };
    for FoundApplication { manifest, is_whole } in &found {
        match open(Opening::of(args), manifest) {
            Ok(mut suite) => {
                let surplus = script_file::without_row(manifest, &suite.cases).into_iter();
                suites.refused.extend(surplus.map(|(path, error)| RefusedTests::of_scenario(&path, error)));
                suite.cases.retain(|case| *is_whole || asked.names(case));
                suites.opened.push(suite);
            }
            Err(refusal) => suites.refused.push(RefusedTests::of_application(manifest, refusal)),
        }
    }
    let cases = suites.opened.iter().flat_map(|suite| &suite.cases);
    asked.check_found(&cases.map(|case| path_key(&case.file)).collect(), &suites.refused)?;
    scenarios::add_suites(args, &scenarios, &mut suites);
    suites.opened.sort_by(|one, other| one.manifest.cmp(&other.manifest));
    suites.refused.sort_by(|one, other| one.path.cmp(&other.path));
    let opened = suites.opened.iter_mut().flat_map(|suite| {
        let manifest = &suite.manifest;
        suite.cases.iter_mut().map(move |case| (manifest.clone(), case))
    });
    let refused = suites.refused.iter_mut().map(RefusedTests::case_mut);
    distinguish(opened.chain(refused).collect(), &Paths::new(&args.paths, current));
    Ok(suites)
}

/// An application with test programs.
struct FoundApplication {
    manifest: Utf8PathBuf,
    /// Whether all tests are requested, not only tests whose files the arguments name.
    is_whole: bool,
}

/// Finds the applications with test programs in the requested paths, sorted by project file.
fn found_applications(asked: &Asked, scenarios: &[Utf8PathBuf]) -> Result<Vec<FoundApplication>, UserError> {
    let whole = test_applications(&scenarios::without(&asked.folders, scenarios))?;
    let named = test_applications(&asked.programs)?;
    let part = named.into_iter().filter(|manifest| !whole.contains(manifest));
    let part: Vec<_> = part.map(|manifest| FoundApplication { manifest, is_whole: false }).collect();
    let mut found: Vec<_> = whole.into_iter().map(|manifest| FoundApplication { manifest, is_whole: true }).collect();
    found.extend(part);
    found.sort_by(|one, other| one.manifest.cmp(&other.manifest));
    Ok(found)
}

/// Project files of the applications with test programs in the paths, sorted.
fn test_applications(paths: &[Utf8PathBuf]) -> Result<Vec<Utf8PathBuf>, UserError> {
    if paths.is_empty() {
        return Ok(Vec::new());
    }
    let workspace = load(&Disk, paths).map_err(SessionError::Load)?;
    let db = &workspace.db;
    let mut manifests: Vec<Utf8PathBuf> = workspace
        .projects
        .iter()
        .filter(|project| has_tests(db, **project))
        .map(|project| project.manifest(db).path(db).clone())
        .collect();
    manifests.sort();
    identifiers::check(&workspace, &manifests)?;
    Ok(manifests)
}

/// Options for opening an application with tests.
#[derive(Clone, Copy)]
pub(super) struct Opening<'a> {
    pub(super) controller: &'a ControllerArgs,
    /// Timeout in the arguments, in seconds.
    pub(super) limit: Option<f64>,
    /// Form of the code.
    pub(super) form: CodeForm,
    /// Stand-in libraries that the file of a test names: absolute paths by library alias.
    pub(super) replace: Option<&'a BTreeMap<String, String>>,
    /// Texts that replace program files on the disk, by path.
    pub(super) edited: &'a [(Utf8PathBuf, Arc<str>)],
}

impl<'a> Opening<'a> {
    pub(super) fn of(args: &'a TestArgs) -> Self {
        let form = if args.coverage.is_wanted() { CodeForm::Counted } else { CodeForm::Plain };
        Self { controller: &args.controller, limit: args.limit, form, replace: None, edited: &[] }
    }
}

/// Loads and compiles an application.
///
/// # Errors
/// The application cannot be loaded, or the compiler rejects it.
pub(super) fn open(opening: Opening<'_>, manifest: &Utf8Path) -> Result<Suite, Refusal> {
    let mut system = OverlayFs::new(Disk);
    opening.edited.iter().for_each(|(path, text)| system.edit(path, Arc::clone(text)));
    let none = BTreeMap::new();
    let replace = opening.replace.unwrap_or(&none);
    let mut application = Application::open_with_stand_ins(&system, manifest, replace).map_err(UserError::from)?;
    if let Some(arm) = &opening.controller.arm {
        application.set_arm(arm).map_err(UserError::from)?;
    }
    let shown = from_here(manifest)?;
    let settings = settings(opening.limit, &application)?;
    if let Some(fault) = application.stand_in_faults().first() {
        let error = unexecutable(&shown, &fault.to_string()).with_help(fault.help.as_str());
        return Err(Refusal::new(error, &[], &application));
    }
    let refusals = application.refusals();
    if !refusals.is_empty() {
        let error = unexecutable(&shown, "the compiler rejects the application");
        return Err(Refusal::new(error, &refusals, &application));
    }
    application.check_readable().map_err(UserError::from)?;
    let image = application
        .compile_as(opening.form)
        .map_err(|error| Refusal::new(unexecutable(&shown, &error.to_string()), &[], &application))?;
    let cases = cases(&application, &image);
    Ok(Suite { manifest: manifest.to_owned(), application, image, cases, settings })
}

/// Error about an application whose tests cannot be executed. `manifest` is the displayed project file.
fn unexecutable(manifest: &Utf8Path, reason: &str) -> UserError {
    let folder = manifest.parent().filter(|folder| !folder.as_str().is_empty()).unwrap_or(Utf8Path::new("."));
    UserError::new(format!("the tests of `{manifest}` cannot be executed: {reason}"))
        .with_help(format!("val3 check {folder}"))
}

/// Returns the settings in the arguments, completed by the configuration.
///
/// # Errors
/// The configuration has an invalid value.
fn settings(limit: Option<f64>, application: &Application) -> Result<TestSettings, UserError> {
    let configuration = application.project().configuration(application.db());
    let file = configuration.map(|configuration| configuration.file(application.db()));
    let configured = file.and_then(|file| Some((file, file.config.test.limit?)));
    let seconds = match (limit, configured) {
        (Some(seconds), _) => seconds,
        (None, Some((_, seconds))) if LIMITS.contains(&seconds) => seconds,
        (None, Some((file, seconds))) => {
            let message = format!("{seconds} is not a limit of tests: write seconds from 0.004 to 1e6");
            let fault = file.fault("test.limit", message, String::new());
            return Err(SessionError::Load(LoadError::Configuration(vec![fault])).into());
        }
        (None, None) => DEFAULT_LIMIT,
    };
    Ok(TestSettings { limit: nanoseconds(seconds) })
}
