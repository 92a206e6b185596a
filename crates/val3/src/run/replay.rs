//! `--replay`: repeats a recorded run, compares both, and ends the run at the recorded end.

use std::fmt::Display;

use camino::{Utf8Path, Utf8PathBuf};
use serde::Deserialize;
use serde_json::{Map, Value};
use val3_files::FileClass;
use val3_lang::ports::{Time, nanoseconds};
use val3_machine::event::{EndReason, Event};
use val3_session::json_fault;

use super::record::BEGIN;
use super::recorded_actions::RecordedActions;
use super::recorded_options::RecordedOptions;
use crate::args::RunArgs;
use crate::printable::one_line;
use crate::user_error::UserError;

/// Recording of a run.
#[derive(Debug)]
pub(super) struct RunRecording {
    path: Utf8PathBuf,
    /// Options of the recorded run; `None` if the recording does not contain them.
    options: Option<RecordedOptions>,
    /// Lines of the file, with one event each after the line of the options.
    lines: Vec<String>,
    /// Number of compared lines.
    compared: usize,
    /// Time of the last event.
    end: Time,
    /// End reason of the recorded run; `None` if the recording is incomplete.
    reason: Option<EndReason>,
    has_diverged: bool,
    /// Whether the events of the run are compared.
    is_compared: bool,
}

/// First difference between a run and its recording.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Divergence {
    path: Utf8PathBuf,
    /// Line of the recording, from 1.
    line: usize,
    recorded: Option<String>,
    found: Option<String>,
    has_options: bool,
}

/// First line of a recording.
#[derive(Deserialize)]
struct FirstLine {
    kind: String,
    #[serde(default)]
    options: Option<RecordedOptions>,
}

/// Adds the options of the recorded run to the arguments that name a recording.
///
/// # Errors
/// The file cannot be read, or is no recording.
pub(crate) fn complete(args: &mut RunArgs) -> Result<(), UserError> {
    let Some(path) = &args.replay else { return Ok(()) };
    match RunRecording::open(path)?.options {
        Some(options) => options.complete(args),
        None => Ok(()),
    }
}

/// Whether the line is the beginning of a JSON value.
fn is_cut(line: &str) -> bool {
    serde_json::from_str::<Value>(line).is_err_and(|error| error.is_eof())
}

fn unusable(path: &Utf8Path, reason: &dyn Display) -> UserError {
    UserError::new(format!("cannot replay `{path}`: {reason}"))
        .with_help("name a file that `val3 run --events` has written")
}

/// Event fields that state the end of a recording.
#[derive(Deserialize)]
struct RecordingEnd {
    t: f64,
    kind: String,
    reason: Option<EndReason>,
}

impl RunRecording {
    /// Reads a recording.
    ///
    /// # Errors
    /// The file cannot be read, or is no recording.
    pub(super) fn open(path: &Utf8Path) -> Result<Self, UserError> {
        let text = val3_files::read_text(path, FileClass::Record).map_err(|error| unusable(path, &error))?;
        Self::parse(path, &text).map_err(|reason| unusable(path, &reason))
    }

    fn parse(path: &Utf8Path, text: &str) -> Result<Self, String> {
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        // If the recorded run was killed, its last line may be incomplete.
        lines.pop_if(|line| !text.ends_with('\n') && is_cut(line));
        let first = lines.first().ok_or("the file has no events")?;
        let first: FirstLine = serde_json::from_str(first).map_err(|error| json_fault(&error, 1))?;
        let options = first.options.filter(|_| first.kind == BEGIN);
        let compared = usize::from(options.is_some());
        let last = lines.get(compared..).and_then(<[String]>::last).ok_or("the file has no events")?;
        let last: RecordingEnd = serde_json::from_str(last).map_err(|error| json_fault(&error, lines.len()))?;
        let reason = last.reason.filter(|_| last.kind == "end");
        Ok(Self {
            path: path.to_owned(),
            options,
            lines,
            compared,
            end: nanoseconds(last.t),
            reason,
            has_diverged: false,
            is_compared: true,
        })
    }

    /// Actions of the recorded run, and the lines whose other end was its script.
    ///
    /// # Errors
    /// A line is no event.
    pub(super) fn actions(&self) -> Result<(RecordedActions, Vec<String>), UserError> {
        let actions = RecordedActions::of(&self.lines).map_err(|reason| unusable(&self.path, &reason))?;
        Ok((actions, self.options.as_ref().map(|options| options.silent.clone()).unwrap_or_default()))
    }

    /// Time limit of the run: the recorded end, unless the recorded run has ended by itself.
    pub(super) fn limit(&self) -> Option<Time> {
        let is_by_itself = matches!(self.reason, Some(EndReason::Finished | EndReason::Error | EndReason::Refused));
        (!is_by_itself).then_some(self.end)
    }

    /// Whether the run has continued after the recorded end.
    pub(super) fn is_over(&self, now: Time) -> bool {
        self.limit().map_or(now > self.end, |limit| now >= limit)
    }

    /// End reason of the recorded run.
    pub(super) fn reason(&self) -> EndReason {
        self.reason.unwrap_or(EndReason::Stopped)
    }

    /// Whether the run differs from the recording.
    pub(super) fn has_diverged(&self) -> bool {
        self.has_diverged
    }

    /// Ends the comparison without a difference: from now on a debugger changes the run.
    pub(super) fn end_comparison(&mut self) {
        self.is_compared = false;
    }

    /// Compares the next event of the run. Returns the first difference, once.
    pub(super) fn compare(&mut self, event: &Event) -> Option<Divergence> {
        let at = self.compared;
        self.compared += 1;
        let recorded = self.lines.get(at);
        let is_cut_off = recorded.is_none() && self.reason.is_none();
        let found = serde_json::to_string(event).ok();
        if !self.is_compared || self.has_diverged || is_cut_off || is_equal(recorded, found.as_ref()) {
            return None;
        }
        let recorded = recorded.cloned();
        self.diverge(at, recorded, found)
    }

    /// Compares a run in which no task can continue. Returns the difference if the recorded run has continued.
    pub(super) fn compare_stuck(&mut self) -> Option<Divergence> {
        let next = self.lines.get(self.compared).filter(|_| self.is_compared && !self.has_diverged)?;
        let kind = serde_json::from_str::<FirstLine>(next).map(|line| line.kind).unwrap_or_default();
        let next = Some(next.clone()).filter(|_| kind != "stuck" && kind != "end")?;
        self.diverge(self.compared, Some(next), None)
    }

    /// Ends the comparison. Returns the difference if recorded events are missing and the run did not differ before.
    pub(super) fn finish(&mut self) -> Option<Divergence> {
        let next = self.lines.get(self.compared).filter(|_| self.is_compared && !self.has_diverged)?.clone();
        self.diverge(self.compared, Some(next), None)
    }

    fn diverge(&mut self, at: usize, recorded: Option<String>, found: Option<String>) -> Option<Divergence> {
        self.has_diverged = true;
        let has_options = self.options.is_some();
        Some(Divergence { path: self.path.clone(), line: at + 1, recorded, found, has_options })
    }
}

/// Whether two events are equal, regardless of field order, number format, and the folder of the application.
fn is_equal(one: Option<&String>, other: Option<&String>) -> bool {
    one == other || event(one).is_some_and(|one| Some(one) == event(other))
}

/// Fields of an event, without the absolute path of a source file.
fn event(line: Option<&String>) -> Option<Map<String, Value>> {
    let mut fields: Map<String, Value> = serde_json::from_str(line?).ok()?;
    fields.remove("file");
    Some(fields)
}

impl From<Divergence> for UserError {
    fn from(divergence: Divergence) -> Self {
        let Divergence { path, line, recorded, found, has_options } = divergence;
        let shown = |event: Option<String>, none: &str| event.unwrap_or_else(|| none.to_owned());
        let recorded = shown(recorded, "the recorded run had already ended");
        let found = shown(found, "this run has no further event");
        let help = match has_options {
            true => "use the files of the application and the version of val3 with which the run was recorded",
            false => "use the application and the options of the recording, including --script and --keys",
        };
        Self::new(format!("the run differs from `{path}` at line {line}"))
            .with_details(format!("  recorded: {}\n  this run: {}", one_line(&recorded), one_line(&found)))
            .with_help(help)
    }
}

#[cfg(test)]
mod tests {
    use val3_machine::event::EventKind;

    use super::*;

    fn print(t: f64, text: &str) -> Event {
        Event { t, task: None, at: None, kind: EventKind::Print { text: text.to_owned() } }
    }

    const PRINTS: &str =
        "{\"kind\":\"print\",\"t\":1.0,\"text\":\"a\"}\n{\"t\":2.5,\"kind\":\"print\",\"text\":\"b\"}\n";

    #[test]
    fn the_first_difference_is_found() {
        let mut recording = RunRecording::parse("run.json".into(), PRINTS).unwrap();
        assert_eq!(recording.compare(&print(1.0, "a")), None);
        let divergence = recording.compare(&print(2.5, "c")).unwrap();
        assert_eq!((divergence.line, divergence.found.unwrap().contains("\"c\"")), (2, true));
        assert_eq!(recording.compare(&print(3.0, "d")), None, "only the first one is reported");
        assert_eq!(recording.finish(), None);
    }

    #[test]
    fn a_run_that_ends_too_early_differs() {
        let mut recording = RunRecording::parse("run.json".into(), PRINTS).unwrap();
        recording.compare(&print(1.0, "a"));
        assert_eq!(recording.finish().unwrap().line, 2);
    }

    #[test]
    fn an_ended_comparison_finds_no_difference() {
        let mut recording = RunRecording::parse("run.json".into(), PRINTS).unwrap();
        recording.end_comparison();
        assert_eq!((recording.compare(&print(1.0, "x")), recording.finish()), (None, None));
        assert!(!recording.has_diverged() && recording.limit() == Some(2_500_000_000));
    }

    #[test]
    fn a_recording_may_end_early() {
        let mut recording = RunRecording::parse("run.json".into(), &format!("{PRINTS}{{\"t\":2.5,\"ki")).unwrap();
        assert_eq!((recording.limit(), recording.lines.len()), (Some(2_500_000_000), 2));
        recording.compare(&print(1.0, "a"));
        recording.compare(&print(2.5, "b"));
        assert_eq!((recording.compare(&print(2.5, "c")), recording.finish()), (None, None));
    }

    #[test]
    fn the_recorded_reason_decides_whether_the_run_must_end() {
        let end = |reason: &str| format!("{{\"t\":4.0,\"kind\":\"end\",\"reason\":\"{reason}\"}}\n");
        let open = |reason: &str| RunRecording::parse("run.json".into(), &end(reason)).unwrap();
        assert_eq!(open("limit").limit(), Some(4_000_000_000));
        assert_eq!(open("finished").limit(), None);
        assert!(open("finished").is_over(4_004_000_000) && !open("finished").is_over(4_000_000_000));
        assert!(RunRecording::parse("run.json".into(), "").is_err());
        assert!(RunRecording::parse("run.json".into(), "hello\n").is_err());
    }
}
