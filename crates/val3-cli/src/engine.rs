//! From a request to findings: the one file that knows how the analysis is asked.

use std::collections::BTreeSet;
use std::time::Instant;

use camino::{Utf8Path, Utf8PathBuf};
use rayon::ThreadPool;
use rayon::prelude::*;
use salsa::Database as _;
use val3_analysis::db::{Database, File, Project, Sources};
use val3_analysis::items;
use val3_analysis::load::Workspace;
use val3_check::diagnostic::Diagnostic;
use val3_check::settings::WorkspaceSettings;
use val3_check::{Checked, Unit, check_unit, finish};

use crate::baseline::{KnownFindings, Outcome};
use crate::opening::{Opened, Request, open};
use crate::paths::Paths;
use crate::progress::Progress;
use crate::report::{Report, Statistics};
use crate::translation::Translator;
use crate::user_error::UserError;

/// Pieces of work between which trees that are no longer needed are dropped.
const BATCH: usize = 768;

/// Findings that are translated together: those of a file stand together, and share what is known of it.
const CHUNK: usize = 32;

/// Everything that was asked for, read and ready to be checked.
pub(crate) struct Session<'r> {
    request: &'r Request,
    opened: Opened,
    started: Instant,
}

/// What one check of a session gives.
pub(crate) struct Outcomes {
    /// The findings in the order of the files, however many threads there are; without those that are known.
    pub(crate) diagnostics: Vec<Diagnostic>,
    silenced: usize,
    baseline: Outcome,
}

impl<'r> Session<'r> {
    /// Reads everything that is asked for.
    pub(crate) fn open(request: &'r Request) -> Result<Self, UserError> {
        let started = Instant::now();
        Ok(Self { request, opened: open(request)?, started })
    }

    /// Checks everything.
    pub(crate) fn check(&mut self) -> Result<Outcomes, UserError> {
        let Self { request, opened: Opened { threads, current, paths, workspace, settings }, .. } = self;
        let units = units(workspace, threads);
        let mut checked = check_units(workspace, &units, settings, threads);
        let named = request.baseline.as_ref().map(|path| current.join(path));
        let known = KnownFindings { workspace, units: &units, selection: &request.selection, paths };
        let baseline = known.apply(named.as_deref(), request.mode, &mut checked.findings)?;
        Ok(Outcomes { diagnostics: checked.findings, silenced: checked.silenced, baseline })
    }

    /// The report on what was found.
    pub(crate) fn report(&self, outcomes: Outcomes) -> Report {
        let Opened { threads, paths, workspace, .. } = &self.opened;
        let unreadable = workspace.unreadable.iter().map(|(path, reason)| unreadable(path, reason, paths)).collect();
        let translator = Translator::new(workspace.db.clone(), paths);
        let applications = translator.applications(&workspace.projects);
        let translated = outcomes.diagnostics.par_iter().with_min_len(CHUNK).map_with(translator, Translator::finding);
        let findings = threads.install(|| translated.collect());
        Report {
            silenced: outcomes.silenced,
            baseline: outcomes.baseline,
            ..Report::new(statistics(workspace, threads, self.started), applications, findings, unreadable)
        }
    }

    /// What was read.
    pub(crate) fn db(&self) -> &Database {
        &self.opened.workspace.db
    }

    /// As [`db`](Self::db), to be changed.
    pub(crate) fn db_mut(&mut self) -> &mut Database {
        &mut self.opened.workspace.db
    }

    /// The path of a file as people open it.
    pub(crate) fn shown(&self, file: File) -> String {
        self.opened.paths.shown(file.path(self.db()))
    }

    /// The folders of all files that were read, also of libraries elsewhere.
    pub(crate) fn folders(&self) -> BTreeSet<Utf8PathBuf> {
        let files = Sources::get(self.db()).files(self.db()).values();
        files.filter_map(|file| file.path(self.db()).parent()).map(Utf8Path::to_owned).collect()
    }

    /// Ends the session when the process ends: taking the database apart piece by piece would only cost time.
    pub(crate) fn abandon(self) {
        std::mem::forget(self.opened.workspace);
    }
}

fn unreadable(folder: &Utf8Path, reason: &str, paths: &Paths) -> UserError {
    UserError::new(format!("cannot read the folder `{}`: {reason}", paths.shown(folder)))
        .with_help("what lies in it was not checked")
}

/// The pieces of work, in the order of the projects.
fn units(workspace: &Workspace, threads: &ThreadPool) -> Vec<Unit> {
    let units = |db: &mut Database, project: &Project| val3_check::units(db, std::slice::from_ref(project));
    let found = workspace.projects.par_iter().map_with(workspace.db.clone(), units);
    threads.install(|| found.flatten_iter().collect())
}

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
    let mut batches = batches(units).into_iter().peekable();
    while let Some(batch) = batches.next() {
        let db = workspace.db.clone();
        checked.extend(threads.install(|| batch.par_iter().map_with(db, check).collect::<Vec<_>>()));
        if batches.peek().is_some() {
            forget_trees(&mut workspace.db, batch, threads);
        }
    }
    finish(&workspace.db, units, settings, checked.into_iter().sum())
}

/// Pieces of about [`BATCH`] units. The units of a project stay together, since each asks about all of it.
fn batches(units: &[Unit]) -> Vec<&[Unit]> {
    let mut batches = Vec::new();
    let mut rest = units;
    while !rest.is_empty() {
        let last = rest.get(BATCH.min(rest.len()) - 1).map(|unit| unit.project());
        let len = rest
            .iter()
            .skip(BATCH)
            .position(|unit| Some(unit.project()) != last)
            .map_or(rest.len(), |more| BATCH + more);
        let (batch, behind) = rest.split_at(len);
        batches.push(batch);
        rest = behind;
    }
    batches
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
