//! From paths to a report: the one file that knows how the analysis is asked.

use std::sync::Arc;
use std::time::Instant;

use camino::{Utf8Path, Utf8PathBuf};
use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use rustc_hash::FxHashMap;
use salsa::Database as _;
use val3_analysis::db::{Database, File, FileStatus, Project, Sources, path_key};
use val3_analysis::items;
use val3_analysis::load::{self, Workspace};
use val3_check::diagnostic::{Diagnostic, RelatedNote, Span};
use val3_check::{Asked, Unit, check_unit_with, finish};
use val3_syntax::encoding::Encoding;
use val3_syntax::view::View;

use crate::code_lines::CodeLines;
use crate::parallel_disk::ParallelDisk;
use crate::paths::Paths;
use crate::progress::Progress;
use crate::report::{Finding, Place, Related, Report, SourceFile, Statistics};
use crate::selection::Selection;
use crate::user_error::UserError;

/// Bytes of stack a thread, ample for the deepest nesting the parser takes.
const STACK_SIZE: usize = 16 << 20;

/// Pieces of work between which trees that are no longer needed are dropped.
const BATCH: usize = 2048;

/// Checks everything that `asked` leads to, on `jobs` threads.
pub(crate) fn check(asked: &[Utf8PathBuf], selection: &Selection, jobs: Option<u16>) -> Result<Report, UserError> {
    let started = Instant::now();
    let threads = threads(jobs)?;
    let current = current_folder()?;
    let paths = Paths::new(&folders(asked), &current);
    // Only an absolute path shows the `usrapp` above the current folder.
    let absolute: Vec<_> = asked.iter().map(|path| current.join(path)).collect();
    let mut workspace =
        load::load(&ParallelDisk { threads: &threads }, &absolute).map_err(|error| refused(&error, &paths))?;
    let diagnostics = diagnostics(&mut workspace, selection, &threads);
    let unreadable = workspace.unreadable.iter().map(|(path, reason)| unreadable(path, reason, &paths)).collect();
    let mut translator = Translator::new(&workspace.db, paths);
    let findings = diagnostics.iter().map(|diagnostic| translator.finding(diagnostic)).collect();
    let report = Report::new(statistics(&workspace, &threads, started), findings, unreadable);
    // The process is about to end: taking the database apart piece by piece would only cost time.
    std::mem::forget(workspace);
    Ok(report)
}

fn refused(error: &load::LoadError, paths: &Paths) -> UserError {
    UserError::new(format!("`{}`: {}", paths.shown(&error.path), error.reason))
}

fn unreadable(folder: &Utf8Path, reason: &str, paths: &Paths) -> UserError {
    UserError::new(format!("cannot read the folder `{}`: {reason}", paths.shown(folder)))
        .with_help("what lies in it was not checked")
}

/// The findings in the order of the files, however many threads there are.
fn diagnostics(workspace: &mut Workspace, selection: &Selection, threads: &ThreadPool) -> Vec<Diagnostic> {
    let units = val3_check::units(&workspace.db, &workspace.projects);
    let progress = Progress::new(units.len());
    let asked = Asked { rules: selection.switched_on(), ..Asked::default() };
    let check = |db: &mut Database, unit: &Unit| {
        let mut found = check_unit_with(db, *unit, asked);
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

/// The folders that were asked for; of a file, the one around it.
fn folders(asked: &[Utf8PathBuf]) -> Vec<Utf8PathBuf> {
    let folder = |path: &Utf8PathBuf| match path.parent() {
        Some(parent) if path.is_file() => parent.to_owned(),
        _ => path.clone(),
    };
    asked.iter().map(folder).collect()
}

/// Turns diagnostics into findings; each file is indexed once.
struct Translator<'a> {
    db: &'a Database,
    paths: Paths,
    files: FxHashMap<File, Indexed>,
}

#[derive(Clone)]
struct Indexed {
    source: Arc<SourceFile>,
    codes: Arc<CodeLines>,
}

impl<'a> Translator<'a> {
    fn new(db: &'a Database, paths: Paths) -> Self {
        Self { db, paths, files: FxHashMap::default() }
    }

    fn finding(&mut self, diagnostic: &Diagnostic) -> Finding {
        let Indexed { source, codes } = self.indexed(diagnostic.place.file, diagnostic.application);
        let place = Place { file: source, range: diagnostic.place.range.into() };
        Finding {
            code: diagnostic.rule.code,
            name: diagnostic.rule.name,
            severity: diagnostic.severity.into(),
            message: diagnostic.message.clone(),
            label: diagnostic.label.clone(),
            help: diagnostic.help.clone(),
            program: diagnostic.program.clone(),
            code_line: codes.line(place.range.start, &place.file.lines),
            application: diagnostic.application.map(|file| self.paths.relative(file.path(self.db))),
            related: diagnostic.related.iter().map(|note| self.related(note, diagnostic.application)).collect(),
            fixable: diagnostic.fix.is_some(),
            place,
        }
    }

    fn related(&mut self, note: &RelatedNote, application: Option<File>) -> Related {
        let Span { file, range } = note.place;
        let file = self.indexed(file, application).source;
        Related { place: Place { file, range: range.into() }, message: note.message.clone() }
    }

    fn indexed(&mut self, file: File, application: Option<File>) -> Indexed {
        if let Some(indexed) = self.files.get(&file) {
            return indexed.clone();
        }
        let indexed = self.index(file, application);
        self.files.insert(file, indexed.clone());
        indexed
    }

    fn index(&self, file: File, application: Option<File>) -> Indexed {
        let path = file.path(self.db);
        let mut source =
            SourceFile::new(&self.paths.relative(path), Arc::clone(file.text(self.db)), self.encoding(file));
        source.shown = self.paths.shown(path);
        source.disk = application.and_then(|application| self.on_controller(path, application));
        let parse = items::parse(self.db, file);
        Indexed { source: Arc::new(source), codes: Arc::new(CodeLines::new(View::root(parse.green()))) }
    }

    fn encoding(&self, file: File) -> Encoding {
        match file.status(self.db) {
            FileStatus::Read { encoding, .. } => *encoding,
            FileStatus::Unreadable(_) => Encoding::Utf8,
        }
    }

    /// `Disk://app/prog.pgx`; where nothing tells what `Disk://` is, the folder around the application.
    fn on_controller(&self, path: &Utf8Path, application: File) -> Option<String> {
        let manifest = application.path(self.db);
        let project = self.project(manifest);
        let disk = project.and_then(|project| project.disk(self.db).as_deref());
        let disk = disk.or_else(|| manifest.parent()?.parent())?;
        let inside = path.strip_prefix(disk).ok()?;
        Some(format!("Disk://{}", inside.as_str().replace('\\', "/")))
    }

    fn project(&self, manifest: &Utf8Path) -> Option<Project> {
        Sources::get(self.db).projects(self.db).get(&path_key(manifest.as_str())).copied()
    }
}
