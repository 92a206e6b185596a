//! Progress bar for long operations.

use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Duration from which an operation shows a bar.
const DELAY: Duration = Duration::from_secs(1);

/// Counts finished units on the standard error output, if that is a terminal and the operation is long.
#[derive(Debug)]
pub(crate) struct DelayedProgress {
    bar: ProgressBar,
    started: Instant,
    is_wanted: bool,
}

impl DelayedProgress {
    /// Creates a bar for `total` units, labelled `activity`. It is hidden at first, and permanently if `is_wanted` is
    /// false.
    pub(crate) fn new(activity: &str, total: usize, is_wanted: bool) -> Self {
        let bar = ProgressBar::with_draw_target(Some(total as u64), ProgressDrawTarget::hidden());
        if let Ok(style) = ProgressStyle::with_template(&format!("{activity} {{bar:30}} {{pos}}/{{len}} {{msg}}")) {
            bar.set_style(style);
        }
        Self { bar, started: Instant::now(), is_wanted }
    }

    /// Shows the name of the current unit.
    pub(crate) fn name(&self, piece: String) {
        self.bar.set_message(piece);
    }

    /// Counts a finished unit. Any thread may call it.
    pub(crate) fn advance(&self) {
        if self.is_wanted && self.bar.is_hidden() && self.started.elapsed() > DELAY {
            // If the standard error output is no terminal, this target draws nothing.
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        self.bar.inc(1);
    }

    /// Hides the bar while `write` writes to the terminal.
    pub(crate) fn pause<T>(&self, write: impl FnOnce() -> T) -> T {
        self.bar.suspend(write)
    }
}

impl Drop for DelayedProgress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
