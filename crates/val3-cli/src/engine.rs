//! From paths to a report: the one file that knows how the analysis is asked.

use std::collections::BTreeSet;
use std::time::Instant;

use camino::{Utf8Path, Utf8PathBuf};
use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use salsa::Database as _;
use val3_analysis::db::{Database, File, Project, Sources};
use val3_analysis::items;
use val3_analysis::load::{self, Workspace};
use val3_check::diagnostic::Diagnostic;
use val3_check::{Unit, check_unit, finish};

use crate::parallel_disk::ParallelDisk;
use crate::paths::Paths;
use crate::progress::Progress;
use crate::report::{Report, Statistics};
use crate::selection::Selection;
use crate::translation::Translator;
use crate::user_error::UserError;

/// Bytes of stack a thread, ample for the deepest nesting the parser takes.
const STACK_SIZE: usize = 16 << 20;

/// Pieces of work between which trees that are no longer needed are dropped.
const BATCH: usize = 2048;

/// Everything that was asked for, read and ready to be checked.
pub(crate) struct Session {
    pub(crate) workspace: Workspace,
    threads: ThreadPool,
    paths: Paths,
    started: Instant,
}

impl Session {
    /// Reads everything that `asked` leads to; `jobs` threads work on it.
    pub(crate) fn open(asked: &[Utf8PathBuf], jobs: Option<u16>) -> Result<Self, UserError> {
        let started = Instant::now();
        let threads = threads(jobs)?;
        let current = current_folder()?;
        let paths = Paths::new(&folders(asked), &current).within(repository(&current));
        // Only an absolute path shows the `usrapp` above the current folder.
        let absolute: Vec<_> = asked.iter().map(|path| current.join(path)).collect();
        let workspace =
            load::load(&ParallelDisk { threads: &threads }, &absolute).map_err(|error| refused(&error, &paths))?;
        Ok(Self { workspace, threads, paths, started })
    }

    /// The findings in the order of the files, however many threads there are.
    pub(crate) fn diagnostics(&mut self, selection: &Selection) -> Vec<Diagnostic> {
        diagnostics(&mut self.workspace, selection, &self.threads)
    }

    /// The report on what was found.
    pub(crate) fn report(&self, diagnostics: &[Diagnostic]) -> Report {
        let Self { workspace, threads, paths, started } = self;
        let unreadable = workspace.unreadable.iter().map(|(path, reason)| unreadable(path, reason, paths)).collect();
        let mut translator = Translator::new(&workspace.db, paths);
        let findings = diagnostics.iter().map(|diagnostic| translator.finding(diagnostic)).collect();
        let applications = translator.applications(&workspace.projects);
        Report::new(statistics(workspace, threads, *started), applications, findings, unreadable)
    }

    /// The path of a file as people open it.
    pub(crate) fn shown(&self, file: File) -> String {
        self.paths.shown(file.path(&self.workspace.db))
    }

    /// The folders of all files that were read, also of libraries elsewhere.
    pub(crate) fn folders(&self) -> BTreeSet<Utf8PathBuf> {
        let db = &self.workspace.db;
        let files = Sources::get(db).files(db).values();
        files.filter_map(|file| file.path(db).parent()).map(Utf8Path::to_owned).collect()
    }

    /// Ends the session when the process ends: taking the database apart piece by piece would only cost time.
    pub(crate) fn abandon(self) {
        std::mem::forget(self.workspace);
    }
}

fn refused(error: &load::LoadError, paths: &Paths) -> UserError {
    UserError::new(format!("`{}`: {}", paths.shown(&error.path), error.reason))
}

fn unreadable(folder: &Utf8Path, reason: &str, paths: &Paths) -> UserError {
    UserError::new(format!("cannot read the folder `{}`: {reason}", paths.shown(folder)))
        .with_help("what lies in it was not checked")
}

fn diagnostics(workspace: &mut Workspace, selection: &Selection, threads: &ThreadPool) -> Vec<Diagnostic> {
    let units = val3_check::units(&workspace.db, &workspace.projects);
    let progress = Progress::new(units.len());
    let check = |db: &mut Database, unit: &Unit| {
        let mut found = check_unit(db, *unit);
        found.retain(|diagnostic| selection.contains(diagnostic.rule));
        progress.advance();
        found
    };
    let mut found = Vec::new();
    let mut batches = units.chunks(BATCH).peekable();
    while let Some(batch) = batches.next() {
        let db = workspace.db.clone();
        found.extend(threads.install(|| batch.par_iter().map_with(db, check).flatten_iter().collect::<Vec<_>>()));
        if batches.peek().is_some() {
            forget_trees(&mut workspace.db, batch, threads);
        }
    }
    finish(found)
}

/// Evicts the trees of `batch`. They are taken apart while the next batch is checked.
fn forget_trees(db: &mut Database, batch: &[Unit], threads: &ThreadPool) {
    let trees: Vec<_> = batch.iter().map(|unit| items::parse(db, unit.file(db)).green().clone()).collect();
    db.trigger_lru_eviction();
    threads.spawn(move || drop(trees));
}

fn statistics(workspace: &Workspace, threads: &ThreadPool, started: Instant) -> Statistics {
    let count = |db: &mut Database, project: &Project| val3_check::statistics(db, *project);
    let db = workspace.db.clone();
    let projects = &workspace.projects;
    let counted: val3_check::Statistics = threads.install(|| projects.par_iter().map_with(db, count).sum());
    Statistics {
        applications: counted.applications,
        files: counted.files,
        programs: counted.programs,
        code_lines: counted.code_lines,
        seconds: started.elapsed().as_secs_f64(),
    }
}

fn threads(jobs: Option<u16>) -> Result<ThreadPool, UserError> {
    let threads = jobs.map_or(0, usize::from);
    ThreadPoolBuilder::new().num_threads(threads).stack_size(STACK_SIZE).build().map_err(|error| {
        UserError::new(format!("cannot start threads: {error}")).with_help("ask for fewer with --jobs")
    })
}

fn current_folder() -> Result<Utf8PathBuf, UserError> {
    let path = std::env::current_dir().map_err(|error| UserError::new(format!("no current folder: {error}")))?;
    Utf8PathBuf::from_path_buf(path)
        .map_err(|path| UserError::new(format!("the current folder `{}` is not UTF-8", path.display())))
}

/// The nearest folder above `current` that a version control keeps.
fn repository(current: &Utf8Path) -> Option<&Utf8Path> {
    current.ancestors().find(|folder| [".git", ".hg", ".svn"].iter().any(|name| folder.join(name).exists()))
}

/// The folders that were asked for; of a file, the one around it.
fn folders(asked: &[Utf8PathBuf]) -> Vec<Utf8PathBuf> {
    let folder = |path: &Utf8PathBuf| match path.parent() {
        Some(parent) if path.is_file() => parent.to_owned(),
        _ => path.clone(),
    };
    asked.iter().map(folder).collect()
}
