//! Occurrences in the cycles of a run, for expectations about times and orders.

use std::collections::BTreeMap;
use std::fmt;
use std::ops::Range;

use serde::de::Error as _;
use serde::{Deserialize, Deserializer};
use val3_lang::ports::Time;
use val3_machine::controller::Controller;
use val3_machine::event::{Event, EventKind, seconds};
use val3_machine::script::{Condition, NamedStates, SentText};

use super::fit::{ExpectationFault, Fit};
use super::output::OutputKind;
use super::{filled, screen};

/// State at the end of a cycle.
#[derive(Clone, Copy)]
pub(crate) struct CycleState<'c> {
    /// Start of the cycle, on the controller's clock in nanoseconds.
    pub(crate) start: Time,
    /// Events of the cycle.
    pub(crate) events: &'c [Event],
    /// Controller at the end of the cycle.
    pub(crate) controller: &'c Controller,
}

/// An occurrence in a run, as a table with one key.
#[derive(Debug, Clone, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Occurrence {
    /// Values of signals.
    #[serde(deserialize_with = "signals")]
    Io(Condition),
    /// Values of global variables.
    #[serde(deserialize_with = "variables")]
    Data(Condition),
    /// Sensors of the cell that detect something.
    #[serde(deserialize_with = "sensors")]
    Seen(Condition),
    /// Parts of the cell that grippers hold.
    #[serde(deserialize_with = "parts")]
    Held(Condition),
    /// A text on the displayed page.
    #[serde(deserialize_with = "filled::page_text")]
    Screen(String),
    /// A text in a printed line.
    Print(String),
    /// A text in a line of the event log.
    Log(String),
    /// A text in a message.
    Popup(String),
    /// A text sent over a line.
    Sent(SentText),
    /// Start of a move.
    Move(MoveStart),
    /// A run-time error that stops a task.
    Error(u16),
}

/// Start of a move that a program has recorded, as the text `pick`, or `pick:12` for the move in a line of its file.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(try_from = "String")]
pub(super) struct MoveStart {
    program: String,
    /// Line of the file, from 1; `None` for any move of the program.
    line: Option<u32>,
}

impl TryFrom<String> for MoveStart {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        let Some((program, line)) = text.rsplit_once(':') else { return Ok(Self { program: text, line: None }) };
        let number = line.parse().ok().filter(|line| *line > 0);
        let number = number.ok_or_else(|| format!("`{line}` is no line: write `PROGRAM` or `PROGRAM:LINE`"))?;
        Ok(Self { program: program.to_owned(), line: Some(number) })
    }
}

impl fmt::Display for MoveStart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { program, line } = self;
        match line {
            Some(line) => write!(f, "a move of `{program}` in line {line} starts"),
            None => write!(f, "a move of `{program}` starts"),
        }
    }
}

fn signals<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Condition, D::Error> {
    Condition::new(Deserialize::deserialize(deserializer)?, BTreeMap::new()).map_err(D::Error::custom)
}

fn variables<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Condition, D::Error> {
    Condition::new(BTreeMap::new(), Deserialize::deserialize(deserializer)?).map_err(D::Error::custom)
}

fn sensors<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Condition, D::Error> {
    Condition::of_cell(Deserialize::deserialize(deserializer)?, NamedStates::default()).map_err(D::Error::custom)
}

fn parts<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Condition, D::Error> {
    Condition::of_cell(NamedStates::default(), Deserialize::deserialize(deserializer)?).map_err(D::Error::custom)
}

/// Occurrence time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct OccurrenceTime {
    /// Seconds since the start.
    pub(super) time: f64,
    /// Number of events in the cycle up to and including the occurrence.
    pub(super) events: usize,
}

impl Occurrence {
    /// First occurrence in a cycle after the first `seen` events. States are checked at the end of the cycle.
    pub(super) fn find(&self, cycle: CycleState<'_>, seen: usize) -> Option<OccurrenceTime> {
        let state = |holds: bool| holds.then(|| OccurrenceTime { time: seconds(cycle.controller.now()), events: seen });
        match self {
            Self::Io(condition) | Self::Data(condition) | Self::Seen(condition) | Self::Held(condition) => {
                state(cycle.controller.meets(condition))
            }
            Self::Screen(text) => state(screen::shown(cycle.controller).is_some_and(|page| screen::shows(page, text))),
            _ => {
                let mut events = cycle.events.iter().zip(1..).skip(seen);
                let (event, events) = events.find(|(event, _)| self.is(event))?;
                Some(OccurrenceTime { time: event.t, events })
            }
        }
    }

    /// Whether the event matches.
    fn is(&self, event: &Event) -> bool {
        let contains = |kind: OutputKind, part: &str| kind.text(event).is_some_and(|text| text.contains(part));
        match (self, &event.kind) {
            (Self::Print(text), _) => contains(OutputKind::Print, text),
            (Self::Log(text), _) => contains(OutputKind::Log, text),
            (Self::Popup(text), _) => contains(OutputKind::Popup, text),
            (Self::Sent(text), _) => text.is_sent_by(event),
            (Self::Move(expected), EventKind::Move { phase: "started", program, line, .. }) => {
                *program == expected.program && expected.line.is_none_or(|expected| expected == *line)
            }
            (Self::Error(expected), EventKind::Error { code, .. }) => code == expected,
            _ => false,
        }
    }

    /// Unknown names in the occurrence.
    pub(super) fn faults(&self, fit: &Fit<'_>, span: &Range<usize>) -> Vec<ExpectationFault> {
        match self {
            Self::Io(condition) | Self::Data(condition) | Self::Seen(condition) | Self::Held(condition) => {
                fit.condition(condition, span)
            }
            Self::Sent(text) => fit.line(text.link(), span).into_iter().collect(),
            Self::Move(MoveStart { program, .. }) => fit.program(program, span).into_iter().collect(),
            Self::Error(code) => fit.error(*code, span).into_iter().collect(),
            Self::Screen(_) | Self::Print(_) | Self::Log(_) | Self::Popup(_) => Vec::new(),
        }
    }

    /// Link of the line over which a text is sent.
    pub(super) fn line(&self) -> Option<&str> {
        match self {
            Self::Sent(text) => Some(text.link()),
            _ => None,
        }
    }

    /// Actual state instead of the expected state, if known.
    pub(super) fn instead(&self, controller: &Controller) -> Option<String> {
        match self {
            Self::Io(condition) | Self::Data(condition) | Self::Seen(condition) | Self::Held(condition) => {
                let mismatches = controller.mismatches(condition);
                let texts: Vec<String> = mismatches.iter().map(ToString::to_string).collect();
                (!texts.is_empty()).then(|| texts.join("; "))
            }
            Self::Screen(_) => screen::shown(controller).map(screen::picture),
            _ => None,
        }
    }
}

/// Formats the occurrence as a clause.
impl fmt::Display for Occurrence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Io(condition) | Self::Data(condition) | Self::Seen(condition) | Self::Held(condition) => {
                condition.fmt(f)
            }
            Self::Screen(text) => write!(f, "the screen shows {text:?}"),
            Self::Print(text) => write!(f, "{text:?} is printed"),
            Self::Log(text) => write!(f, "the event log says {text:?}"),
            Self::Popup(text) => write!(f, "the message {text:?} comes up"),
            Self::Sent(text) => text.fmt(f),
            Self::Move(start) => start.fmt(f),
            Self::Error(code) => write!(f, "error {code} stops a task"),
        }
    }
}
