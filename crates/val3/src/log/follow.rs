//! `val3 log --follow`: shows a file's messages while it grows.

use std::process::ExitCode;
use std::time::Duration;

use camino::Utf8Path;
use val3_backup::log::{LoggedEntry, line_entry};
use val3_files::{FileClass, Unreadable, is_archive_name, read_from};

use super::human::HumanLog;
use super::reading::{file_entries, unreadable};
use super::record::{MessageRecord, Recorder};
use super::selection::{LogCounts, Selection};
use super::sources::Sources;
use super::{records, write_line};
use crate::args::{LogArgs, LogFormat};
use crate::color::Color;
use crate::output::{OutputContent, to_reader};
use crate::paths::{Paths, is_address};
use crate::user_error::UserError;

/// Time between two looks at the file.
const INTERVAL: Duration = Duration::from_millis(300);

/// Read part of the file.
#[derive(Debug, Default)]
struct Position {
    /// Offset after the last complete line.
    offset: u64,
    /// Number of complete lines.
    lines: usize,
}

/// Shows the messages of the file at an absolute path, and then further messages. It ends with an error, or when the
/// output is closed.
pub(super) fn run(args: &LogArgs, path: &Utf8Path, paths: &Paths, color: Color) -> Result<ExitCode, UserError> {
    if is_address(path) {
        let message = "--follow requires a file, because a controller transfers only entire logs";
        return Err(UserError::new(message).with_help("repeat the command without --follow, with --since 10m"));
    }
    if path.is_dir() || is_archive_name(path) {
        let message = "--follow requires a file, because the logs of a folder are merged by time";
        return Err(UserError::new(message).with_help("name a log, such as log/user.log"));
    }
    if args.format == LogFormat::Json {
        let message = "--follow cannot be used with --format json, because the document never ends";
        return Err(UserError::new(message).with_help("write --format json-lines"));
    }
    let requested = args.sources.as_deref().map(|sources| paths.absolute(sources));
    let sources = Sources::open(requested, path.parent().unwrap_or(path), None)?;
    let mut recorder = Recorder::new(paths, &sources);
    let mut human = HumanLog::default();
    let mut position = Position::default();
    let mut selection = None;
    loop {
        if let Some(logged) = position.next(path, paths)? {
            let selection = selection.get_or_insert_with(|| Selection::new(args, &logged));
            let records = records(&logged, selection, &mut recorder, &mut LogCounts::default());
            if !write(&records, args.format, &mut human, color)? {
                return Ok(ExitCode::SUCCESS);
            }
        }
        std::thread::sleep(INTERVAL);
    }
}

impl Position {
    /// Returns the entries of the lines that were completed since; `None` if there are none. The file may be absent for
    /// a moment while the controller replaces it.
    fn next(&mut self, path: &Utf8Path, paths: &Paths) -> Result<Option<Vec<LoggedEntry>>, UserError> {
        let (offset, bytes) = match read_from(path, self.offset, FileClass::Record) {
            Ok(read) => read,
            Err(Unreadable::Missing) if self.offset > 0 => return Ok(None),
            Err(reason) => return Err(unreadable(path, &reason.to_string(), paths)),
        };
        if offset < self.offset {
            *self = Self::default();
        }
        let Some(end) = bytes.iter().rposition(|byte| *byte == b'\n') else { return Ok(None) };
        let complete = bytes.get(..end).unwrap_or_default();
        let logged = if self.offset == 0 {
            file_entries(complete, path, paths)?
        } else {
            let file = paths.to_open(path);
            let lines = complete.split(|byte| *byte == b'\n').zip(self.lines + 1..);
            let entries = lines.filter_map(|(line, number)| line_entry(number, line));
            entries.map(|entry| LoggedEntry { file: file.clone(), entry }).collect()
        };
        self.lines += complete.iter().filter(|byte| **byte == b'\n').count() + 1;
        self.offset = offset + u64::try_from(end + 1).unwrap_or(u64::MAX);
        Ok(Some(logged))
    }
}

/// Writes the records. Returns whether the output is still read.
fn write(records: &[MessageRecord], format: LogFormat, human: &mut HumanLog, color: Color) -> Result<bool, UserError> {
    match format {
        LogFormat::Human => {
            to_reader(OutputContent::Words, color, |out| records.iter().try_for_each(|record| human.write(record, out)))
        }
        LogFormat::Json | LogFormat::JsonLines => {
            to_reader(OutputContent::Json, color, |out| records.iter().try_for_each(|record| write_line(record, out)))
        }
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use camino::Utf8PathBuf;

    use super::*;

    fn texts(position: &mut Position, path: &Utf8Path) -> Vec<String> {
        let paths = Paths::new(&[], path.parent().unwrap());
        let logged = position.next(path, &paths).unwrap().unwrap_or_default();
        logged.iter().map(|logged| format!("{} {}", logged.entry.line, logged.entry.text)).collect()
    }

    #[test]
    fn complete_lines_are_read_once_also_after_the_file_was_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let path = Utf8PathBuf::from_path_buf(folder.path().join("user.log")).unwrap();
        let mut position = Position::default();
        fs::write(&path, "one\ntwo\nthr").unwrap();
        assert_eq!(texts(&mut position, &path), ["1 one", "2 two"]);
        assert!(texts(&mut position, &path).is_empty());
        fs::write(&path, "one\ntwo\nthree\n\nfive\n").unwrap();
        assert_eq!(texts(&mut position, &path), ["3 three", "5 five"]);
        fs::remove_file(&path).unwrap();
        assert!(texts(&mut position, &path).is_empty());
        fs::write(&path, "new\n").unwrap();
        assert_eq!(texts(&mut position, &path), ["1 new"]);
    }
}
