//! Selected messages and their counts.

use std::fmt;

use serde::Serialize;
use val3_backup::DateTime;
use val3_backup::log::{LineForm, LogEntry, LoggedEntry};
use val3_lang::log_messages::LogLevel;

use crate::args::{LogArgs, Since};

/// Selection of messages by the arguments.
#[derive(Debug, Clone, Copy)]
pub(super) struct Selection {
    /// Time of the first selected message.
    since: Option<DateTime>,
    /// Lowest selected level.
    level: Option<LogLevel>,
}

impl Selection {
    /// Creates the selection. A duration is counted from the latest message in `logged`.
    pub(super) fn new(args: &LogArgs, logged: &[LoggedEntry]) -> Self {
        let latest = || logged.iter().filter_map(|logged| logged.entry.time).max();
        let since = match args.since {
            Some(Since::At(time)) => Some(time),
            Some(Since::BeforeLast(seconds)) => latest().map(|time| time.minus_seconds(seconds)),
            None => None,
        };
        Self { since, level: args.level.map(LogLevel::from) }
    }

    /// Whether an entry is selected. `latest` is the latest time up to it, which decides for entries without a time.
    pub(super) fn has(&self, entry: &LogEntry, latest: Option<DateTime>) -> bool {
        let time = entry.time.or(latest);
        let is_recent = self.since.is_none_or(|since| time.is_none_or(|time| time >= since));
        let has_level = self.level.is_none_or(|lowest| entry.known_level().is_none_or(|level| level >= lowest));
        is_recent && has_level
    }
}

/// Numbers of entries.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize)]
pub(super) struct LogCounts {
    /// Lines that are not blank.
    lines: usize,
    /// Lines that the selection omits.
    hidden: usize,
    /// Shown lines in no known form.
    unknown: usize,
    critical: usize,
    error: usize,
    warn: usize,
}

impl LogCounts {
    /// Counts an entry.
    pub(super) fn add(&mut self, entry: &LogEntry, is_shown: bool) {
        self.lines += 1;
        if !is_shown {
            self.hidden += 1;
            return;
        }
        self.unknown += usize::from(entry.form == LineForm::Unknown);
        match entry.known_level() {
            Some(LogLevel::Critical) => self.critical += 1,
            Some(LogLevel::Error) => self.error += 1,
            Some(LogLevel::Warn) => self.warn += 1,
            Some(LogLevel::Info) | None => {}
        }
    }
}

impl fmt::Display for LogCounts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { lines, hidden, unknown, critical, error, warn } = self;
        let shown = lines - hidden;
        write!(f, "{shown} {}: {critical} critical, ", if shown == 1 { "message" } else { "messages" })?;
        write!(f, "{error} {}, {warn} {}", plural(*error, "error"), plural(*warn, "warning"))?;
        if *unknown > 0 {
            write!(f, "; {unknown} {} in no known form, shown unchanged", plural(*unknown, "line"))?;
        }
        if *hidden > 0 { write!(f, "; {hidden} more not selected") } else { Ok(()) }
    }
}

fn plural(count: usize, word: &str) -> String {
    if count == 1 { word.to_owned() } else { format!("{word}s") }
}
