//! Programs and data files with a mistake.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use val3_analysis::items::project::data_files;
use val3_analysis::system::Disk;
use val3_files::FileClass;
use val3_session::Application;
use val3_syntax::encoding;

use super::code_sites::code_sites;
use super::data_sites::{DataSites, data_sites};
use super::original::{Original, Originals};
use super::site::Site;
use super::used_names::UsedNames;

/// A file with a mistake that tests execute or use.
pub(super) struct Mutant {
    /// The file.
    pub(super) file: String,
    /// The project file of its application or library.
    pub(super) project_file: String,
    pub(super) site: Site,
    /// The variable with the value, in a data file: `pal:nCount`.
    pub(super) variable: Option<String>,
    /// The line with the place, without the blanks around it.
    pub(super) source: String,
    /// The numbers of the tests that execute the line or use the variable.
    pub(super) tests: Vec<usize>,
    /// The text of the file without the mistake.
    text: Arc<str>,
}

/// The mistakes that can be tried.
#[derive(Default)]
pub(super) struct Mutants {
    /// By file and place, programs first.
    pub(super) all: Vec<Mutant>,
    /// Variables with values in a file that no test uses, with the names of their projects: `pal:nCount`.
    pub(super) unused: Vec<String>,
}

impl Mutant {
    /// The text of the file with the mistake.
    pub(super) fn text(&self) -> Arc<str> {
        self.site.applied(&self.text).into()
    }
}

/// The mistakes in all lines that tests execute, and in the values of all variables that these lines name.
pub(super) fn mutants(originals: &Originals<'_>) -> Mutants {
    let mut mutants = Mutants::default();
    let mut used: Vec<UsedNames> = originals.tests.iter().map(own_names).collect();
    for (file, program) in originals.coverage.programs() {
        // Only a test has written the others, in the memory of the controller.
        let Some(text) = text(file) else { continue };
        for (test, used) in originals.tests.iter().zip(&mut used) {
            let lines = test.lines.get(file).into_iter().flatten();
            lines.filter_map(|line| text.lines().nth((*line as usize).checked_sub(1)?)).for_each(|line| used.add(line));
        }
        for site in code_sites(&text) {
            let tests = numbers(&originals.tests, |test| test.executes(file, site.line));
            let place = Place { file, project_file: &program.project_file, variable: None, text: &text };
            mutants.add(place, site, tests);
        }
    }
    mutants.add_data(originals, &mut used);
    mutants
}

/// A file that gets mistakes.
#[derive(Clone, Copy)]
struct Place<'p> {
    file: &'p str,
    project_file: &'p str,
    variable: Option<&'p str>,
    text: &'p Arc<str>,
}

/// A data file with its variables.
struct DataFile {
    path: String,
    project_file: String,
    project: String,
    text: Arc<str>,
    variables: Vec<DataSites>,
}

impl Mutants {
    fn add(&mut self, place: Place<'_>, site: Site, tests: Vec<usize>) {
        if tests.is_empty() {
            return;
        }
        self.all.push(Mutant {
            file: place.file.to_owned(),
            project_file: place.project_file.to_owned(),
            variable: place.variable.map(str::to_owned),
            source: site.source(place.text),
            site,
            tests,
            text: Arc::clone(place.text),
        });
    }

    fn add_data(&mut self, originals: &Originals<'_>, used: &mut [UsedNames]) {
        let files = data_of_projects(originals);
        let fathers: Vec<(&str, &[String])> = files
            .iter()
            .flat_map(|file| &file.variables)
            .map(|variable| (variable.name.as_str(), variable.fathers.as_slice()))
            .collect();
        used.iter_mut().for_each(|used| used.add_fathers(&fathers));
        for DataFile { path, project_file, project, text, variables } in &files {
            for DataSites { name, sites, .. } in variables.iter().filter(|variable| !variable.sites.is_empty()) {
                let tests = numbers(used, |used| used.contains(name));
                let variable = format!("{project}:{name}");
                let place = Place { file: path, project_file, variable: Some(&variable), text };
                sites.iter().for_each(|site| self.add(place, site.clone(), tests.clone()));
                if tests.is_empty() {
                    self.unused.push(variable);
                }
            }
        }
    }
}

/// The data files of all projects whose programs were executed.
fn data_of_projects(originals: &Originals<'_>) -> Vec<DataFile> {
    let projects: BTreeMap<&str, &str> = originals
        .coverage
        .programs()
        .map(|(_, program)| (program.project_file.as_str(), program.project.as_str()))
        .collect();
    let mut found = BTreeSet::new();
    let mut files = Vec::new();
    for (project_file, project) in projects {
        // A test has written the others in the memory of the controller.
        let Ok(application) = Application::open(&Disk, project_file.into(), None) else { continue };
        let db = application.db();
        for file in data_files(db, application.project()) {
            let path = file.path(db).to_string();
            let Some(text) = text(&path).filter(|_| found.insert(path.clone())) else { continue };
            let variables = data_sites(&text);
            let (project_file, project) = (project_file.to_owned(), project.to_owned());
            files.push(DataFile { path, project_file, project, text, variables });
        }
    }
    files
}

/// The names in the file of a test: its program, or its scenario.
fn own_names(test: &Original<'_>) -> UsedNames {
    let mut used = UsedNames::default();
    if let Some(text) = text(&test.test.case.file) {
        used.add(&text);
    }
    used
}

fn text(file: &str) -> Option<Arc<str>> {
    let bytes = val3_files::read(file.into(), FileClass::Program).ok()?;
    Some(encoding::decode(bytes).text.into())
}

/// The numbers of the items that are chosen.
fn numbers<T>(items: &[T], is_chosen: impl Fn(&T) -> bool) -> Vec<usize> {
    items.iter().enumerate().filter(|(_, item)| is_chosen(item)).map(|(number, _)| number).collect()
}
