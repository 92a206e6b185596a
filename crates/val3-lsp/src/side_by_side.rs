//! Two threads that find what is wrong in the program that was edited.
//!
//! The first finds what all else needs; the second does beside it what it can. Until they go their own ways, neither
//! sleeps until the other wakes it: a thread that does is often woken on the core of the one that it waited for, and
//! both then share that core while another has nothing to do.

use std::sync::atomic::{AtomicU8, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use salsa::Database as _;
use val3_analysis::db::{File, Project};
use val3_ide::{CheckSettings, Step, find_ahead};

use crate::snapshot::Snapshot;

/// How long one thread looks for a step of the other: longer than that takes, but for huge programs.
const PATIENCE: Duration = Duration::from_millis(5);

/// How long the second thread sleeps between two looks for the code, at least. That takes longest, and a core is free
/// meanwhile for whoever needs it; what follows comes sooner than anybody wakes up.
const NAP: Duration = Duration::from_micros(10);

/// How far the threads have come with the program that both look at.
#[derive(Debug)]
pub(crate) struct SideBySide {
    project: Project,
    file: File,
    first: Progress,
    second: Progress,
}

/// What a thread has reached last.
#[derive(Debug, Default)]
struct Progress(AtomicU8);

/// What one thread waits for in the other.
#[derive(Debug, Clone, Copy)]
enum Reached {
    /// There is the code.
    Code = 1,
    /// There are the types.
    Types,
    /// The uses of variables are being found.
    Uses,
    /// There are the faults, or the uses: what a thread does before it goes its own way.
    Shared,
}

impl SideBySide {
    /// For a program of a project.
    pub(crate) fn new(project: Project, file: File) -> Self {
        Self { project, file, first: Progress::default(), second: Progress::default() }
    }

    /// What the first thread does before all else.
    pub(crate) fn lead(&self, snapshot: &Snapshot) {
        let Some(settings) = snapshot.settings else { return };
        self.find(snapshot, settings, Step::Code);
        self.first.reach(Reached::Code);
        self.find(snapshot, settings, Step::Types);
        self.first.reach(Reached::Types);
        self.find(snapshot, settings, Step::Faults);
        self.first.reach(Reached::Shared);
        if self.second.has(Reached::Uses) {
            self.second.wait(snapshot, Reached::Shared, thread::yield_now);
        }
    }

    /// What the second thread does.
    pub(crate) fn help(&self, snapshot: &Snapshot) {
        let Some(settings) = snapshot.settings else { return };
        self.first.wait(snapshot, Reached::Code, nap);
        self.find(snapshot, settings, Step::Ways);
        self.first.wait(snapshot, Reached::Types, thread::yield_now);
        self.second.reach(Reached::Uses);
        self.find(snapshot, settings, Step::Uses);
        self.second.reach(Reached::Shared);
        self.first.wait(snapshot, Reached::Shared, thread::yield_now);
        self.find(snapshot, settings, Step::Lints);
    }

    fn find(&self, snapshot: &Snapshot, settings: CheckSettings, step: Step) {
        find_ahead(snapshot.db(), settings, (self.project, self.file), step);
    }
}

impl Progress {
    fn reach(&self, reached: Reached) {
        self.0.store(reached as u8, Ordering::Release);
    }

    fn has(&self, reached: Reached) -> bool {
        self.0.load(Ordering::Acquire) >= reached as u8
    }

    /// Ends at once where a writer waits for the snapshot. What is not there afterwards is waited for as anywhere.
    fn wait(&self, snapshot: &Snapshot, reached: Reached, pause: fn()) {
        let started = Instant::now();
        while !self.has(reached) && started.elapsed() < PATIENCE {
            snapshot.db.unwind_if_revision_cancelled();
            pause();
        }
    }
}

fn nap() {
    thread::sleep(NAP);
}
