//! Explains the end of a run: why it ended, and what its tasks wait for.

use std::io::{self, Write};

use val3_machine::controller::{Activity, CodeSource, Controller, RunStatus, TaskPosition};
use val3_machine::event::shown_seconds;
use val3_machine::sio::UnfinishedString;

use super::console::Console;
use super::end::End;
use super::missing::code;
use crate::args::RunArgs;
use crate::output::to_stderr;
use crate::printable::one_line;

/// Help for waiting tasks.
const UNSTICK: &str = "Change what a task waits for in a script (--script), type keys (--keys), or resume the task \
                       from another one.";

/// Help for a run that continues.
const GOES_ON: &str =
    "Ctrl-C or --until SECONDS ends the run. A script (--script) provides power, inputs, keys and messages.";

/// Help for a cyclic program, whose normal end is the limit.
const EXPECTED: &str = "With --until-ok the exit code is 0.";

/// Help for moves that were recorded and not executed.
const AWAIT: &str = "waitEndMove() waits for recorded moves.";

/// Maximum number of listed moves.
const MOST_MOVES: usize = 20;

/// Help for an interrupted run.
const RECORDED: &str = "A run that is recorded with --events FILE can be repeated up to this point with --replay.";

/// Help for an interrupted run with clients, whose actions `--replay` cannot repeat.
const RECORDED_CLIENTS: &str = "A run that is recorded with --events FILE can be repeated without clients: \
                                `val3 test --record FILE` writes a scenario.";

/// Maximum number of listed tasks. Applications have about ten; a faulty loop with `taskCreate` has thousands.
const MOST_TASKS: usize = 50;

impl Console {
    /// Explains why the run has ended before its application, and lists its tasks' lines.
    pub(crate) fn explain(&self, end: End, args: &RunArgs, controller: &Controller) {
        if self.is_silent {
            return;
        }
        let now = shown_seconds(controller.now());
        match end {
            // The errors of tasks are shown with their lines.
            End::Controller(RunStatus::Stuck) if controller.has_only_failed_tasks() => {}
            End::Controller(RunStatus::Stuck) => {
                self.list(&format!("error: no task can continue after {now} s"), UNSTICK, controller);
            }
            End::Controller(RunStatus::Limit) if !args.until_ok => {
                self.list(&format!("note: the run was ended after {now} s (--until)"), EXPECTED, controller);
            }
            End::BrokenOff(_) if !args.interactive => {
                let has_clients = args.soap.is_some() || args.modbus.is_some();
                let help = if has_clients { RECORDED_CLIENTS } else { RECORDED };
                self.list(&format!("note: the run was interrupted after {now} s"), help, controller);
            }
            End::Left => {
                self.list(&format!("note: the debugger has ended the run after {now} s"), RECORDED, controller)
            }
            End::Controller(RunStatus::Finished) => self.list_dropped_moves(controller),
            End::Controller(_) | End::Recorded(_) | End::Unread | End::Unwritten | End::Restart | End::BrokenOff(_) => {
            }
        }
    }

    /// Lists what the tasks of a continuing run wait for.
    pub(super) fn list_waits(&self, message: &str, controller: &Controller) {
        if !self.is_silent {
            self.list(message, GOES_ON, controller);
        }
    }

    /// Writes a note to the standard error output, unless a client shows the output.
    pub(super) fn note(&self, text: &str) {
        if !self.is_silent {
            to_stderr(|out| writeln!(out, "{}", one_line(text)));
        }
    }

    fn list(&self, message: &str, help: &str, controller: &Controller) {
        to_stderr(|out| {
            writeln!(out, "{message}")?;
            let positions = controller.task_positions();
            positions.iter().take(MOST_TASKS).try_for_each(|position| self.position(position, out))?;
            if let Some(more @ 1..) = positions.len().checked_sub(MOST_TASKS) {
                writeln!(out, "  and {more} more tasks")?;
            }
            if positions.iter().any(|position| position.activity == Activity::Awaits("=".to_owned())) {
                unfinished_strings(controller).try_for_each(|line| writeln!(out, "  {}", one_line(&line)))?;
            }
            writeln!(out, "  help: {help}")
        });
    }

    /// Lists the recorded moves that were discarded at the end of the application.
    fn list_dropped_moves(&self, controller: &Controller) {
        let moves = controller.motion_queue();
        let sources: Vec<&CodeSource> = moves.iter().filter_map(|queued| queued.source.as_ref()).collect();
        let count = match sources.len() {
            0 => return,
            1 => "1 recorded move was".to_owned(),
            count => format!("{count} recorded moves were"),
        };
        to_stderr(|out| {
            writeln!(out, "note: {count} not executed to the end, because the last task has ended")?;
            sources.iter().take(MOST_MOVES).try_for_each(|source| self.dropped_move(source, out))?;
            if let Some(more @ 1..) = sources.len().checked_sub(MOST_MOVES) {
                writeln!(out, "  and {more} more")?;
            }
            writeln!(out, "  help: {AWAIT}")
        });
    }

    /// Writes a recorded move with its line: `movel at main/work.pgx:7: movel(pPick,tGrip,mSlow)`.
    fn dropped_move(&self, source: &CodeSource, out: &mut dyn Write) -> io::Result<()> {
        let CodeSource { instruction, line, file, .. } = source;
        let path = self.paths.shown(file.as_str().into());
        let code = code(file, *line).map(|code| format!(": {code}")).unwrap_or_default();
        writeln!(out, "  {instruction} at {path}:{line}{}", one_line(&code))
    }

    /// Writes a task with its line: `task "work" at main/work.pgx:7 waits for a condition: wait(bGo)`.
    fn position(&self, position: &TaskPosition, out: &mut dyn Write) -> io::Result<()> {
        let TaskPosition { name, activity, line, file, .. } = position;
        let path = self.paths.shown(file.as_str().into());
        let code = code(file, *line).map(|code| format!(": {code}")).unwrap_or_default();
        writeln!(out, "  {}", one_line(&format!("task `{name}` {activity} at {path}:{line}{code}")))
    }
}

/// Returns a line of text for each serial line or socket whose received bytes are no complete string.
fn unfinished_strings(controller: &Controller) -> impl Iterator<Item = String> {
    controller.devices.lines.unfinished_strings().map(|(link, UnfinishedString { bytes, end })| {
        let plural = if bytes == 1 { "" } else { "s" };
        format!("`{link}` has received {bytes} byte{plural} without the end of a string, the byte {end}")
    })
}
