//! Which projects are checked, and in what order: the edited ones first, then the others.

use rustc_hash::FxHashSet;
use val3_analysis::db::{Db, File, Project};
use val3_analysis::occurrences::project_files;

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

    /// Begins a round if something changed since the last one. Returns its generation.
    pub(crate) fn begin(&mut self) -> Option<u64> {
        let is_new = self.started != self.generation;
        self.started = self.generation;
        is_new.then_some(self.generation)
    }

    /// The generation that is being checked.
    pub(crate) fn started(&self) -> u64 {
        self.started
    }

    /// Whether `generation` is that of the last change.
    pub(crate) fn is_latest(&self, generation: u64) -> bool {
        generation == self.generation
    }

    /// The files that were edited since the last round.
    pub(crate) fn take_edited(&mut self) -> FxHashSet<File> {
        std::mem::take(&mut self.edited)
    }

    /// Sets the projects that are left.
    pub(crate) fn set_open(&mut self, projects: Vec<Project>) {
        self.open = projects;
    }

    /// Takes the projects of the next batch out; none if all are checked.
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
