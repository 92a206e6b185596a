//! Entries of several logs in one order.

use super::entry::LogEntry;
use crate::DateTime;

/// An entry with its file.
#[derive(Debug, Clone, PartialEq)]
pub struct LoggedEntry {
    /// Path of the file.
    pub file: String,
    /// Entry.
    pub entry: LogEntry,
}

/// Merges logs by time. The order within each log is kept, also if the clock was set back, and an entry without a time
/// follows its predecessor.
#[must_use]
pub fn merged(logs: Vec<Vec<LoggedEntry>>) -> Vec<LoggedEntry> {
    let mut logs: Vec<_> = logs.into_iter().map(|log| timed(log).into_iter().peekable()).collect();
    let mut all = Vec::new();
    loop {
        let heads = logs.iter_mut().enumerate().filter_map(|(index, log)| Some((log.peek()?.0, index)));
        let Some((_, next)) = heads.min() else { return all };
        all.extend(logs.get_mut(next).and_then(Iterator::next).map(|(_, entry)| entry));
    }
}

/// Adds to each entry the latest time up to it.
fn timed(log: Vec<LoggedEntry>) -> Vec<(Option<DateTime>, LoggedEntry)> {
    let mut latest = None;
    let with_time = |logged: LoggedEntry| {
        latest = latest.max(logged.entry.time);
        (latest, logged)
    };
    log.into_iter().map(with_time).collect()
}
