//! What a run shows to people.

use std::io;

use codespan_reporting::term::termcolor::WriteColor;
use val3_lang::runtime_errors;
use val3_machine::event::{Event, What};
use val3_machine::screen::{COLUMNS, Pendant, display_columns, fitting};

use crate::application::lacking;
use crate::args::Color;
use crate::format::human;
use crate::opening::current_folder;
use crate::output::{to_reader, to_stderr_in_color, to_stdout};
use crate::paths::Paths;
use crate::user_error::UserError;

/// What the line of a run-time error is.
const STOPPED: &str = "the task stopped here";

/// What people at a terminal can do about a line that no cell configures.
const CONNECT: &str = "A serial line or socket of a cell that is not at hand is connected by --line: \
                       `val3 run --help` tells how.";

/// The standard output and error output.
pub(crate) struct Console {
    color: Color,
    /// The standard output is free for what the application says.
    speaks: bool,
    is_read: bool,
    paths: Paths,
    /// Tasks that an error has stopped and that were not seen to go on or end by the doing of others.
    failed: Vec<String>,
}

impl Console {
    pub(crate) fn new(color: Color, speaks: bool) -> Result<Self, UserError> {
        let paths = Paths::new(&[], &current_folder()?);
        Ok(Self { color, speaks, is_read: true, paths, failed: Vec::new() })
    }

    /// A task has ended in an error that no other task has cared for.
    pub(crate) fn has_unhandled_errors(&self) -> bool {
        !self.failed.is_empty()
    }

    /// Shows what has happened, if people want to know.
    pub(crate) fn show(&mut self, event: &Event) -> Result<(), UserError> {
        self.follow(event);
        match &event.what {
            What::Print { text } => self.say(text),
            What::Log { text, .. } => self.say(&format!("log: {text}")),
            What::Popup { text } => self.say(&format!("pop-up: {text}")),
            What::Error { code, line, file, .. } => {
                self.fault(event.task.as_deref().unwrap_or_default(), *code, file, *line);
                Ok(())
            }
            What::Lacking { instruction, line, file, .. } => {
                self.lacking(event.task.as_deref().unwrap_or_default(), instruction, file, *line);
                Ok(())
            }
            _ => Ok(()),
        }
    }

    /// An error counts as handled when another task lets the failed one go on, or kills it.
    pub(crate) fn follow(&mut self, event: &Event) {
        let What::Task { state, name, .. } = &event.what else { return };
        match *state {
            "error" => self.failed.push(name.to_owned()),
            "resumed" | "killed" if event.task.is_some() => {
                // Libraries may have tasks of the same name.
                let handled = self.failed.iter().position(|failed| failed == name);
                handled.map(|at| self.failed.swap_remove(at));
            }
            _ => {}
        }
    }

    /// Writes a line to the standard output, if it is free.
    pub(crate) fn say(&mut self, text: &str) -> Result<(), UserError> {
        if self.speaks {
            self.is_read = to_reader(self.color, |out| writeln!(out, "{text}"))?;
        }
        Ok(())
    }

    /// Nobody reads the standard output any more.
    pub(crate) fn is_abandoned(&self) -> bool {
        !self.is_read
    }

    /// A run-time error with its line.
    fn fault(&self, task: &str, code: u16, file: &str, line: u32) {
        let error = runtime_errors::find(code);
        let message = format!("{} (task `{task}`)", error.map_or("unknown run-time error", |error| error.short));
        let long = error.map_or("", |error| error.long);
        let help = if code == runtime_errors::UNLINKED { format!("{long} {CONNECT}") } else { long.to_owned() };
        let path = self.paths.shown(file.into());
        let fault = human::Fault { code: Some(code), message, help: &help, label: STOPPED, path: &path, line };
        to_stderr_in_color(self.color, |out| human::write_fault(&fault, out));
    }

    /// An instruction that is not there, with its line.
    fn lacking(&self, task: &str, instruction: &str, file: &str, line: u32) {
        let message = format!("{} (task `{task}`)", lacking(instruction));
        let help = "the run has ended: what the program does from here on depends on it";
        let path = self.paths.shown(file.into());
        let fault = human::Fault { code: None, message, help, label: STOPPED, path: &path, line };
        to_stderr_in_color(self.color, |out| human::write_fault(&fault, out));
    }

    /// The user page that the pendant shows, with its title in the frame; on the standard error output where the
    /// standard output is taken.
    pub(crate) fn page(&self, pendant: &Pendant) -> Result<(), UserError> {
        let Some(page) = pendant.page(pendant.shown()) else { return Ok(()) };
        let width = COLUMNS;
        let padded = |line: String| format!("{line}{:1$}", "", width.saturating_sub(display_columns(&line)));
        let title = fitting(page.title(), width);
        let behind = width.saturating_sub(display_columns(title));
        let picture = |out: &mut dyn WriteColor| -> io::Result<()> {
            writeln!(out, "+{title}{:-<behind$}+", "")?;
            page.lines().try_for_each(|line| writeln!(out, "|{}|", padded(line)))?;
            writeln!(out, "+{:-<width$}+", "")
        };
        if self.speaks {
            return to_stdout(self.color, picture);
        }
        to_stderr_in_color(self.color, picture);
        Ok(())
    }
}
