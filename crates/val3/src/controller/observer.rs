//! Progress of a transfer on the terminal, and its interruption by signals.

use std::sync::atomic::Ordering::Relaxed;

use val3_controller::{ControllerPath, TransferObserver, TransferStep};

use super::report::shown_bytes;
use crate::progress::DelayedProgress;
use crate::signals::Signals;

/// Shows the files and bytes of each step. By default, signals end the process, which suits a transfer that only reads.
#[derive(Default)]
pub(crate) struct ProgressObserver {
    signals: Signals,
    progress: Option<DelayedProgress>,
    bytes: u64,
}

impl ProgressObserver {
    pub(super) fn new(signals: Signals) -> Self {
        Self { signals, progress: None, bytes: 0 }
    }

    /// Removes the bar.
    pub(crate) fn end(&mut self) {
        self.progress = None;
    }

    /// Exit code for the caught signal, if any.
    pub(crate) fn signal_code(&self) -> Option<u8> {
        self.signals.exit_code()
    }
}

impl TransferObserver for ProgressObserver {
    fn step(&mut self, step: TransferStep, files: usize) {
        let activity = match step {
            TransferStep::List => "listing",
            TransferStep::Download => "downloading",
            TransferStep::BackUp => "backing up",
            TransferStep::Upload => "uploading",
            TransferStep::Rename => "renaming",
            TransferStep::Verify => "verifying",
            TransferStep::Restore => "restoring",
        };
        self.bytes = 0;
        // The number of listed files is unknown.
        self.progress = (files > 0).then(|| DelayedProgress::new(activity, files, true));
    }

    fn file(&mut self, path: &ControllerPath, bytes: u64) {
        self.bytes = self.bytes.saturating_add(bytes);
        if let Some(progress) = &self.progress {
            progress.name(format!("{} {path}", shown_bytes(self.bytes)));
            progress.advance();
        }
    }

    fn is_interrupted(&self) -> bool {
        self.signals.flag().load(Relaxed)
    }
}
