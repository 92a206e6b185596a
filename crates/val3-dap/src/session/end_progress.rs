//! Progress of a run to its end (`startAtEnd`).

use crate::client::Client;
use crate::protocol::{ProgressEndEvent, ProgressStartEvent, ProgressUpdateEvent, StandardEvent};

/// Number of executed parts of cycles before the first report, and between two reports: some tenths of a second.
const LONG: u64 = 2_000;

/// Progress id.
const ID: &str = "run to its end";

/// Progress of a run to its end. The reports contain the reached time, because the time of the end is unknown.
#[derive(Debug, Default)]
pub(super) struct EndProgress {
    /// Executed parts of cycles.
    passed: u64,
}

impl EndProgress {
    /// Counts an executed part of a cycle, and reports the reached time in s.
    pub(super) fn pass(&mut self, t: f64, client: &mut Client) {
        self.passed += 1;
        if !self.passed.is_multiple_of(LONG) {
            return;
        }
        let (progress_id, message) = (ID.to_owned(), Some(format!("{t:.0} s of the run")));
        client.event(&match self.passed {
            LONG => StandardEvent::ProgressStart(ProgressStartEvent {
                progress_id,
                title: "Going to the end of the run".to_owned(),
                message,
                ..ProgressStartEvent::default()
            }),
            _ => StandardEvent::ProgressUpdate(ProgressUpdateEvent {
                progress_id,
                message,
                ..ProgressUpdateEvent::default()
            }),
        });
    }

    /// Reports the end, if progress was reported.
    pub(super) fn end(&mut self, client: &mut Client) {
        if std::mem::take(&mut self.passed) >= LONG {
            let (progress_id, message) = (ID.to_owned(), None);
            client.event(&StandardEvent::ProgressEnd(ProgressEndEvent { progress_id, message }));
        }
    }
}
