//! States of tasks, robot and signals.

use schemars::JsonSchema;
use serde::Serialize;

/// State of tasks and robot.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct StateMessage {
    /// Time in s.
    pub t: f64,
    /// Tasks, the oldest first.
    pub tasks: Vec<TaskState>,
    /// Whether the arm has power.
    pub power: bool,
    /// Working mode.
    pub mode: String,
    /// State of the emergency stop: `none`, `released` or `open`.
    pub emergency_stop: String,
    /// Whether the operator or the working mode holds the arm, also if no move is recorded.
    pub is_held: bool,
    /// Why the arm does not move although moves are recorded, as sentences for an operator.
    pub held_because: Option<String>,
    /// Why the arm that a task waits for does not move, as sentences for an operator.
    pub awaited_hold: Option<String>,
    /// Whether the arm rests on its path because its next move is not recorded yet.
    pub awaits_next_move: bool,
    /// Monitor speed in %.
    pub monitor_speed: f64,
    /// Configuration of the arm in words, as in points.
    pub config: String,
}

/// State of a task.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct TaskState {
    /// Task name.
    pub name: String,
    /// State in a word: `running`, `waiting`, `suspended` or `error`.
    pub state: String,
    /// Current program.
    pub program: String,
    /// Current line in the file, from 1.
    pub line: u32,
    /// Path of the program's file.
    pub file: String,
    /// Lines that have called the current program, the innermost call first; at most 16.
    pub callers: Vec<CallingLine>,
    /// Priority, if the task is asynchronous.
    pub priority: Option<u32>,
    /// Period of a synchronous task, in s.
    pub period: Option<f64>,
    /// Number of overruns, if the task is synchronous.
    pub overruns: u32,
    /// Awaited condition, and the reason why the arm does not move.
    pub waits: Option<String>,
    /// Awaited condition only.
    pub awaits: Option<String>,
    /// Number of the run-time error that has stopped the task.
    pub error: Option<u16>,
    /// Code of the line, if the task waits or was stopped by an error.
    pub line_code: Option<String>,
}

/// Line that has called a program.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct CallingLine {
    /// Program of the line.
    pub program: String,
    /// Line in the file, from 1.
    pub line: u32,
    /// Path of the program's file.
    pub file: String,
}

/// State of a signal.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct SignalState {
    /// Physical path.
    pub link: String,
    /// Value that programs read: the locked value, otherwise the value at the terminal of an input or the written
    /// value of an output.
    #[schemars(with = "f64")]
    pub value: Option<f64>,
    /// Whether the value is locked.
    pub is_locked: bool,
    /// Whether the input is simulated.
    pub is_simulated: bool,
    /// Whether the output is reserved for the system.
    pub is_protected: bool,
    /// Fault of the device.
    pub fault: Option<String>,
}
