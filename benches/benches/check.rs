//! Check of a large workspace: `cargo bench --bench check`.
//!
//! Targets on an ordinary machine with two cores, for 100,000 code lines:
//! - `cold`: reading and checking all files, 500,000 code lines/s;
//! - `edited_body`: checking one program after an edit in its code, under 1 ms;
//! - `edited_body_everywhere`: computing the findings of the entire workspace after such an edit.
//!
//! Memory has to stay under 100 MB; `cargo xtask metrics` measures it for the command.

#![allow(missing_docs, reason = "benchmarks are named by their functions")]
#![allow(clippy::expect_used, reason = "a benchmark may fail loudly")]

use std::sync::Arc;

use camino::{Utf8Path, Utf8PathBuf};
use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use rayon::prelude::*;
use salsa::Setter as _;
use val3_analysis::db::{Database, File};
use val3_analysis::load::{self, Workspace};
use val3_analysis::system::Disk;
use val3_check::settings::WorkspaceSettings;
use val3_check::{CheckUnit, check_unit, units};

const CODE_LINES: usize = 100_000;

fn main() {
    divan::main();
}

/// A generated workspace on the disk, which is removed at the end.
struct Written {
    folder: tempfile::TempDir,
    code_lines: usize,
}

impl Written {
    fn new() -> Self {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = Utf8Path::from_path(folder.path()).expect("a path in UTF-8");
        let workspace = val3_benches::generated(CODE_LINES);
        let code_lines = xtask::workspace::write(path, &workspace).expect("a folder that can be written");
        Self { folder, code_lines }
    }

    fn load(&self) -> Workspace {
        let path = Utf8PathBuf::from_path_buf(self.folder.path().to_owned()).expect("a path in UTF-8");
        load::load(&Disk, &[path]).expect("a workspace with projects")
    }
}

/// Returns the number of findings, which is 0.
fn check_all(db: &Database, units: &[CheckUnit]) -> usize {
    let settings = WorkspaceSettings::default();
    units.par_iter().map_with(db.clone(), |db, unit| check_unit(db, *unit, &settings).findings.len()).sum()
}

#[divan::bench(sample_count = 10)]
fn cold(bencher: Bencher<'_, '_>) {
    let written = Written::new();
    bencher.counter(ItemsCount::new(written.code_lines)).bench_local(|| {
        let workspace = written.load();
        let units = units(&workspace.db, &workspace.projects);
        assert_eq!(check_all(&workspace.db, &units), 0, "the generated workspace has faults");
        // Releasing the memory is not part of the work, because the command ends here.
        std::mem::forget(black_box(workspace));
    });
}

/// A checked workspace with a program that is edited repeatedly.
struct Edited {
    workspace: Workspace,
    units: Vec<CheckUnit>,
    unit: CheckUnit,
    file: File,
    text: String,
    edits: usize,
}

impl Edited {
    fn new() -> Self {
        let workspace = Written::new().load();
        let units = units(&workspace.db, &workspace.projects);
        check_all(&workspace.db, &units);
        let longest = units.iter().filter_map(|unit| match unit {
            CheckUnit::Program(_, file) => Some((*unit, *file)),
            _ => None,
        });
        let length = |file: File| file.text(&workspace.db).len();
        let (unit, file) = longest.max_by_key(|(_, file)| length(*file)).expect("a program");
        let text = file.text(&workspace.db).to_string();
        Self { workspace, units, unit, file, text, edits: 0 }
    }

    /// Writes another number into a line of the code.
    fn edit(&mut self) {
        self.edits += 1;
        let line = format!("\n  delay({})\nend]]>", self.edits);
        let text = self.text.replace("\nend]]>", &line);
        self.file.set_text(&mut self.workspace.db).to(Arc::from(text));
    }
}

#[divan::bench(sample_count = 100)]
fn edited_body(bencher: Bencher<'_, '_>) {
    let mut edited = Edited::new();
    bencher.bench_local(|| {
        edited.edit();
        black_box(check_unit(&edited.workspace.db, edited.unit, &WorkspaceSettings::default()))
    });
}

#[divan::bench(sample_count = 20)]
fn edited_body_everywhere(bencher: Bencher<'_, '_>) {
    let mut edited = Edited::new();
    bencher.bench_local(|| {
        edited.edit();
        black_box(check_all(&edited.workspace.db, &edited.units))
    });
}
