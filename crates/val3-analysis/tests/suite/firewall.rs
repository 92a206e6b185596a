//! Recomputation after an edit: a program's code affects only this program.

use std::sync::{Arc, Mutex};

use salsa::Setter;
use val3_analysis::db::{Database, File, Project};
use val3_analysis::items::project::{data_files, program_files};
use val3_analysis::load::{Workspace, load_into};
use val3_analysis::{data_check, header_check, infer, interfaces, project_check};

use crate::show::{memory, program, project};

const LISTING: &str = r#"
library part "Disk://part/part.pjx"
type Slot "Disk://Slot/Slot.pjx"
num nA = 1
num nB[3]
Slot tA
program first(num x_n)
begin
  nA=x_n+part:nWeight+tA.nCount
  nB[7]=1
end
program second()
begin
  call first(nA)
  call first("one")
  call part:grip()
end
program third()
begin
  nB[7]=nMissing
end
--- part
public num nWeight
public program grip()
begin
  nWeight=1
end
--- Slot
public num nCount
"#;

/// A checked workspace, and the queries that have run since.
struct Watched {
    workspace: Workspace,
    log: Arc<Mutex<Vec<String>>>,
}

impl Watched {
    fn new() -> Self {
        let log = Arc::new(Mutex::new(Vec::new()));
        let seen = Arc::clone(&log);
        let db = Database::observed(move |event| {
            if let salsa::EventKind::WillExecute { database_key } = event.kind {
                seen.lock().unwrap().push(format!("{database_key:?}"));
            }
        });
        let workspace = load_into(db, &memory(LISTING), &[val3_test::ROOT.into()]).unwrap();
        let watched = Self { workspace, log };
        watched.check();
        watched
    }

    /// Checks everything. Returns the queries that ran.
    fn check(&self) -> Vec<String> {
        self.log.lock().unwrap().clear();
        let db = &self.workspace.db;
        for &project in &self.workspace.projects {
            project_check::problems(db, project);
            interfaces::problems(db, project);
            for &file in data_files(db, project) {
                data_check::problems(db, project, file);
            }
            for &file in program_files(db, project) {
                header_check::problems(db, project, file);
                infer::problems(db, project, file);
            }
        }
        self.log.lock().unwrap().clone()
    }

    fn project(&self, folder: &str) -> Project {
        project(&self.workspace, folder)
    }

    fn data(&self, folder: &str) -> File {
        data_files(&self.workspace.db, self.project(folder))[0]
    }

    fn program(&self, folder: &str, name: &str) -> File {
        program(&self.workspace.db, self.project(folder), name)
    }

    /// Replaces `old` in the file. Returns the number of programs whose types are inferred again.
    fn edit(&mut self, file: File, old: &str, new: &str) -> usize {
        let text = file.text(&self.workspace.db);
        assert!(text.contains(old), "{text}");
        let text = text.replacen(old, new, 1);
        file.set_text(&mut self.workspace.db).to(text.into());
        self.check().iter().filter(|query| query.starts_with("infer(")).count()
    }
}

#[test]
fn nothing_runs_twice() {
    let watched = Watched::new();
    assert!(watched.check().is_empty());
}

#[test]
fn a_body_concerns_its_program_alone() {
    let mut watched = Watched::new();
    let first = watched.program("main", "first");
    assert_eq!(watched.edit(first, "nA=x_n", "nA=2*x_n"), 1);
    assert_eq!(watched.edit(first, "begin", "begin\n  // longer\n"), 1);
    let second = watched.program("main", "second");
    assert_eq!(watched.edit(second, "first(nA)", "first(nB)"), 1);
}

#[test]
fn a_body_that_resizes_data_concerns_its_program_alone() {
    let mut watched = Watched::new();
    let second = watched.program("main", "second");
    assert_eq!(watched.edit(second, "call part:grip()", "append(nB)"), 1);
    let third = watched.program("main", "third");
    let left = infer::problems(&watched.workspace.db, watched.project("main"), third);
    assert_eq!(left.len(), 1, "only nMissing: nB may have grown");
}

#[test]
fn a_body_with_a_broken_line_concerns_its_program_alone() {
    let mut watched = Watched::new();
    let first = watched.program("main", "first");
    assert_eq!(watched.edit(first, "nA=x_n", "nA=(((x_n"), 1);
    assert_eq!(watched.edit(first, "\nend]]>", "\n  if nA\nend]]>"), 1);
}

#[test]
fn values_and_comments_of_data_concern_no_program() {
    let mut watched = Watched::new();
    let data = watched.data("main");
    assert_eq!(watched.edit(data, "value=\"1\"", "value=\"22\""), 0);
    assert_eq!(watched.edit(data, "</Datas>", "<!-- text --></Datas>"), 0);
}

#[test]
fn what_data_declares_concerns_the_project() {
    let mut watched = Watched::new();
    let data = watched.data("main");
    assert_eq!(watched.edit(data, "type=\"num\" size=\"3\"", "type=\"string\" size=\"3\""), 3);
    let slot = watched.data("Slot");
    assert!(watched.edit(slot, "type=\"num\"", "type=\"bool\"") >= 1);
    let part = watched.data("part");
    assert!(watched.edit(part, "access=\"public\"", "access=\"private\"") >= 1);
}

#[test]
fn a_header_concerns_its_program_and_its_callers() {
    let mut watched = Watched::new();
    let first = watched.program("main", "first");
    assert_eq!(watched.edit(first, "type=\"num\"", "type=\"string\""), 2);
    let grip = watched.program("part", "grip");
    assert_eq!(watched.edit(grip, "access=\"public\"", "access=\"private\""), 2);
}

#[test]
fn a_project_file_concerns_programs_only_where_names_change() {
    let mut watched = Watched::new();
    let manifest = watched.project("main").manifest(&watched.workspace.db);
    assert_eq!(watched.edit(manifest, "stackSize=\"5000\"", "stackSize=\"6000\""), 0);
    assert_eq!(watched.edit(manifest, "alias=\"part\"", "alias=\"prat\""), 3);
}
