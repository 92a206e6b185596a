//! Checks projects on the thread pool.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use rustc_hash::FxHashSet;
use salsa::Cancelled;
use tower_lsp::lsp_types::{Diagnostic, Url};
use val3_analysis::db::{File, Project};

use super::ServerState;
use crate::convert;
use crate::inbox::Inbox;
use crate::panics::contained;
use crate::pool::Priority;
use crate::published::{self, ProjectFindings};
use crate::snapshot::Snapshot;

/// Projects that are checked together, by all threads with the same priority.
struct Batch {
    projects: Vec<Project>,
    /// Edited files, for whose findings the user waits.
    edited: FxHashSet<File>,
    next: AtomicUsize,
    /// Number of threads that still work on the batch.
    working: AtomicUsize,
    generation: u64,
    priority: Priority,
}

impl ServerState {
    /// Starts a round of checks if something has changed.
    pub(super) fn check(&mut self) {
        if !self.is_ready {
            return;
        }
        let Some(generation) = self.checks.begin() else { return };
        self.check_for_refresh(generation);
        self.publish_configurations();
        if self.session.is_asked_for_findings() {
            self.end_progress();
            return;
        }
        self.publish_gone_projects();
        let edited = self.checks.take_edited();
        let db = self.database();
        let owners: FxHashSet<Project> =
            edited.iter().flat_map(|file| val3_ide::projects_of(db, *file)).copied().collect();
        let (first, rest): (Vec<Project>, Vec<Project>) =
            self.projects().iter().copied().partition(|project| owners.contains(project));
        self.checks.set_open(rest);
        if first.is_empty() {
            self.check_next();
        } else {
            self.start_batch(first, edited, Priority::Latency);
        }
    }

    /// Starts the next batch, or ends the round.
    fn check_next(&mut self) {
        let batch = self.checks.next_batch(&self.workspace.db);
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
            generation: self.checks.started(),
            priority,
        });
        for _ in 0..threads {
            let (batch, snapshot, inbox) = (Arc::clone(&batch), self.snapshot(), self.inbox.clone());
            self.pool.spawn(priority, move || {
                let work = || Cancelled::catch(std::panic::AssertUnwindSafe(|| work(&batch, &snapshot, &inbox)));
                let outcome = contained(work);
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

    /// Restarts a check that a write has cancelled, unless the write itself has scheduled a new check.
    pub(super) fn check_again(&mut self, generation: u64) {
        if self.checks.is_current(generation) {
            self.checks.all();
        }
    }

    fn batch_is_done(&mut self, batch: &Batch) {
        if !self.checks.is_latest(batch.generation) {
            return;
        }
        if batch.priority == Priority::Background && !self.checks.first_is_done {
            self.forget_surplus();
        }
        self.report_progress();
        self.check_next();
    }

    /// Publishes the findings of a project in one file, unless they are stale.
    fn found_in_file(&mut self, generation: u64, project: Project, uri: Url, found: Vec<Diagnostic>) {
        if self.checks.is_latest(generation) {
            self.published.file(project, uri, found, &self.documents, &self.outbox);
        }
    }

    /// Publishes the findings of a project, unless they are stale.
    fn found(&mut self, generation: u64, found: ProjectFindings) {
        if self.checks.is_latest(generation) {
            self.published.project(found, &self.documents, &self.outbox);
        }
    }
}

/// Checks projects until all projects of the batch are taken.
fn work(batch: &Batch, snapshot: &Snapshot, inbox: &Inbox) {
    while let Some(project) = batch.projects.get(batch.next.fetch_add(1, Ordering::Relaxed)) {
        let generation = batch.generation;
        for (file, found) in found_early(batch, snapshot, *project) {
            let (uri, project) = (snapshot.uri(file), *project);
            inbox.post(move |server| server.found_in_file(generation, project, uri, found));
        }
        let found = published::findings(snapshot, *project);
        inbox.post(move |server| server.found(generation, found));
        if batch.priority == Priority::Background {
            val3_analysis::occurrences::index(snapshot.db(), *project);
        }
    }
}

/// Findings in the edited programs of `project`, before the rest of the project is checked. Files that several projects
/// share are omitted, because their findings come from all these projects.
fn found_early<'a>(
    batch: &'a Batch,
    snapshot: &'a Snapshot,
    project: Project,
) -> impl Iterator<Item = (File, Vec<Diagnostic>)> + 'a {
    let own = edited_in(batch, snapshot, project);
    own.filter_map(move |file| Some((file, convert::program_diagnostics(snapshot, project, file)?)))
}

/// Edited files that belong to `project` only.
fn edited_in<'a>(batch: &'a Batch, snapshot: &'a Snapshot, project: Project) -> impl Iterator<Item = File> + 'a {
    batch.edited.iter().copied().filter(move |file| val3_ide::projects_of(snapshot.db(), *file) == [project])
}
