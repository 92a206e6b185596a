//! Reads of signals that a debugger watches.

use std::collections::BTreeSet;

use val3_lang::ports::TaskNumber;

use super::Devices;
use crate::io::{LinkId, SignalId};

/// Watched signals, and the tasks that have read them.
#[derive(Debug, Default)]
pub(super) struct SignalReads {
    watched: BTreeSet<SignalId>,
    seen: BTreeSet<(TaskNumber, SignalId)>,
}

impl Devices {
    /// Starts to record the tasks that read these signals.
    pub fn watch_signal_reads(&mut self, watched: BTreeSet<SignalId>) {
        self.signal_reads = SignalReads { watched, seen: BTreeSet::new() };
    }

    /// The tasks that have read watched signals since the last call.
    pub fn take_signal_reads(&mut self) -> BTreeSet<(TaskNumber, SignalId)> {
        std::mem::take(&mut self.signal_reads.seen)
    }

    /// Records that the running task reads the signal of a link.
    pub(super) fn note_read(&mut self, link: LinkId) {
        if self.signal_reads.watched.is_empty() {
            return;
        }
        let read = self.state.io.target_of(link).filter(|signal| self.signal_reads.watched.contains(signal));
        self.signal_reads.seen.extend(read.map(|signal| (self.state.record.origin().task, signal)));
    }
}
