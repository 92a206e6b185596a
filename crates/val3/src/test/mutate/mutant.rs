//! Mutants: programs and data files with a mistake.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use camino::Utf8Path;
use val3_analysis::db::Project;
use val3_analysis::items::project::{data_files, items};
use val3_analysis::system::Disk;
use val3_session::Application;
use val3_suite::{project_name, tested_projects};

use super::code_sites::code_sites;
use super::data_sites::{DataSites, data_sites};
use super::original::{Original, Originals};
use super::site::Site;
use super::used_names::{project_file, text};
use crate::user_error::UserError;

/// File with a mistake that tests execute or use.
pub(super) struct Mutant {
    /// Path of the file.
    pub(super) file: String,
    /// Project file of the application or library.
    pub(super) project_file: String,
    pub(super) site: Site,
    /// Element with the value in a data file, for example `pal:nCount[1]`; `None` in a program.
    pub(super) element: Option<String>,
    /// Line with the mistake, without surrounding blanks.
    pub(super) source: String,
    /// Indices of the tests that execute the line or use the variable.
    pub(super) tests: Vec<usize>,
    /// Original text of the file.
    text: Arc<str>,
}

/// Mistakes that can be tried.
#[derive(Default)]
pub(super) struct Mutants {
    /// Mutants by file and location, programs first.
    pub(super) all: Vec<Mutant>,
    /// Variables with values in a file that no test uses, prefixed by the project, for example `pal:nCount`.
    pub(super) unused: Vec<String>,
}

impl Mutant {
    /// Text of the file with the mistake.
    pub(super) fn text(&self) -> Arc<str> {
        self.site.applied(&self.text).into()
    }
}

/// Collects the mistakes in all lines that tests execute, and in the values of all variables that tests use.
///
/// # Errors
/// An application whose tests were executed can no longer be read.
pub(super) fn mutants(originals: &Originals<'_>) -> Result<Mutants, UserError> {
    let mut mutants = Mutants::default();
    for (file, program) in originals.coverage.programs() {
        // Other programs exist only in the memory of the controller, where a test has written them.
        let Some(text) = text(file).map(Arc::from) else { continue };
        for site in code_sites(&text) {
            let tests = numbers(&originals.tests, |test| test.executes(file, site.line));
            mutants.add(
                MutatedFile { file, project_file: &program.project_file, element: None, text: &text },
                site,
                tests,
            );
        }
    }
    for file in data_of_projects(originals)? {
        mutants.add_data(&originals.tests, &file);
    }
    Ok(mutants)
}

/// File into which mistakes are seeded.
#[derive(Clone, Copy)]
struct MutatedFile<'p> {
    file: &'p str,
    project_file: &'p str,
    element: Option<&'p str>,
    text: &'p Arc<str>,
}

/// Data file with its variables.
struct DataFile {
    path: String,
    project_file: String,
    project: String,
    /// Whether the file declares the fields of a user type.
    is_type: bool,
    text: Arc<str>,
    variables: Vec<DataSites>,
}

impl Mutants {
    fn add(&mut self, place: MutatedFile<'_>, site: Site, tests: Vec<usize>) {
        if tests.is_empty() {
            return;
        }
        self.all.push(Mutant {
            file: place.file.to_owned(),
            project_file: place.project_file.to_owned(),
            element: place.element.map(str::to_owned),
            source: site.source(place.text),
            site,
            tests,
            text: Arc::clone(place.text),
        });
    }

    fn add_data(&mut self, tests: &[Original<'_>], file: &DataFile) {
        let DataFile { path, project_file, project, is_type, text, variables } = file;
        for DataSites { name, sites } in variables.iter().filter(|variable| !variable.sites.is_empty()) {
            let tests = numbers(tests, |test| {
                test.used.contains(project_file, name) || *is_type && test.used.contains_field(name)
            });
            for site in sites {
                let of_project = site.path.as_deref().unwrap_or(name);
                let element = format!("{project}:{}", of_project.split('.').next().unwrap_or(name));
                let place = MutatedFile { file: path, project_file, element: Some(&element), text };
                self.add(place, site.clone(), tests.clone());
            }
            if tests.is_empty() {
                self.unused.push(format!("{project}:{name}"));
            }
        }
    }
}

/// Data files of all tested projects, sorted by path.
fn data_of_projects(originals: &Originals<'_>) -> Result<Vec<DataFile>, UserError> {
    let manifests: BTreeSet<&Utf8Path> = originals.tests.iter().map(|original| original.test.manifest).collect();
    let mut files = BTreeMap::new();
    for manifest in manifests {
        let application = Application::open_with_stand_ins(&Disk, manifest, &BTreeMap::new())?;
        let db = application.db();
        let projects = tested_projects(&application);
        let types: Vec<Project> =
            projects.iter().flat_map(|project| items(db, *project).types.values()).flatten().copied().collect();
        for project in projects {
            for file in data_files(db, project) {
                let (path, is_type) = (file.path(db).to_string(), types.contains(&project));
                let (project_file, project) = (project_file(db, project), project_name(db, project).to_owned());
                let text: Arc<str> = file.text(db).to_string().into();
                let variables = data_sites(&text);
                files.insert(path.clone(), DataFile { path, project_file, project, is_type, text, variables });
            }
        }
    }
    Ok(files.into_values().collect())
}

/// Indices of the chosen items.
fn numbers<T>(items: &[T], is_chosen: impl Fn(&T) -> bool) -> Vec<usize> {
    items.iter().enumerate().filter(|(_, item)| is_chosen(item)).map(|(number, _)| number).collect()
}
