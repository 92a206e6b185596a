//! Results of the analysis for a listing, as text for comparison.

use std::collections::BTreeMap;

use camino::Utf8PathBuf;
use val3_analysis::body::{Expr, ExprId, body};
use val3_analysis::db::{Database, File, FileRange, Project};
use val3_analysis::items::project::{data_files, program_files};
use val3_analysis::load::{Workspace, load};
use val3_analysis::problem::Problem;
use val3_analysis::system::Memory;
use val3_analysis::{data_check, header_check, infer, interfaces, project_check};
use val3_test::{Fixture, ROOT};

/// Returns the files of a listing in memory.
pub(crate) fn memory(listing: &str) -> Memory {
    let fixture = Fixture::parse(listing);
    Memory::new(fixture.files.into_iter().map(|(path, text)| (Utf8PathBuf::from(ROOT).join(path), text)))
}

/// Loads every project of a listing.
pub(crate) fn workspace(listing: &str) -> Workspace {
    load(&memory(listing), &[ROOT.into()]).unwrap()
}

/// Returns the project at `usrapp/FOLDER`.
pub(crate) fn project(workspace: &Workspace, folder: &str) -> Project {
    let db = &workspace.db;
    let is_it = |project: &&Project| relative(project.manifest(db).path(db).parent().unwrap().as_str()) == folder;
    *workspace.projects.iter().find(is_it).unwrap()
}

/// Returns the program called `name`.
pub(crate) fn program(db: &Database, project: Project, name: &str) -> File {
    let is_it = |file: &&File| file.path(db).file_stem() == Some(name);
    *program_files(db, project).iter().find(is_it).unwrap()
}

/// Shows the type of every expression in the program `start` of `main` by line, inner expressions first, without single
/// literals and instruction names. Then shows the faults.
pub(crate) fn types(listing: &str) -> String {
    let workspace = workspace(listing);
    let db = &workspace.db;
    let main = project(&workspace, "main");
    let file = program(db, main, "start");
    let (body, inference) = (body(db, file), infer::infer(db, main, file));
    let text = file.text(db);
    let callees: Vec<ExprId> = body.exprs().filter_map(|(_, expr, _)| callee(expr)).collect();
    let mut lines: BTreeMap<usize, Vec<String>> = BTreeMap::new();
    for (id, _, range) in body.exprs().filter(|(id, expr, _)| !callees.contains(id) && !is_literal(expr)) {
        let line = text[..usize::from(range.start())].matches('\n').count();
        lines.entry(line).or_default().push(format!("{}: {}", &text[range], inference.ty(id).display(db)));
    }
    let faults = infer::problems(db, main, file);
    let faults = faults.iter().map(|problem| format!("! {}: {:?}", &text[problem.place.range], problem.kind));
    lines.values().map(|line| line.join(" | ")).chain(faults).map(|line| line + "\n").collect()
}

fn callee(expr: &Expr) -> Option<ExprId> {
    match expr {
        Expr::Call(callee, _) => Some(*callee),
        _ => None,
    }
}

fn is_literal(expr: &Expr) -> bool {
    matches!(expr, Expr::Number(_) | Expr::String(_) | Expr::Bool(_))
}

/// Shows every fault of every project with its locations.
pub(crate) fn faults(listing: &str) -> String {
    faults_in(&workspace(listing))
}

/// Shows every fault of the requested projects.
pub(crate) fn faults_in(workspace: &Workspace) -> String {
    let db = &workspace.db;
    let mut problems = Vec::new();
    for &project in &workspace.projects {
        problems.extend_from_slice(project_check::problems(db, project));
        problems.extend_from_slice(interfaces::problems(db, project));
        for &file in data_files(db, project) {
            problems.extend_from_slice(data_check::problems(db, project, file));
        }
        for &file in program_files(db, project) {
            problems.extend_from_slice(header_check::problems(db, project, file));
            problems.extend_from_slice(infer::problems(db, project, file));
        }
    }
    problems.iter().map(|problem| show(db, problem)).collect()
}

fn show(db: &Database, problem: &Problem) -> String {
    let related = problem.related.iter().map(|other| format!("    {:?} {}\n", other.role, place(db, other.place)));
    format!("{} {:?}\n{}", place(db, problem.place), problem.kind, related.collect::<String>())
}

/// Formats a location, for example `main/start.pgx:3 text`.
fn place(db: &Database, place: FileRange) -> String {
    let text = place.file.text(db);
    let line = 1 + text[..usize::from(place.range.start())].matches('\n').count();
    let shown = text[place.range].lines().next().unwrap_or("");
    format!("{}:{line} `{shown}`", relative(place.file.path(db).as_str()))
}

fn relative(path: &str) -> &str {
    let path = path.strip_prefix(ROOT).unwrap_or(path).trim_start_matches('/');
    path.strip_prefix("usrapp/").unwrap_or(path)
}
