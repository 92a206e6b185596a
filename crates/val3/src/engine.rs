//! Runs the analysis for a request. No other file of this crate starts an analysis.

use std::collections::BTreeSet;
use std::sync::Arc;
use std::time::Instant;

use camino::{Utf8Path, Utf8PathBuf};
use rayon::ThreadPool;
use rayon::prelude::*;
use salsa::{Database as _, Setter as _};
use val3_analysis::db::{Database, Db, Project, Sources};
use val3_analysis::items::project::folder;
use val3_analysis::items::unlisted::{is_data, is_program};
use val3_analysis::load::{Workspace, loads_alike};
use val3_analysis::paths::path_key;
use val3_check::diagnostic::Diagnostic;
use val3_check::settings::{RuleSelection, WorkspaceSettings};
use val3_check::{CheckStatistics, CheckUnit, Checked, check_unit, finish};

use crate::baseline::{BaselineResult, KnownFindings, Mode};
use crate::loose::LooseFiles;
use crate::opening::{EditedTexts, OpenRequest, OpenedWorkspace, open, open_workspace, system};
use crate::paths::Paths;
use crate::progress::DelayedProgress;
use crate::report::{CheckReport, ReportStatistics};
use crate::scope::ReportFilter;
use crate::translation::Translator;
use crate::unread::{Unread, is_unreadable};
use crate::user_error::UserError;
use crate::write_scope::WriteScope;

/// Number of units after which unused program code is freed. Allocating new memory would take longer than freeing and
/// reusing it.
const BATCH: usize = 1500;

/// Number of findings that are translated in one task. Findings of a file are adjacent and share its line index.
const CHUNK: usize = 32;

/// The loaded files of a request, ready to be checked.
pub(crate) struct Session<'r> {
    request: &'r OpenRequest,
    opened: OpenedWorkspace,
    started: Instant,
    /// Texts that were changed after loading.
    edited: EditedTexts,
}

/// Function that processes the findings of all units.
type Finish = fn(&dyn Db, &[CheckUnit], &WorkspaceSettings, Checked) -> Checked;

/// Result of a session's check.
pub(crate) struct CheckResult {
    /// New findings in file order, for any number of threads.
    pub(crate) diagnostics: Vec<Diagnostic>,
    silenced: usize,
    baseline: BaselineResult,
    /// Files and folders that could not be read and have no finding.
    unread: Vec<UserError>,
}

impl<'r> Session<'r> {
    /// Loads all files of the request.
    pub(crate) fn open(request: &'r OpenRequest) -> Result<Self, UserError> {
        let started = Instant::now();
        Ok(Self { request, opened: open(request)?, started, edited: EditedTexts::default() })
    }

    /// As [`open`](Self::open), with a workspace that was loaded before.
    pub(crate) fn with_workspace(request: &'r OpenRequest, workspace: Workspace) -> Result<Self, UserError> {
        let started = Instant::now();
        let opened = open_workspace(request, workspace)?;
        Ok(Self { request, opened, started, edited: EditedTexts::default() })
    }

    /// Releases the workspace for another use.
    pub(crate) fn into_workspace(self) -> Workspace {
        self.opened.workspace
    }

    /// Checks the requested projects.
    pub(crate) fn check(&mut self) -> Result<CheckResult, UserError> {
        self.check_with(finish)
    }

    /// As [`check`](Self::check), but with all occurrences of findings that are reported once per application, and
    /// without findings that require the whole application.
    pub(crate) fn occurrences(&mut self) -> Result<CheckResult, UserError> {
        self.check_with(|_, _, _, found| found)
    }

    fn check_with(&mut self, finish: Finish) -> Result<CheckResult, UserError> {
        let Self {
            request,
            opened: OpenedWorkspace { threads, current, paths, workspace, settings, scope, loose, .. },
            ..
        } = self;
        let projects = workspace.projects.clone();
        let mut units = units(workspace, &projects, threads);
        units.retain(|unit| !(matches!(unit, CheckUnit::Project(_)) && loose.stands_in(&workspace.db, unit.project())));
        units.extend(scope.unlisted(&workspace.db, &projects));
        let progress = DelayedProgress::new("checking", units.len(), !request.quiet);
        let mut found = check_units(workspace, &units, settings, threads, scope, &progress);
        found.findings.extend(loose.findings(workspace, settings, paths));
        units.retain(|unit| scope.covers(&workspace.db, unit.project(), unit.file(&workspace.db)));
        let mut checked = finish(&workspace.db, &units, settings, found);
        let named = request.baseline.as_ref().map(|path| current.join(path));
        let unread = Unread::new(workspace, &units, paths);
        let known = KnownFindings { workspace, units: &units, selection: &request.selection, paths };
        // A baseline is not rewritten if files could not be read, because their findings are unknown.
        let mode = if unread.is_empty() { request.mode } else { Mode::Use };
        let baseline = known.apply(named.as_deref(), mode, &mut checked.findings)?;
        let unread = unread.into_errors(mode != request.mode);
        Ok(CheckResult { diagnostics: checked.findings, silenced: checked.silenced, baseline, unread })
    }

    /// Findings with which the controller's compiler rejects the requested projects in these folders, which are absolute.
    pub(crate) fn refusals(&self, folders: &[Utf8PathBuf]) -> Vec<Diagnostic> {
        let db = self.db();
        let projects = self.opened.workspace.projects.iter().copied();
        let projects = projects.filter(|project| folders.iter().any(|known| known == folder(db, *project)));
        projects.flat_map(|project| val3_check::refusals(db, project)).collect()
    }

    /// Whether one of the requested projects is in this folder, which is absolute.
    pub(crate) fn has_project(&self, known: &Utf8Path) -> bool {
        self.opened.workspace.projects.iter().any(|project| folder(self.db(), *project) == known)
    }

    /// Returns all findings of all loaded files, also outside the request.
    pub(crate) fn check_everything(&mut self) -> Vec<Diagnostic> {
        let OpenedWorkspace { threads, workspace, .. } = &mut self.opened;
        let mut projects: Vec<Project> =
            Sources::get(&workspace.db).projects(&workspace.db).values().copied().collect();
        projects.sort_unstable_by_key(|project| project.manifest(&workspace.db).path(&workspace.db));
        // Configuration faults were reported before, or the configurations do not apply to the request.
        let settings = WorkspaceSettings::new(&workspace.db, &projects, &RuleSelection::default()).unwrap_or_default();
        let units = units(workspace, &projects, threads);
        let progress = DelayedProgress::new("checking", units.len(), !self.request.quiet);
        let found = check_units(workspace, &units, &settings, threads, &ReportFilter::default(), &progress);
        finish(&workspace.db, &units, &settings, found).findings
    }

    /// Replaces file texts, and loads the files that become part of the workspace.
    pub(crate) fn set_texts<'t>(&mut self, texts: impl Iterator<Item = (&'t Utf8Path, &'t Arc<str>)>) {
        let mut is_shaped = false;
        for (path, text) in texts {
            self.edited.insert(path.to_owned(), Arc::clone(text));
            is_shaped |= self.set_text(path, text);
        }
        if is_shaped {
            let OpenedWorkspace { threads, workspace, asked, .. } = &mut self.opened;
            // An archive that can no longer be read keeps its previous content.
            let system = system(threads, self.request.input.as_ref(), &self.edited, asked);
            let Ok((system, _)) = system else { return };
            // A configuration that has become invalid keeps its previous content.
            let _ = workspace.refresh(&system, asked, &|_| false);
        }
    }

    /// Replaces a file's text. Returns whether the change may add other files or projects to the workspace.
    fn set_text(&mut self, path: &Utf8Path, text: &Arc<str>) -> bool {
        let db = &mut self.opened.workspace.db;
        let Some(file) = Sources::get(db).files(db).get(&path_key(path.as_str())).copied() else { return true };
        let before = Arc::clone(file.text(db));
        if *before == **text {
            return false;
        }
        file.set_text(db).to(Arc::clone(text));
        !is_program(path.as_str()) && !is_data(path.as_str()) || !loads_alike(&before, text)
    }

    /// Converts the findings to a report.
    pub(crate) fn report(&self, outcomes: CheckResult) -> CheckReport {
        let OpenedWorkspace { threads, paths, workspace, loose, .. } = &self.opened;
        let translator = Translator::new(workspace.db.clone(), paths, loose);
        let applications = translator.applications(&workspace.projects);
        let translated = outcomes.diagnostics.par_iter().with_min_len(CHUNK).map_with(translator, Translator::finding);
        let findings = threads.install(|| translated.collect());
        CheckReport {
            silenced: outcomes.silenced,
            baseline: outcomes.baseline,
            source_root: paths.source_root(),
            notice: self.opened.notice.clone(),
            ..CheckReport::new(statistics(&self.opened, self.started), applications, findings, outcomes.unread)
        }
    }

    /// Database with all files.
    pub(crate) fn db(&self) -> &Database {
        &self.opened.workspace.db
    }

    /// Paths in which fixes may change files.
    pub(crate) fn write_scope(&self) -> WriteScope {
        WriteScope::new(&self.opened.asked)
    }

    /// Path display.
    pub(crate) fn paths(&self) -> &Paths {
        &self.opened.paths
    }

    /// Folders of all loaded files, including external libraries.
    pub(crate) fn folders(&self) -> BTreeSet<Utf8PathBuf> {
        let files = Sources::get(self.db()).files(self.db()).values();
        files.filter_map(|file| file.path(self.db()).parent()).map(Utf8Path::to_owned).collect()
    }

    /// Ends the session without dropping its database, because the process ends immediately.
    pub(crate) fn abandon(self) {
        std::mem::forget(self.opened.workspace);
    }
}

/// Units in project order.
fn units(workspace: &Workspace, projects: &[Project], threads: &ThreadPool) -> Vec<CheckUnit> {
    let units = |db: &mut Database, project: &Project| val3_check::units(db, std::slice::from_ref(project));
    let found = projects.par_iter().map_with(workspace.db.clone(), units);
    threads.install(|| found.flatten_iter().collect())
}

/// Checks the units of all projects in parallel. The trees of a finished project are dropped, so that memory grows with
/// the largest project and not with the sum.
fn check_units(
    workspace: &mut Workspace,
    units: &[CheckUnit],
    settings: &WorkspaceSettings,
    threads: &ThreadPool,
    scope: &ReportFilter,
    progress: &DelayedProgress,
) -> Checked {
    let check = UnitCheck { settings, scope, progress, is_large: units.len() > BATCH };
    let projects: Vec<&[CheckUnit]> = units.chunk_by(|one, next| one.project() == next.project()).collect();
    let mut checked: Vec<Vec<Checked>> = Vec::with_capacity(projects.len());
    let mut batches = batches(&projects).peekable();
    while let Some(batch) = batches.next() {
        let found = batch.par_iter().map_with(workspace.db.clone(), |db, units| check.project(db, units));
        threads.install(|| checked.par_extend(found));
        if batches.peek().is_some() && check.is_large {
            workspace.db.trigger_lru_eviction();
        }
    }
    checked.into_iter().flatten().sum()
}

/// Context for checking units.
struct UnitCheck<'a> {
    settings: &'a WorkspaceSettings,
    scope: &'a ReportFilter,
    progress: &'a DelayedProgress,
    /// Whether the trees of a project are dropped after its check.
    is_large: bool,
}

impl UnitCheck<'_> {
    /// Checks the units of one project.
    fn project(&self, db: &mut Database, units: &[CheckUnit]) -> Vec<Checked> {
        let found = units.par_iter().map_with(db.clone(), |db, unit| self.unit(db, *unit)).collect();
        if self.is_large {
            db.trees().forget(units.iter().map(|unit| unit.file(db)));
        }
        found
    }

    /// Checks a unit, and omits findings outside of the scope.
    fn unit(&self, db: &Database, unit: CheckUnit) -> Checked {
        let mut found = check_unit(db, unit, self.settings);
        self.progress.advance();
        let is_covered = self.scope.covers(db, unit.project(), unit.file(db));
        found.findings.retain(|finding| {
            // A file that cannot be read is reported in its project.
            is_covered && is_unreadable(finding) || self.scope.covers(db, unit.project(), finding.place.file)
        });
        if !is_covered {
            found.silenced = 0;
        }
        found
    }
}

/// Each project's units, in batches of about [`BATCH`] units.
fn batches<'a, 'u>(projects: &'a [&'u [CheckUnit]]) -> impl Iterator<Item = &'a [&'u [CheckUnit]]> {
    let mut count = 0;
    projects.chunk_by(move |project, _| {
        count += project.len();
        let fits = count < BATCH;
        count *= usize::from(fits);
        fits
    })
}

fn statistics(opened: &OpenedWorkspace, started: Instant) -> ReportStatistics {
    let OpenedWorkspace { threads, workspace, loose, .. } = opened;
    let counts = workspace.projects.par_iter().map_with(workspace.db.clone(), |db, project| count(db, *project, loose));
    let counted: CheckStatistics = threads.install(|| counts.sum());
    ReportStatistics {
        applications: counted.applications,
        files: counted.files,
        programs: counted.programs,
        code_lines: counted.code_lines,
        seconds: started.elapsed().as_secs_f64(),
    }
}

/// Statistics of one project. A stand-in for a loose file counts as this file only.
fn count(db: &Database, project: Project, loose: &LooseFiles) -> CheckStatistics {
    let counted = val3_check::statistics(db, project);
    if loose.stands_in(db, project) { CheckStatistics { applications: 0, files: 1, ..counted } } else { counted }
}
