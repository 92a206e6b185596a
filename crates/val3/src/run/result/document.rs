//! The document of a result. docs/src/result.md describes its stable format.

use std::fmt;

use serde::Serialize;
use val3_machine::event::EndReason;

use super::listed::Listed;

/// Result of a run.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub(super) struct ResultDocument {
    /// Whether the exit code is 0.
    pub(super) ok: bool,
    pub(super) reason: ResultReason,
    /// Exit code of the command.
    pub(super) exit_code: u8,
    /// Time at the end on the controller's clock.
    pub(super) seconds: f64,
    /// Tasks that have not ended.
    pub(super) tasks: Vec<TaskEntry>,
    pub(super) errors: Listed<ErrorEntry>,
    /// Contacts, each in a sentence.
    pub(super) contacts: Vec<String>,
    /// The nearest near miss, in a sentence.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) near_misses: Option<String>,
    /// Notes of the run itself.
    pub(super) notes: Listed<String>,
    /// Lines that `?` has printed.
    pub(super) prints: Listed<String>,
    /// Lines of the event log, and messages on the screen.
    pub(super) log: Listed<String>,
    /// Lines of the user page at the end, if it has text.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) screen: Vec<String>,
    pub(super) moves: MovesEntry,
    /// Waits of tasks, longest first.
    pub(super) waits: Vec<WaitEntry>,
    /// Changes of inputs and outputs.
    pub(super) io: Listed<IoEntry>,
    /// Recommended next step, if the run did not end well.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) next: Option<String>,
}

/// Reason why a run has ended.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum ResultReason {
    /// The application has ended.
    #[default]
    Finished,
    /// The application was stopped from outside.
    Stopped,
    /// The run has reached `--until`.
    Limit,
    /// No task can continue.
    Stuck,
    /// Only failed tasks are left, or an instruction is not supported.
    Error,
    /// The operator has ended the run.
    Interrupted,
    /// The application has errors and was not started.
    Refused,
}

impl From<EndReason> for ResultReason {
    fn from(reason: EndReason) -> Self {
        match reason {
            EndReason::Finished => Self::Finished,
            EndReason::Stopped => Self::Stopped,
            EndReason::Limit => Self::Limit,
            EndReason::Error => Self::Error,
            EndReason::Refused => Self::Refused,
        }
    }
}

impl fmt::Display for ResultReason {
    /// Writes the word of the JSON document.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.serialize(f)
    }
}

/// A line of a program.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub(super) struct CodeLine {
    pub(super) program: String,
    /// Line in the file, from 1.
    pub(super) line: u32,
    pub(super) file: String,
    /// Code of the line, if the file can be read.
    #[serde(rename = "code_line", skip_serializing_if = "Option::is_none")]
    pub(super) code: Option<String>,
}

/// A task at the end of the run.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct TaskEntry {
    pub(super) name: String,
    /// Activity of the task, such as `waits for a condition`.
    pub(super) activity: String,
    #[serde(flatten)]
    pub(super) at: CodeLine,
}

/// A run-time error, or a path that the arm cannot follow.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct ErrorEntry {
    /// Seconds on the controller's clock.
    pub(super) t: f64,
    /// Number of the run-time error.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) code: Option<u16>,
    pub(super) message: String,
    #[serde(skip_serializing_if = "String::is_empty")]
    pub(super) task: String,
    #[serde(flatten)]
    pub(super) at: CodeLine,
    /// Whether another task has resumed or killed the task.
    pub(super) handled: bool,
    /// Meaning of the error, and the remedy.
    pub(super) help: String,
}

/// Moves of the arm.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub(super) struct MovesEntry {
    /// Number of started moves.
    pub(super) count: usize,
    /// Time in motion.
    pub(super) seconds: f64,
    /// Moves by program, longest time first.
    pub(super) programs: Vec<ProgramMoves>,
    /// Moves by line, longest time first.
    pub(super) lines: Vec<LineMoves>,
}

/// Moves of a program.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct ProgramMoves {
    pub(super) program: String,
    pub(super) count: usize,
    pub(super) seconds: f64,
}

/// Moves of a line.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct LineMoves {
    pub(super) program: String,
    pub(super) line: u32,
    pub(super) instruction: &'static str,
    pub(super) count: usize,
    pub(super) seconds: f64,
}

/// Time that a task has waited at a line.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct WaitEntry {
    pub(super) task: String,
    pub(super) program: String,
    pub(super) line: u32,
    /// The awaited condition or object.
    pub(super) what: String,
    pub(super) seconds: f64,
}

/// Change of an input or output.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct IoEntry {
    pub(super) t: f64,
    pub(super) link: String,
    pub(super) value: f64,
}

impl CodeLine {
    /// Program and line: `work:7`.
    pub(super) fn place(&self) -> String {
        format!("{}:{}", self.program, self.line)
    }
}

impl ResultDocument {
    /// Limits each list to this number of items.
    pub(super) fn shorten(&mut self, most: usize) {
        self.tasks.truncate(most);
        self.contacts.truncate(most);
        self.waits.truncate(most);
        self.moves.programs.truncate(most);
        self.moves.lines.truncate(most);
        self.errors.shorten(most);
        self.notes.shorten(most);
        self.prints.shorten(most);
        self.log.shorten(most);
        self.io.shorten(most);
    }
}
