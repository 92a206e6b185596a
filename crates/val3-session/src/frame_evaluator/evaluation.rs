//! Evaluation results and errors.

use std::error::Error;
use std::fmt::{self, Display};

use val3_debug::{DebugValue, Stop, TaskFrame, end_message};
use val3_machine::event::Event;
use val3_vm::FragmentEnd;

use crate::evaluate::{CodeFault, EvaluationOutput, PageText};

/// Evaluation result.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Evaluation {
    /// Value; `None` for statements.
    pub value: Option<DebugValue>,
    /// Lines that were printed, logged or shown in pop-ups.
    pub output: Vec<String>,
    /// All events of the evaluation.
    pub events: Vec<Event>,
    /// Whether statements were executed, so that data, outputs and tasks may differ from the recorded future of the
    /// run.
    pub changes_run: bool,
    /// Number of breakpoints that the code has passed in called programs, where they have no effect.
    pub passed_stops: u32,
    /// Stop in a called program. The rest of the code is on the stack of the task.
    pub stop: Option<Stop>,
}

impl Evaluation {
    /// An assignment, which shows the new value.
    pub(super) fn of_assignment(value: DebugValue) -> Self {
        Self { value: Some(value), ..Self::new(Vec::new(), true) }
    }

    /// An evaluation with these events.
    pub(super) fn new(events: Vec<Event>, changes_run: bool) -> Self {
        Self { value: None, output: output(&events), events, changes_run, passed_stops: 0, stop: None }
    }
}

/// Reason why code was not evaluated to its end.
#[derive(Debug, Clone, PartialEq)]
pub enum EvaluationError {
    /// The code is invalid or not allowed here.
    Code(CodeFault),
    /// The execution ended early.
    Ended {
        /// The reason, with the number of a run-time error.
        message: String,
        /// Result of the executed part.
        done: Box<Evaluation>,
    },
}

impl EvaluationError {
    pub(super) fn ended<T>(end: &FragmentEnd<T>, done: Evaluation) -> Self {
        Self::Ended { message: end_message(end), done: Box::new(done) }
    }

    /// The error in a line of a called program.
    pub(super) fn ended_at<T>(end: &FragmentEnd<T>, line: Option<&TaskFrame>, done: Evaluation) -> Self {
        let place = line.map(|line| format!(" ({}:{}(), line {})", line.application, line.program, line.row));
        Self::Ended { message: end_message(end) + &place.unwrap_or_default(), done: Box::new(done) }
    }

    /// Result of the part that was executed before the error.
    #[must_use]
    pub fn done(&self) -> Option<&Evaluation> {
        match self {
            Self::Code(_) => None,
            Self::Ended { done, .. } => Some(done),
        }
    }
}

impl From<String> for EvaluationError {
    fn from(message: String) -> Self {
        Self::Code(message.into())
    }
}

impl From<&str> for EvaluationError {
    fn from(message: &str) -> Self {
        message.to_owned().into()
    }
}

impl Display for EvaluationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Code(fault) => f.write_str(fault.message()),
            Self::Ended { message, .. } => f.write_str(message),
        }
    }
}

impl Error for EvaluationError {}

/// Lines that an evaluation has printed. Text on a user page counts as printed.
fn output(events: &[Event]) -> Vec<String> {
    let mut page = PageText::default();
    let mut outputs: Vec<EvaluationOutput> =
        events.iter().flat_map(|event| EvaluationOutput::all_of(event, false, &mut page)).collect();
    outputs.extend(page.take().map(EvaluationOutput::Line));
    outputs.iter().filter(|output| output.is_sound()).map(ToString::to_string).collect()
}
