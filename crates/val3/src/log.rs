//! `val3 log`: shows the messages of a controller's logs, with meaning, remedy and source line.

mod follow;
mod human;
mod reading;
mod record;
mod selection;
mod sources;

use std::process::ExitCode;

use codespan_reporting::term::termcolor::WriteColor;
use serde_json::json;
use val3_backup::log::LoggedEntry;

use self::human::HumanLog;
use self::reading::ReadLog;
use self::record::{MessageRecord, Recorder};
use self::selection::{LogCounts, Selection};
use self::sources::Sources;
use crate::args::{LogArgs, LogFormat};
use crate::color::Color;
use crate::controller::check_no_option;
use crate::output::{OutputContent, to_stderr, to_stdout_as};
use crate::paths::{Paths, current_folder, is_address};
use crate::user_error::{EXIT_USAGE, UserError};

/// Version of the JSON document.
const VERSION: u32 = 1;

/// Runs the command.
pub(crate) fn run(args: &LogArgs, color: Color) -> Result<ExitCode, UserError> {
    let current = current_folder()?;
    let is_remote = is_address(&args.path);
    let path = if is_remote { args.path.clone() } else { current.join(&args.path) };
    let paths = Paths::new(&[], &current);
    if !is_remote {
        check_no_option(&args.connection)?;
    }
    if args.follow {
        return follow::run(args, &path, &paths, color);
    }
    let ReadLog { logged, folder, backup } = match is_remote {
        true => reading::read_address(args, &paths)?,
        false => reading::read(&path, &paths)?,
    };
    let unsearched = backup.as_ref().map(|backup| reading::unsearched(backup, &paths)).unwrap_or_default();
    let sources = Sources::open(args.sources.as_deref().map(|path| current.join(path)), &folder, backup)?;
    let selection = Selection::new(args, &logged);
    let mut recorder = Recorder::new(&paths, &sources);
    let mut counts = LogCounts::default();
    let records = records(&logged, &selection, &mut recorder, &mut counts);
    match args.format {
        LogFormat::Human => {
            let mut human = HumanLog::default();
            to_stdout_as(OutputContent::Words, color, |out| {
                records.iter().try_for_each(|record| human.write(record, out))
            })?;
        }
        LogFormat::Json => {
            let document = json!({ "version": VERSION, "messages": records, "counts": counts });
            to_stdout_as(OutputContent::Json, color, |out| writeln!(out, "{document}"))?;
        }
        LogFormat::JsonLines => to_stdout_as(OutputContent::Json, color, |out| {
            records.iter().try_for_each(|record| write_line(record, out))
        })?,
    }
    to_stderr(|out| writeln!(out, "{counts}"));
    sources.unread().iter().for_each(|note| to_stderr(|out| writeln!(out, "note: {note}")));
    unsearched.iter().for_each(|folder| to_stderr(|out| writeln!(out, "error: {folder}")));
    Ok(if unsearched.is_empty() { ExitCode::SUCCESS } else { ExitCode::from(EXIT_USAGE) })
}

/// Converts the selected entries to records, and counts all of them.
fn records(
    logged: &[LoggedEntry],
    selection: &Selection,
    recorder: &mut Recorder<'_>,
    counts: &mut LogCounts,
) -> Vec<MessageRecord> {
    let mut latest = None;
    let mut records = Vec::new();
    for LoggedEntry { file, entry } in logged {
        latest = latest.max(entry.time);
        recorder.advance(entry);
        let is_shown = selection.has(entry, latest);
        counts.add(entry, is_shown);
        if is_shown {
            records.push(recorder.record(file, entry));
        }
    }
    records
}

fn write_line(record: &MessageRecord, out: &mut dyn WriteColor) -> std::io::Result<()> {
    serde_json::to_writer(&mut *out, record)?;
    writeln!(out)
}
