//! Coverage of the programs in a controller's memory.

use std::collections::BTreeMap;

use val3_analysis::db::{Database, Project, Sources};
use val3_analysis::paths::path_key;
use val3_analysis::test_applications::has_tests;
use val3_bytecode::{Image, Program};
use val3_coverage::{Branch, Coverage, ProgramCoverage, Side};
use val3_lang::test_names::{is_executed, is_test_application};
use val3_machine::controller::Controller;
use val3_session::Application;

use crate::library::NAME;

/// Returns the execution counts of tested programs since a controller's initial state: programs in loaded applications
/// and libraries, without test applications, tests and `val3assert`.
#[must_use]
pub fn counted(controller: &Controller, application: &Application) -> Coverage {
    of_programs(controller, |image, program| {
        is_tested(image, application) && !(is_listed(image, application) && is_executed(&program.name))
    })
}

/// Returns the execution counts of all programs, also of tests and `val3assert`.
#[must_use]
pub fn executed(controller: &Controller) -> Coverage {
    of_programs(controller, |_, _| true)
}

/// Returns the tested projects: all projects of an application except test applications and `val3assert`.
#[must_use]
pub fn tested_projects(application: &Application) -> Vec<Project> {
    let db = application.db();
    Sources::get(db).projects(db).values().copied().filter(|project| is_tested_project(db, *project)).collect()
}

fn is_tested_project(db: &Database, project: Project) -> bool {
    let name = project_name(db, project);
    name != NAME && !project.is_below_tests(db) && !is_test_application(name)
}

/// Returns the name of a project: its file name without the extension.
pub fn project_name(db: &Database, project: Project) -> &str {
    project.manifest(db).path(db).file_stem().unwrap_or_default()
}

fn of_programs(controller: &Controller, is_wanted: impl Fn(&Image, &Program) -> bool) -> Coverage {
    let mut coverage = Coverage::default();
    for (image, hits) in controller.vm.space.counts.images() {
        let counted = image.programs.iter().filter(|program| program.counters.count > 0);
        for program in counted.filter(|program| is_wanted(image, program)) {
            let file = image.files.get(program.file as usize).cloned().unwrap_or_default();
            coverage.add(file, counts(image, program, hits));
        }
    }
    coverage
}

/// Whether coverage includes an image: neither its name nor its folder marks it as a test application, and it is not
/// `val3assert`. A library that only a test has written is no project of the application.
fn is_tested(image: &Image, application: &Application) -> bool {
    let is_of_tests = project(image, application).is_some_and(|project| project.is_below_tests(application.db()));
    image.name != NAME && !is_of_tests && !is_test_application(&image.name)
}

/// Whether `val3.toml` lists an image as an application that also contains tests. Its other programs are tested
/// programs.
fn is_listed(image: &Image, application: &Application) -> bool {
    project(image, application).is_some_and(|project| has_tests(application.db(), project))
}

fn project(image: &Image, application: &Application) -> Option<Project> {
    let db = application.db();
    Sources::get(db).projects(db).get(&path_key(&image.path)).copied()
}

fn counts(image: &Image, program: &Program, hits: &[u64]) -> ProgramCoverage {
    let first = program.counters.first as usize;
    let hits = |counter: u16| hits.get(first + usize::from(counter)).copied().unwrap_or_default();
    let mut lines = BTreeMap::new();
    for (row, counter) in program.counted_lines() {
        let count: &mut u64 = lines.entry(row).or_default();
        *count = hits(counter).max(*count);
    }
    let branches = program.counters.branches.iter().map(|branch| {
        let sides = branch.sides.iter().map(|side| Side { name: side.name.clone(), hits: hits(side.counter) });
        Branch { line: branch.row, sides: sides.collect() }
    });
    ProgramCoverage {
        project: image.name.clone(),
        project_file: image.path.clone(),
        program: program.name.clone(),
        lines,
        branches: branches.collect(),
        source: Vec::new(),
    }
}
