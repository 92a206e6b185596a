//! Schedule of background checks: edited projects first, then the remaining ones.

use rustc_hash::FxHashSet;
use val3_analysis::db::{Db, File, Project};
use val3_analysis::occurrences::project_files;

/// Number of files in a batch. After each batch, syntax trees that are no longer needed are freed.
const BATCH: usize = 128;

/// Pending checks.
#[derive(Debug, Default)]
pub(crate) struct Checks {
    /// Number of the latest change; results with a lower number are discarded.
    generation: u64,
    /// Generation of the current round of checks.
    started: u64,
    /// Files edited since their projects were last checked.
    edited: FxHashSet<File>,
    /// Unchecked projects that a change may affect.
    open: Vec<Project>,
    /// Whether the first round of checks is complete.
    pub(crate) first_is_done: bool,
}

impl Checks {
    /// Records that a file was edited, opened or closed.
    pub(crate) fn edited(&mut self, file: File) {
        self.generation += 1;
        self.edited.insert(file);
    }

    /// Records a change that may affect every project.
    pub(crate) fn all(&mut self) {
        self.generation += 1;
    }

    /// Discards all pending files and projects, because they no longer exist.
    pub(crate) fn forget(&mut self) {
        self.edited.clear();
        self.open.clear();
    }

    /// Whether nothing has changed since this round of checks began.
    pub(crate) fn is_current(&self, generation: u64) -> bool {
        generation == self.generation && generation == self.started
    }

    /// Number of unchecked projects, for the progress display.
    pub(crate) fn left(&self) -> usize {
        self.open.len()
    }

    /// Starts a round and returns its generation; `None` if nothing has changed since the last round.
    pub(crate) fn begin(&mut self) -> Option<u64> {
        let is_new = self.started != self.generation;
        self.started = self.generation;
        is_new.then_some(self.generation)
    }

    /// Generation of the current round of checks.
    pub(crate) fn started(&self) -> u64 {
        self.started
    }

    /// Whether `generation` is the number of the latest change.
    pub(crate) fn is_latest(&self, generation: u64) -> bool {
        generation == self.generation
    }

    /// Removes and returns the files edited since the last round.
    pub(crate) fn take_edited(&mut self) -> FxHashSet<File> {
        std::mem::take(&mut self.edited)
    }

    /// Sets the unchecked projects.
    pub(crate) fn set_open(&mut self, projects: Vec<Project>) {
        self.open = projects;
    }

    /// Removes and returns the next batch of projects; empty if all are checked.
    pub(crate) fn next_batch(&mut self, db: &dyn Db) -> Vec<Project> {
        let mut files = 0;
        let count = self.open.iter().take_while(|project| {
            let fits = files < BATCH;
            files += project_files(db, **project).count();
            fits
        });
        let count = count.count();
        self.open.drain(..count).collect()
    }
}
