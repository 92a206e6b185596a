//! Records of messages, from which all formats are written.

use serde::Serialize;
use val3_backup::log::{EntryExplanation, LogEntry, RunningApplications, Topic, explanation};
use val3_lang::log_messages::COMPILE_ERROR;

use super::sources::Sources;
use crate::paths::Paths;

/// First characters of the codes that concern programs.
const OF_PROGRAMS: &str = "0x54";

/// A message with all that is known about it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct MessageRecord {
    /// Path of the log, from the current folder.
    pub(super) file: String,
    /// Line of the log, from 1.
    pub(super) line: usize,
    /// Form of the line: `message`, `start`, `continuation`, `state` or `unknown`.
    pub(super) form: &'static str,
    /// Time on the controller's clock: `2021-01-05 08:00:00`.
    pub(super) time: Option<String>,
    /// Seconds since the start of the controller (CS9).
    pub(super) uptime: Option<f64>,
    /// Level: `INFO`, `WARN`, `ERROR` or `CRITICAL`. Messages of a CS8 have the usual level of their code.
    pub(super) level: Option<&'static str>,
    /// Code, for example `0x5405`.
    pub(super) code: Option<String>,
    /// Text of the message; the entire line for the form `unknown`.
    pub(super) text: String,
    /// Application that the text names, or the only running application.
    pub(super) application: Option<String>,
    /// Task that the text names.
    pub(super) task: Option<String>,
    /// Program that the text names.
    pub(super) program: Option<String>,
    /// Line of the program's code, from 1 at `begin`.
    pub(super) code_line: Option<usize>,
    /// Number of the run-time error.
    pub(super) error: Option<u16>,
    /// Lines to which the message may refer.
    pub(super) sources: Vec<SourceRecord>,
    /// Word for `val3 explain`.
    pub(super) topic: Option<String>,
    /// Meaning in a few words.
    pub(super) meaning: Option<&'static str>,
    /// Cause.
    pub(super) cause: Option<&'static str>,
    /// What to do; `None` if nothing needs to be done.
    pub(super) remedy: Option<&'static str>,
}

/// Line of a program.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub(super) struct SourceRecord {
    /// Application.
    pub(super) application: String,
    /// Path from the current folder.
    pub(super) file: String,
    /// Line of the file, from 1.
    pub(super) line: usize,
    /// Code of the line.
    pub(super) text: String,
    /// Whether the program was changed after the message: the line does not contain the token in the message.
    pub(super) changed: bool,
}

/// Converts entries to records.
pub(super) struct Recorder<'a> {
    paths: &'a Paths,
    sources: &'a Sources,
    running: RunningApplications,
}

impl<'a> Recorder<'a> {
    /// Creates a recorder before the first entry.
    pub(super) fn new(paths: &'a Paths, sources: &'a Sources) -> Self {
        Self { paths, sources, running: RunningApplications::default() }
    }

    /// Notes an entry, whether it is shown or not.
    pub(super) fn advance(&mut self, entry: &LogEntry) {
        self.running.advance(entry);
    }

    /// Converts the entry that was noted last.
    pub(super) fn record(&self, file: &str, entry: &LogEntry) -> MessageRecord {
        let subject = entry.subject();
        let explanation = explanation(entry);
        let running = self.running.only().filter(|_| is_of_program(entry, subject.error));
        let sources = self.sources.lines(entry, self.running.latest());
        let only_source = match sources.as_slice() {
            [(_, line)] => Some(line.application.clone()),
            _ => None,
        };
        MessageRecord {
            file: file.to_owned(),
            line: entry.line,
            form: entry.form.name(),
            time: entry.time.map(|time| time.to_string()),
            uptime: entry.uptime,
            level: entry.known_level().map(|level| level.name()),
            code: entry.code.clone(),
            text: entry.text.clone(),
            application: subject.application.or(only_source).or_else(|| running.map(str::to_owned)),
            task: subject.task,
            program: subject.program,
            code_line: subject.code_line,
            error: subject.error,
            sources: sources.into_iter().map(|(path, line)| self.source(&path, line)).collect(),
            topic: explanation.map(|EntryExplanation { topic, .. }| word(topic)),
            meaning: explanation.map(|explanation| explanation.meaning),
            cause: explanation.map(|explanation| explanation.cause).filter(|cause| !cause.is_empty()),
            remedy: explanation.map(|explanation| explanation.remedy).filter(|remedy| !remedy.is_empty()),
        }
    }

    fn source(&self, path: &camino::Utf8Path, line: val3_backup::log::SourceLine) -> SourceRecord {
        SourceRecord {
            application: line.application,
            file: self.paths.to_open(path),
            line: line.line,
            text: line.text,
            changed: line.is_changed,
        }
    }
}

/// Whether a running application has caused the message. A message of the compiler is about one that does not run.
fn is_of_program(entry: &LogEntry, error: Option<u16>) -> bool {
    let code = entry.known_code().unwrap_or("");
    error.is_some() || code.starts_with(OF_PROGRAMS) && !code.eq_ignore_ascii_case(COMPILE_ERROR)
}

/// Word for `val3 explain`.
fn word(topic: Topic) -> String {
    match topic {
        Topic::Name(name) => name.to_owned(),
        Topic::RuntimeError(number) => number.to_string(),
    }
}
