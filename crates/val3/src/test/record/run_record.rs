//! Event record of a run (`val3 run --events`), as far as a scenario can repeat it.

use std::collections::{BTreeMap, BTreeSet};

use serde::Deserialize;
use serde_json::{Map, Value};
use val3_machine::event::EndReason;
use val3_machine::script::{LineBytes, ScriptAction};
use val3_session::json_fault;
use val3_suite::ControllerKeys;

/// Contents of an event record.
#[derive(Debug, Default)]
pub(super) struct RunRecord {
    /// External input, with the time in seconds.
    pub(super) given: Vec<(f64, Given)>,
    /// Lines that have sent bytes and received none.
    pub(super) silent: Vec<String>,
    /// Started program.
    pub(super) program: Option<String>,
    /// Last time in the record, in seconds.
    pub(super) end: f64,
    /// End reason of the run; `None` if the run continues or the record is incomplete.
    pub(super) reason: Option<EndReason>,
    /// Whether the run continues after the record.
    pub(super) continues: bool,
    pub(super) prints: Vec<String>,
    pub(super) logs: Vec<String>,
    pub(super) popups: Vec<String>,
    /// Sent bytes by line.
    pub(super) sent: BTreeMap<String, Vec<u8>>,
    pub(super) errors: Vec<RecordedError>,
    /// Last value of each signal that was not set externally.
    pub(super) signals: BTreeMap<String, f64>,
    /// Whether power was on at the start.
    has_power: bool,
    /// Lines whose responses a script cannot repeat.
    pub(super) unusual: BTreeSet<String>,
}

/// External input.
#[derive(Debug)]
pub(super) enum Given {
    /// Keys for an `[[at]]` table.
    Keys(Map<String, Value>),
    /// Input that no script can repeat.
    Other(String),
}

/// Run-time error that has stopped a task.
#[derive(Debug, PartialEq)]
pub(super) struct RecordedError {
    pub(super) code: u16,
    pub(super) task: Option<String>,
    pub(super) program: String,
}

/// Line of the record.
#[derive(Deserialize)]
struct RecordLine {
    t: f64,
    task: Option<String>,
    #[serde(flatten)]
    kind: RecordedKind,
}

/// Events that are relevant for a scenario.
#[derive(Deserialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
enum RecordedKind {
    Act {
        keys: Map<String, Value>,
    },
    Sio {
        link: String,
        dir: String,
        bytes: Vec<u8>,
    },
    Line {
        link: String,
        answer: Value,
    },
    Task {
        state: String,
        program: String,
    },
    Power {
        on: bool,
    },
    Print {
        text: String,
    },
    Log {
        text: String,
    },
    Popup {
        text: String,
    },
    Error {
        code: u16,
        program: String,
    },
    Io {
        link: String,
        value: f64,
    },
    End {
        reason: EndReason,
    },
    #[serde(other)]
    Other,
}

impl RunRecord {
    /// Parses the text of a record.
    ///
    /// # Errors
    /// The text is no record, or the application was not started.
    pub(super) fn read(text: &str) -> Result<Self, String> {
        let mut lines = Vec::new();
        for (number, line) in (1..).zip(text.lines()) {
            match serde_json::from_str::<RecordLine>(line) {
                Ok(line) => lines.push(line),
                // The last line of a run that was killed may be incomplete.
                Err(error) if error.is_eof() && !text.ends_with('\n') => break,
                Err(error) => return Err(json_fault(&error, number)),
            }
        }
        if lines.is_empty() {
            return Err("the file has no events".to_owned());
        }
        let supplied: BTreeSet<String> = lines.iter().flat_map(RecordLine::supplied).collect();
        let mut run = Self::default();
        lines.into_iter().for_each(|line| run.add(line, &supplied));
        if run.reason == Some(EndReason::Refused) {
            return Err("the application was not started because of its faults".to_owned());
        }
        let received: BTreeSet<&String> = run.given.iter().flat_map(|(_, given)| given.receiving_links()).collect();
        run.silent = run.sent.keys().filter(|link| !received.contains(link)).cloned().collect();
        Ok(run)
    }

    /// Marks the run as still running at the time `now` in seconds.
    pub(super) fn continue_at(&mut self, now: f64) {
        self.end = self.end.max(now);
        self.continues = self.reason.is_none();
    }

    /// Controller properties at the start.
    pub(super) fn controller_keys(&self) -> ControllerKeys {
        ControllerKeys { power: self.has_power, ..ControllerKeys::default() }
    }

    /// Whether the application was stopped externally. The scenario repeats the stop.
    pub(super) fn is_stopped(&self) -> bool {
        self.given.iter().any(|(_, given)| matches!(given, Given::Keys(keys) if keys.contains_key("stop")))
    }

    fn add(&mut self, RecordLine { t, task, kind }: RecordLine, supplied: &BTreeSet<String>) {
        self.end = t;
        match kind {
            RecordedKind::Act { keys } => self.act(t, keys),
            RecordedKind::Sio { link, dir, bytes } if dir == "out" => self.sent.entry(link).or_default().extend(bytes),
            // The script that has sent these bytes is part of the scenario.
            RecordedKind::Sio { link, .. } if supplied.contains(&link) => {}
            RecordedKind::Sio { link, bytes, .. } => {
                let bytes = serde_json::to_value(LineBytes::from(bytes.as_slice())).unwrap_or_default();
                let receive = Value::Object(Map::from_iter([(link, bytes)]));
                self.given.push((t, Given::Keys(Map::from_iter([("receive".to_owned(), receive)]))));
            }
            RecordedKind::Line { link, answer } if !is_usual(&answer) && !supplied.contains(&link) => {
                self.unusual.insert(link);
            }
            RecordedKind::Task { state, program } if state == "created" && self.program.is_none() => {
                self.program = Some(program);
            }
            RecordedKind::Power { on } if on && !self.given.iter().any(|(_, given)| given.is_about("power")) => {
                self.has_power = true;
            }
            RecordedKind::Print { text } => add(&mut self.prints, text),
            RecordedKind::Log { text } => add(&mut self.logs, text),
            RecordedKind::Popup { text } => add(&mut self.popups, text),
            RecordedKind::Error { code, program } => add(&mut self.errors, RecordedError { code, task, program }),
            RecordedKind::Io { link, value } => drop(self.signals.insert(link, value)),
            RecordedKind::End { reason } => self.reason = Some(reason),
            _ => {}
        }
    }

    fn act(&mut self, t: f64, keys: Map<String, Value>) {
        let given = match ScriptAction::from_json(keys.clone()) {
            Ok(_) => Given::Keys(keys),
            Err(_) => Given::Other(Value::Object(keys).to_string()),
        };
        self.given.push((t, given));
    }

    /// Whether external input sets this signal.
    pub(super) fn is_set(&self, link: &str) -> bool {
        self.given.iter().any(|(_, given)| given.sets(link))
    }
}

impl Given {
    fn is_about(&self, key: &str) -> bool {
        matches!(self, Self::Keys(keys) if keys.contains_key(key))
    }

    /// Whether the input sets this signal.
    fn sets(&self, link: &str) -> bool {
        ["io", "lock"].iter().any(|key| self.by_link(key).is_some_and(|links| links.contains_key(link)))
    }

    /// Lines that receive bytes.
    fn receiving_links(&self) -> impl Iterator<Item = &String> {
        self.by_link("receive").into_iter().flat_map(Map::keys)
    }

    /// Values of a key by link; `None` without this key.
    fn by_link(&self, key: &str) -> Option<&Map<String, Value>> {
        let Self::Keys(keys) = self else { return None };
        keys.get(key)?.as_object()
    }
}

impl RecordLine {
    /// Lines on which a script has sent bytes.
    fn supplied(&self) -> Vec<String> {
        let RecordedKind::Act { keys } = &self.kind else { return Vec::new() };
        keys.get("receive").and_then(Value::as_object).into_iter().flat_map(Map::keys).cloned().collect()
    }
}

/// Whether the response of a line is possible if a script is the other end.
fn is_usual(answer: &Value) -> bool {
    answer.get("connection").is_some_and(|state| state == "open")
        || answer.get("received").is_some_and(|received| received.get("bytes").is_some())
}

/// Adds an item unless the list already contains it.
fn add<T: PartialEq>(items: &mut Vec<T>, item: T) {
    if !items.contains(&item) {
        items.push(item);
    }
}
