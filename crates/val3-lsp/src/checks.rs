//! Which projects are checked, and in what order: the edited ones first, then the others.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use rustc_hash::FxHashSet;
use salsa::Cancelled;
use tower_lsp::lsp_types::{Diagnostic, Url};
use val3_analysis::db::{File, Project};

use crate::convert;
use crate::pool::Priority;
use crate::published::{self, ProjectFindings};
use crate::server_state::ServerState;
use crate::snapshot::Snapshot;

/// Files after which trees that are no longer needed are freed.
const BATCH: usize = 128;

/// The checks that are left.
#[derive(Debug, Default)]
pub(crate) struct Checks {
    /// Counts the changes; results of an earlier state are of no use.
    generation: u64,
    /// The generation that is being checked.
    started: u64,
    /// Files that were edited since their projects were checked.
    edited: FxHashSet<File>,
    /// Projects that a change may reach.
    open: Vec<Project>,
    /// Everything was checked once.
    pub(crate) first_is_done: bool,
}

/// Projects that are checked together, by all threads of a priority.
struct Batch {
    projects: Vec<Project>,
    /// Edited files. The user waits for their findings.
    edited: FxHashSet<File>,
    next: AtomicUsize,
    /// Threads that still work on it.
    working: AtomicUsize,
    generation: u64,
    priority: Priority,
}

impl Checks {
    /// A file was edited, opened or closed.
    pub(crate) fn edited(&mut self, file: File) {
        self.generation += 1;
        self.edited.insert(file);
    }

    /// Anything may have changed.
    pub(crate) fn all(&mut self) {
        self.generation += 1;
    }

    /// The files and projects are no more.
    pub(crate) fn forget(&mut self) {
        self.edited.clear();
        self.open.clear();
    }

    /// Nothing changed since the generation that is being checked.
    pub(crate) fn is_current(&self, generation: u64) -> bool {
        generation == self.generation && generation == self.started
    }

    /// The number of projects that are left, for the display of progress.
    pub(crate) fn left(&self) -> usize {
        self.open.len()
    }
}

impl ServerState {
    /// Begins to check what changed since the last time.
    pub(crate) fn check(&mut self) {
        let is_checked = self.checks.started == self.checks.generation;
        if is_checked || !self.is_ready {
            return;
        }
        self.checks.started = self.checks.generation;
        self.check_for_refresh(self.checks.generation);
        self.publish_configurations();
        if self.session.is_asked_for_findings() {
            return;
        }
        self.publish_gone_projects();
        let edited = std::mem::take(&mut self.checks.edited);
        let db = self.database();
        let owners: FxHashSet<Project> =
            edited.iter().flat_map(|file| val3_ide::projects_of(db, *file)).copied().collect();
        let (first, rest): (Vec<Project>, Vec<Project>) =
            self.projects().iter().copied().partition(|project| owners.contains(project));
        self.checks.open = rest;
        self.begin_progress();
        if first.is_empty() {
            self.check_next();
        } else {
            self.start_batch(first, edited, Priority::Latency);
        }
    }

    /// Begins the next batch, or ends the round.
    fn check_next(&mut self) {
        let mut files = 0;
        let db = self.database();
        let count = self.checks.open.iter().take_while(|project| {
            let fits = files < BATCH;
            files += val3_analysis::occurrences::project_files(db, **project).count();
            fits
        });
        let count = count.count();
        let batch: Vec<Project> = self.checks.open.drain(..count).collect();
        if batch.is_empty() {
            self.checks.first_is_done = true;
            self.end_progress();
        } else {
            self.start_batch(batch, FxHashSet::default(), Priority::Background);
        }
    }

    fn start_batch(&self, projects: Vec<Project>, edited: FxHashSet<File>, priority: Priority) {
        let threads = self.pool.threads().min(projects.len());
        let batch = Arc::new(Batch {
            projects,
            edited,
            next: AtomicUsize::new(0),
            working: AtomicUsize::new(threads),
            generation: self.checks.started,
            priority,
        });
        for _ in 0..threads {
            let (batch, snapshot, inbox) = (Arc::clone(&batch), self.snapshot(), self.inbox.clone());
            self.pool.spawn(priority, move || {
                let work = || Cancelled::catch(std::panic::AssertUnwindSafe(|| work(&batch, &snapshot)));
                let outcome = crate::panics::contained(work);
                drop(snapshot);
                let is_last = batch.working.fetch_sub(1, Ordering::AcqRel) == 1;
                inbox.post(move |server| {
                    match outcome {
                        // A write has cancelled this check and starts a new one.
                        Ok(Err(_)) => return server.check_again(batch.generation),
                        Ok(Ok(())) => {}
                        Err(reason) => server.complain("the check", &reason),
                    }
                    if is_last {
                        server.batch_is_done(&batch);
                    }
                });
            });
        }
    }

    /// A write stopped a check. The check starts again unless the write concerns it.
    pub(crate) fn check_again(&mut self, generation: u64) {
        if self.checks.is_current(generation) {
            self.checks.all();
        }
    }

    fn batch_is_done(&mut self, batch: &Batch) {
        if batch.generation != self.checks.generation {
            return;
        }
        if batch.priority == Priority::Background && !self.checks.first_is_done {
            self.forget_surplus();
        }
        self.report_progress();
        self.check_next();
    }

    /// The findings of a project in one file, unless they are those of an earlier state.
    fn found_in_file(&mut self, generation: u64, project: Project, found: (Url, Vec<Diagnostic>)) {
        if generation == self.checks.generation {
            self.published.file(project, found, &self.documents, &self.outbox);
        }
    }

    /// The findings of a project, unless they are those of an earlier state.
    fn found(&mut self, generation: u64, found: ProjectFindings) {
        if generation == self.checks.generation {
            self.published.project(found, &self.documents, &self.outbox);
        }
    }
}

/// Checks projects until none is left.
fn work(batch: &Batch, snapshot: &Snapshot) {
    while let Some(project) = batch.projects.get(batch.next.fetch_add(1, Ordering::Relaxed)) {
        let generation = batch.generation;
        for (file, found) in found_early(batch, snapshot, *project) {
            let found = (snapshot.uri(file), found);
            let project = *project;
            snapshot.inbox.post(move |server| server.found_in_file(generation, project, found));
        }
        let found = published::findings(snapshot, *project);
        snapshot.inbox.post(move |server| server.found(generation, found));
        if batch.priority == Priority::Background {
            val3_analysis::occurrences::index(snapshot.db(), *project);
        }
    }
}

/// All findings in the edited programs of `project`, before the rest of it is checked. A file that several projects
/// share has those of each of them.
fn found_early<'a>(
    batch: &'a Batch,
    snapshot: &'a Snapshot,
    project: Project,
) -> impl Iterator<Item = (File, Vec<Diagnostic>)> + 'a {
    let own = edited_in(batch, snapshot, project);
    own.filter_map(move |file| Some((file, convert::program_diagnostics(snapshot, project, file)?)))
}

/// The edited files that belong to `project` only.
fn edited_in<'a>(batch: &'a Batch, snapshot: &'a Snapshot, project: Project) -> impl Iterator<Item = File> + 'a {
    batch.edited.iter().copied().filter(move |file| val3_ide::projects_of(snapshot.db(), *file) == [project])
}
