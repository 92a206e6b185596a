//! From paths to a report: the one file that knows how the analysis is asked.

use std::sync::Arc;
use std::time::Instant;

use camino::Utf8Path;
use rayon::ThreadPool;
use rayon::prelude::*;
use rustc_hash::FxHashMap;
use salsa::Database as _;
use val3_analysis::db::{Database, File, FileStatus, Project, Sources, path_key};
use val3_analysis::items;
use val3_analysis::load::Workspace;
use val3_check::diagnostic::{Diagnostic, RelatedNote, Span};
use val3_check::settings::WorkspaceSettings;
use val3_check::{Checked, Unit, check_unit, finish};
use val3_syntax::encoding::Encoding;
use val3_syntax::view::View;

use crate::baseline::KnownFindings;
use crate::code_lines::CodeLines;
use crate::opening::{Opened, Request, open};
use crate::paths::Paths;
use crate::progress::Progress;
use crate::report::{Finding, Place, Related, Report, SourceFile, Statistics};
use crate::user_error::UserError;

/// Pieces of work between which trees that are no longer needed are dropped.
const BATCH: usize = 2048;

/// Checks everything that is asked for.
pub(crate) fn check(request: &Request) -> Result<Report, UserError> {
    let started = Instant::now();
    let Opened { threads, current, paths, mut workspace, settings } = open(request)?;
    let units = val3_check::units(&workspace.db, &workspace.projects);
    let mut checked = check_units(&mut workspace, &units, &settings, &threads);
    let named = request.baseline.as_ref().map(|path| current.join(path));
    let known = KnownFindings { workspace: &workspace, units: &units, selection: &request.selection, paths: &paths };
    let baseline = known.apply(named.as_deref(), request.mode, &mut checked.findings)?;
    let unreadable = workspace.unreadable.iter().map(|(path, reason)| unreadable(path, reason, &paths)).collect();
    let mut translator = Translator::new(&workspace.db, paths);
    let findings = checked.findings.iter().map(|diagnostic| translator.finding(diagnostic)).collect();
    let report = Report {
        silenced: checked.silenced,
        baseline,
        ..Report::new(statistics(&workspace, &threads, started), findings, unreadable)
    };
    // The process is about to end: taking the database apart piece by piece would only cost time.
    std::mem::forget(workspace);
    Ok(report)
}

fn unreadable(folder: &Utf8Path, reason: &str, paths: &Paths) -> UserError {
    UserError::new(format!("cannot read the folder `{}`: {reason}", paths.shown(folder)))
        .with_help("what lies in it was not checked")
}

/// The findings in the order of the files, however many threads there are.
fn check_units(
    workspace: &mut Workspace,
    units: &[Unit],
    settings: &WorkspaceSettings,
    threads: &ThreadPool,
) -> Checked {
    let progress = Progress::new(units.len());
    let check = |db: &mut Database, unit: &Unit| {
        let found = check_unit(db, *unit, settings);
        progress.advance();
        found
    };
    let mut checked = Vec::with_capacity(units.len());
    let mut batches = units.chunks(BATCH).peekable();
    while let Some(batch) = batches.next() {
        let db = workspace.db.clone();
        checked.extend(threads.install(|| batch.par_iter().map_with(db, check).collect::<Vec<_>>()));
        if batches.peek().is_some() {
            forget_trees(&mut workspace.db, batch, threads);
        }
    }
    finish(&workspace.db, units, settings, checked.into_iter().sum())
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
        let disk = project.and_then(|project| project.disk(self.db));
        let disk = disk.or_else(|| manifest.parent()?.parent())?;
        let inside = path.strip_prefix(disk).ok()?;
        Some(format!("Disk://{}", inside.as_str().replace('\\', "/")))
    }

    fn project(&self, manifest: &Utf8Path) -> Option<Project> {
        Sources::get(self.db).projects(self.db).get(&path_key(manifest.as_str())).copied()
    }
}
