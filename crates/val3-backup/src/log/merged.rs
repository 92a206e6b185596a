//! Entries of several logs in one order.

use super::entry::LogEntry;
use crate::DateTime;

/// Seconds by which times of consecutive entries may differ backwards without a change of the clock.
const JITTER: u32 = 60;

/// An entry with its file.
#[derive(Debug, Clone, PartialEq)]
pub struct LoggedEntry {
    /// Path of the file.
    pub file: String,
    /// Entry.
    pub entry: LogEntry,
}

/// An entry with its place in the merged order.
struct Placed {
    /// Number of times that the clock was set back before the entry, and the latest time since.
    key: (usize, Option<DateTime>),
    logged: LoggedEntry,
}

/// Merges logs by time. The order within each log is kept, also if the clock was set back, and an entry without a time
/// follows its predecessor.
#[must_use]
pub fn merged(logs: Vec<Vec<LoggedEntry>>) -> Vec<LoggedEntry> {
    // The clock is set back for all logs, but a log with few entries may not show it.
    let changes = logs.iter().map(|log| changes(log)).max_by_key(Vec::len).unwrap_or_default();
    let mut logs: Vec<_> = logs.into_iter().map(|log| placed(log, &changes).into_iter().peekable()).collect();
    let mut all = Vec::new();
    loop {
        let heads = logs.iter_mut().enumerate().filter_map(|(index, log)| Some((log.peek()?.key, index)));
        let Some((_, next)) = heads.min() else { return all };
        all.extend(logs.get_mut(next).and_then(Iterator::next).map(|placed| placed.logged));
    }
}

/// Whether the clock was set back between two entries.
fn is_set_back(latest: Option<DateTime>, time: DateTime) -> bool {
    latest.is_some_and(|latest| time < latest.minus_seconds(JITTER))
}

/// Times at which the clock was set back, each as the last time before.
fn changes(log: &[LoggedEntry]) -> Vec<DateTime> {
    let mut latest = None;
    let mut changes = Vec::new();
    for time in log.iter().filter_map(|logged| logged.entry.time) {
        if is_set_back(latest, time) {
            changes.extend(latest.take());
        }
        latest = latest.max(Some(time));
    }
    changes
}

/// Adds keys to the entries of a log. `known` are the times at which the clock was set back, from the log that shows most
/// of them.
fn placed(log: Vec<LoggedEntry>, known: &[DateTime]) -> Vec<Placed> {
    let shows_all = changes(&log).len() == known.len();
    let mut latest = None;
    let mut set_backs = 0;
    // Whether the last change was not shown by this log.
    let mut is_assumed = false;
    let mut placed = Vec::with_capacity(log.len());
    for logged in log {
        if let Some(time) = logged.entry.time {
            // An entry after the time of a change is later than the change.
            let has_passed =
                !shows_all && known.get(set_backs).is_some_and(|change| *change < time.minus_seconds(JITTER));
            if is_set_back(latest, time) {
                set_backs += usize::from(!is_assumed);
                (latest, is_assumed) = (None, false);
            } else if has_passed {
                set_backs += 1;
                (latest, is_assumed) = (None, true);
            }
            latest = latest.max(Some(time));
        }
        placed.push(Placed { key: (set_backs, latest), logged });
    }
    placed
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::log::entries;

    fn log(name: &str, times: &[&str]) -> Vec<LoggedEntry> {
        let lines = times.iter().map(|time| format!("[01/05/21 {time}:00]: {name} {time}\n"));
        let text: String = lines.collect();
        entries(text.as_bytes()).map(|entry| LoggedEntry { file: name.to_owned(), entry }).collect()
    }

    fn order(logs: [Vec<LoggedEntry>; 2]) -> String {
        let texts: Vec<String> = merged(logs.into()).into_iter().map(|logged| logged.entry.text).collect();
        texts.join(", ")
    }

    #[test]
    fn logs_are_merged_also_after_the_clock_was_set_back() {
        let merged = order([log("a", &["08:00", "09:00", "08:10", "08:30"]), log("b", &["08:50", "08:20", "08:40"])]);
        assert_eq!(merged, "a 08:00, b 08:50, a 09:00, a 08:10, b 08:20, a 08:30, b 08:40");
    }

    #[test]
    fn a_log_that_does_not_show_the_change_is_merged_after_it() {
        let merged = order([log("a", &["08:00", "09:00", "08:10", "09:30"]), log("b", &["07:00", "09:20", "10:00"])]);
        assert_eq!(merged, "b 07:00, a 08:00, a 09:00, a 08:10, b 09:20, a 09:30, b 10:00");
    }
}
