//! Commands of `val3` that the tools start.

use std::time::Duration;

use serde_json::Value;

use crate::refusal::Refusal;

/// Limits of a command.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CommandLimits {
    /// Wall-clock time after which the command is killed.
    pub wall: Duration,
    /// Memory limit in bytes, on systems that support it.
    pub memory: u64,
}

/// Limits for commands that execute one program.
pub(crate) const OF_RUNS: CommandLimits = CommandLimits { wall: Duration::from_secs(10), memory: 512 << 20 };

/// Limits for commands that read or test whole cells on several threads.
pub(crate) const OF_CELLS: CommandLimits = CommandLimits { wall: Duration::from_secs(60), memory: 2 << 30 };

/// A command and its input.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CommandRequest {
    /// Name and arguments of the command, for example `check`, `usr`.
    pub arguments: Vec<String>,
    /// Text of the standard input.
    pub input: String,
    /// Script text, which is passed to the command as a temporary file with `--script`.
    pub script: Option<String>,
    /// Limits.
    pub limits: CommandLimits,
}

impl CommandRequest {
    pub(crate) fn new(arguments: impl IntoIterator<Item = impl Into<String>>, limits: CommandLimits) -> Self {
        let arguments = arguments.into_iter().map(Into::into).collect();
        Self { arguments, input: String::new(), script: None, limits }
    }
}

/// Output of a command that has ended by itself.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct CommandOutput {
    /// Exit code.
    pub exit_code: i32,
    /// Standard output.
    pub text: String,
    /// Standard error output.
    pub messages: String,
}

impl CommandOutput {
    /// Whether the command rejects the arguments, or could not read a named file or execute a named test.
    fn is_incomplete(&self) -> bool {
        self.exit_code == USAGE
    }
}

/// Report of a command.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Report {
    /// JSON document.
    pub(crate) document: Value,
    /// Whether the command has read all named files and executed all named tests.
    pub(crate) is_complete: bool,
    /// Exit code.
    pub(crate) exit_code: i32,
    /// Standard error output.
    pub(crate) messages: String,
}

/// Reason why a command has not returned an output.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum CommandEnd {
    /// The command has exceeded its wall-clock time.
    Time,
    /// The client has cancelled the call.
    Cancelled,
    /// The command has written more output than the server reads.
    Output,
    /// A signal has ended the command because of a panic or the memory limit. The text is the last message of the
    /// command.
    Crash(String),
    /// The command cannot be started.
    Start(String),
}

/// Starts commands of `val3`.
pub trait Commands: Send + Sync {
    /// Starts a command in the first root and waits for its end. `is_cancelled` is polled meanwhile.
    ///
    /// # Errors
    ///
    /// The command could not be started, was ended early, or has written too much output.
    fn start(&self, request: &CommandRequest, is_cancelled: &dyn Fn() -> bool) -> Result<CommandOutput, CommandEnd>;
}

/// Exit code for wrong arguments and unreadable files.
const USAGE: i32 = 2;

/// Starts a command.
///
/// # Errors
///
/// The command rejects its arguments, has exceeded a limit or was ended.
pub(crate) fn run(
    commands: &dyn Commands,
    request: &CommandRequest,
    is_cancelled: &dyn Fn() -> bool,
) -> Result<CommandOutput, Refusal> {
    let output = started(commands, request, is_cancelled)?;
    if output.is_incomplete() { Err(Refusal::new(output.messages.trim())) } else { Ok(output) }
}

/// Starts a command that writes a report as a JSON document. If the command could not read some files, the report
/// describes them, and is returned as well.
///
/// # Errors
///
/// The command rejects its arguments or writes no report, has exceeded a limit or was ended.
pub(crate) fn report(
    commands: &dyn Commands,
    request: &CommandRequest,
    is_cancelled: &dyn Fn() -> bool,
) -> Result<Report, Refusal> {
    let output = started(commands, request, is_cancelled)?;
    match serde_json::from_str(&output.text) {
        Ok(document) => Ok(Report {
            document,
            is_complete: !output.is_incomplete(),
            exit_code: output.exit_code,
            messages: output.messages,
        }),
        Err(_) if output.is_incomplete() && output.text.trim().is_empty() => Err(Refusal::new(output.messages.trim())),
        Err(error) => {
            Err(Refusal(format!("the output of the command cannot be read ({error}): {}", output.messages.trim())))
        }
    }
}

/// Starts a command, and returns the output for any exit code.
fn started(
    commands: &dyn Commands,
    request: &CommandRequest,
    is_cancelled: &dyn Fn() -> bool,
) -> Result<CommandOutput, Refusal> {
    let name = request.arguments.first().map(String::as_str).unwrap_or_default();
    commands.start(request, is_cancelled).map_err(|end| Refusal::new(ended(name, &end, request.limits)))
}

fn ended(name: &str, end: &CommandEnd, limits: CommandLimits) -> String {
    match end {
        CommandEnd::Time => format!(
            "`{name}` was ended after {} s of wall time: name a smaller part of the cell, or shorten the run with `until`",
            limits.wall.as_secs()
        ),
        CommandEnd::Cancelled => format!("`{name}` was cancelled"),
        CommandEnd::Output => format!("`{name}` was ended because it writes without end: print less in the program"),
        CommandEnd::Crash(message) => format!(
            "`{name}` has ended unexpectedly, by a fault of val3 or because it needs more than {} MB: report it, with \
             the call and this message: {message}",
            limits.memory >> 20
        ),
        CommandEnd::Start(reason) => format!("`{name}` cannot be started: {reason}"),
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn every_end_has_its_remedy() {
        let shown = |end: CommandEnd| ended("run", &end, OF_RUNS);
        expect![
            "`run` was ended after 10 s of wall time: name a smaller part of the cell, or shorten the run with `until`"
        ]
        .assert_eq(&shown(CommandEnd::Time));
        expect!["`run` was ended because it writes without end: print less in the program"]
            .assert_eq(&shown(CommandEnd::Output));
        expect!["`run` has ended unexpectedly, by a fault of val3 or because it needs more than 512 MB: report it, with the call and this message: memory"]
            .assert_eq(&shown(CommandEnd::Crash("memory".to_owned())));
    }
}
