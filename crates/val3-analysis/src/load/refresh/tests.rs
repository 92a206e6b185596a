use std::sync::{Arc, Mutex};

use camino::{Utf8Path, Utf8PathBuf};
use val3_lang::versions::Version;
use val3_test::{Fixture, ROOT};

use super::*;
use crate::db::Sources;
use crate::infer::infer;
use crate::items::project::program_files;
use crate::load::load_into;
use crate::system::Memory;

const CELL: &str = "num nA\nlibrary part \"Disk://part/part.pjx\"\nnA=1\nprogram other()\nbegin\n  nA=2\nend\n\
                    --- part\npublic num nWeight\nprogram pick()\nbegin\n  nWeight=1\nend";

/// A workspace with files that a test changes.
struct Cell {
    files: Vec<(Utf8PathBuf, String)>,
    workspace: Workspace,
    ran: Arc<Mutex<Vec<String>>>,
}

impl Cell {
    /// Versions in the projects' configurations.
    fn versions(&self) -> Vec<Option<Version>> {
        let db = &self.workspace.db;
        self.workspace.projects.iter().map(|project| project.config(db).and_then(|it| it.version)).collect()
    }

    fn new() -> Self {
        let fixture = Fixture::parse(CELL);
        let files: Vec<_> =
            fixture.files.into_iter().map(|(path, text)| (Utf8Path::new(ROOT).join(path), text)).collect();
        let ran = Arc::new(Mutex::new(Vec::new()));
        let log = Arc::clone(&ran);
        let db = Database::observed(move |event| {
            if let salsa::EventKind::WillExecute { database_key } = event.kind {
                log.lock().unwrap().push(format!("{database_key:?}"));
            }
        });
        let workspace = load_into(db, &memory(&files), &[ROOT.into()]).unwrap();
        let cell = Self { files, workspace, ran };
        cell.ask();
        cell.take_ran();
        cell
    }

    fn edit(&mut self, file: &str, from: &str, to: &str) {
        let (_, text) = self.files.iter_mut().find(|(path, _)| path.ends_with(file)).unwrap();
        assert!(text.contains(from), "{text}");
        *text = text.replace(from, to);
    }

    fn refresh(&mut self, stale: &str) -> Vec<ConfigError> {
        self.workspace.refresh(&memory(&self.files), &[ROOT.into()], &|path| path.ends_with(stale))
    }

    /// Infers all programs.
    fn ask(&self) {
        let db = &self.workspace.db;
        let projects: Vec<_> = Sources::get(db).projects(db).values().copied().collect();
        for project in projects {
            program_files(db, project).iter().for_each(|file| _ = infer(db, project, *file));
        }
    }

    /// Returns how many queries with this name ran since the last call.
    fn ran(&self, query: &str) -> usize {
        self.ask();
        self.take_ran().iter().filter(|name| name.starts_with(query)).count()
    }

    fn take_ran(&self) -> Vec<String> {
        std::mem::take(&mut self.ran.lock().unwrap())
    }

    fn paths(&self) -> Vec<String> {
        let db = &self.workspace.db;
        let mut paths: Vec<_> = Sources::get(db).files(db).values().map(|file| file.path(db).to_string()).collect();
        paths.sort();
        paths
    }
}

fn memory(files: &[(Utf8PathBuf, String)]) -> Memory {
    Memory::new(files.iter().cloned())
}

#[test]
fn without_a_change_no_query_runs() {
    let mut cell = Cell::new();
    cell.refresh("");
    assert_eq!(cell.ran(""), 0);
    cell.workspace.refresh(&memory(&cell.files), &[ROOT.into()], &|_| true);
    assert_eq!(cell.ran(""), 0);
}

#[test]
fn an_edit_of_a_program_infers_that_program() {
    let mut cell = Cell::new();
    cell.edit("other.pgx", "nA=2", "nA=3");
    cell.refresh("other.pgx");
    assert_eq!(cell.ran("infer("), 1);
}

#[test]
fn a_file_that_is_not_stale_is_not_read() {
    let mut cell = Cell::new();
    cell.edit("other.pgx", "nA=2", "nA=3");
    cell.refresh("start.pgx");
    assert_eq!(cell.ran(""), 0);
}

#[test]
fn a_comment_in_the_project_file_infers_nothing() {
    let mut cell = Cell::new();
    cell.edit("main.pjx", "<Programs>", "<!-- new --><Programs>");
    cell.refresh("main.pjx");
    let ran = cell.ran("infer(");
    assert_eq!(ran, 0);
}

#[test]
fn an_entry_of_the_project_file_affects_only_its_project() {
    let mut cell = Cell::new();
    cell.edit("main.pjx", "<Program file=\"other.pgx\" />", "");
    cell.refresh("main.pjx");
    assert!(!cell.paths().iter().any(|path| path.ends_with("other.pgx")));
    // Only `start` is left in `main`; `part` is not read.
    assert!(cell.ran("infer(") <= 1);
}

#[test]
fn created_and_deleted_files_are_noticed() {
    let mut cell = Cell::new();
    let before = cell.paths();
    let (path, text) = cell.files.iter().find(|(path, _)| path.ends_with("other.pgx")).cloned().unwrap();
    cell.files.retain(|(known, _)| *known != path);
    cell.refresh("other.pgx");
    assert_eq!(cell.paths().len(), before.len() - 1);
    cell.files.push((path, text));
    cell.refresh("other.pgx");
    assert_eq!(cell.paths(), before);
}

#[test]
fn created_and_deleted_projects_are_noticed() {
    let mut cell = Cell::new();
    let all = cell.files.clone();
    cell.files.retain(|(path, _)| !path.as_str().contains("/part/"));
    cell.workspace.refresh(&memory(&cell.files), &[ROOT.into()], &|_| true);
    assert_eq!(cell.workspace.projects.len(), 1);
    cell.files = all;
    cell.workspace.refresh(&memory(&cell.files), &[ROOT.into()], &|_| true);
    assert_eq!(cell.workspace.projects.len(), 2);
}

#[test]
fn letter_case_makes_no_difference() {
    let mut cell = Cell::new();
    cell.edit("main.pjx", "other.pgx", "OTHER.PGX");
    cell.refresh("main.pjx");
    cell.ask();
    cell.take_ran();
    cell.edit("other.pgx", "nA=2", "nA=3");
    cell.refresh("other.pgx");
    assert_eq!(cell.ran("infer("), 1);
}

#[test]
fn a_file_renamed_in_letter_case_is_the_same() {
    let mut cell = Cell::new();
    let before = cell.paths();
    for (path, _) in &mut cell.files {
        *path = path.as_str().replace("other.pgx", "Other.PGX").into();
    }
    cell.refresh("other.pgx");
    assert_eq!(cell.paths().len(), before.len());
    assert!(cell.paths().iter().any(|path| path.ends_with("/Other.PGX")));
}

#[test]
fn a_faulty_configuration_keeps_its_former_content() {
    let mut cell = Cell::new();
    let path = Utf8Path::new(ROOT).join("val3.toml");
    cell.files.push((path, "version = \"s6.4\"\n".to_owned()));
    assert_eq!(cell.refresh("val3.toml"), []);
    let before = cell.versions();
    assert!(before.iter().all(Option::is_some));
    cell.edit("val3.toml", "s6.4", "nonsense");
    assert_eq!(cell.refresh("val3.toml").len(), 1);
    assert_eq!(cell.versions(), before);
}
