//! Human-readable output of a run.

use std::io::{self, IsTerminal as _};

use codespan_reporting::term::termcolor::WriteColor;
use val3_lang::runtime_errors;
use val3_machine::controller::Controller;
use val3_machine::event::{Event, EventKind};
use val3_machine::missing_instruction;
use val3_machine::screen::{COLUMNS, PageContent, Pendant, display_columns, fitting};

use super::encounters::{Encounter, Encounters};
use super::failures::{Failure, Failures, ImpossiblePath};
use super::missing::MissingLibraries;
use crate::color::Color;
use crate::format::human;
use crate::output::{OutputContent, to_reader, to_stderr, to_stderr_in_color, to_stdout};
use crate::paths::{Paths, current_folder};
use crate::printable::one_line;
use crate::user_error::UserError;

/// Label of the line with a run-time error without a further reason.
const STOPPED: &str = "the task stopped here";

/// Help for a recorded path that the arm cannot follow.
const CORRECT_PATH: &str = "The arm stops before the path, and isEmpty() stays false. Correct the move; resetMotion \
                            clears the queue.";

/// Help for a line that the cell does not configure.
const CONNECT: &str = "If the device of the cell is not available here, connect the line with --line; see \
                       `val3 run --help`.";

/// The standard output and the standard error output of a run.
pub(crate) struct Console {
    pub(super) color: Color,
    /// Whether the standard output may be used for the output of the application.
    speaks: bool,
    /// Whether a debug client or the summary shows the output instead.
    pub(super) is_silent: bool,
    is_read: bool,
    /// Whether the application has written output.
    has_said: bool,
    pub(super) paths: Paths,
    failures: Failures,
    encounters: Encounters,
    missing: MissingLibraries,
}

impl Console {
    pub(crate) fn new(color: Color, speaks: bool) -> Result<Self, UserError> {
        let paths = Paths::new(&[], &current_folder()?);
        Ok(Self {
            color,
            speaks,
            is_silent: false,
            is_read: true,
            has_said: false,
            paths,
            failures: Failures::default(),
            encounters: Encounters::default(),
            missing: MissingLibraries::default(),
        })
    }

    /// Creates a console without output, for a run whose debug client shows the output.
    pub(crate) fn silent() -> Result<Self, UserError> {
        Ok(Self { is_silent: true, ..Self::new(Color::Never, false)? })
    }

    /// Whether a task has stopped with an unhandled error.
    pub(crate) fn has_unhandled_errors(&self) -> bool {
        !self.failures.is_empty()
    }

    /// Unhandled errors, and the path that the arm cannot follow.
    pub(super) fn failures(&self) -> &Failures {
        &self.failures
    }

    /// Contacts and near misses.
    pub(super) fn encounters(&self) -> &Encounters {
        &self.encounters
    }

    /// Whether there was a contact.
    pub(crate) fn has_contacts(&self) -> bool {
        self.encounters.has_contacts()
    }

    /// Shows an event, if it is relevant for the user.
    pub(crate) fn show(&mut self, event: &Event) -> Result<(), UserError> {
        self.follow(event);
        if self.is_silent {
            return Ok(());
        }
        match &event.kind {
            EventKind::Print { text } => self.say(text),
            EventKind::Log { text, .. } => self.say(&format!("log: {text}")),
            EventKind::Notice { text } => {
                to_stderr(|out| writeln!(out, "note: {}", one_line(text)));
                Ok(())
            }
            EventKind::Grip { .. } | EventKind::Release { .. } => {
                if let Some(problem) = event.kind.handling_problem() {
                    to_stderr(|out| writeln!(out, "note: {:.3} s: {problem}", event.t));
                }
                Ok(())
            }
            EventKind::Popup { text } => self.say(&format!("pop-up: {text}")),
            EventKind::Lacking { instruction, line, file, .. } => {
                self.lacking(event.task.as_deref().unwrap_or_default(), instruction, file, *line);
                Ok(())
            }
            _ => Ok(()),
        }
    }

    /// Tracks errors and missing libraries.
    pub(crate) fn follow(&mut self, event: &Event) {
        self.failures.follow(event);
        self.missing.follow(event);
        self.encounters.follow(event);
    }

    /// Adds the causes to errors of tasks that still exist.
    pub(super) fn find_causes(&mut self, controller: &mut Controller) {
        self.failures.find_causes(controller);
    }

    /// Shows the unhandled errors: the errors that are due at a time of the run, or all errors at its end.
    pub(crate) fn show_failures(&mut self, now: Option<f64>) {
        if !self.is_silent {
            self.failures.take_unhandled(now).iter().for_each(|failure| self.fault(failure));
            self.failures.take_path().iter().for_each(|path| self.impossible_path(path));
        }
    }

    /// Shows the contacts, and the nearest near miss.
    pub(crate) fn show_encounters(&self) {
        if self.is_silent {
            return;
        }
        self.encounters.contacts().iter().for_each(|contact| self.contact(contact));
        if let Some(near) = self.encounters.near_misses() {
            to_stderr(|out| writeln!(out, "note: {near}"));
        }
    }

    /// Writes a line to the standard output, if the output may be used.
    pub(crate) fn say(&mut self, text: &str) -> Result<(), UserError> {
        self.has_said = true;
        if self.speaks {
            self.is_read = to_reader(OutputContent::Data, self.color, |out| writeln!(out, "{text}"))?;
        }
        Ok(())
    }

    /// Whether the standard output is no longer read.
    pub(crate) fn is_abandoned(&self) -> bool {
        !self.is_read
    }

    /// Writes a run-time error with its line.
    fn fault(&self, Failure { task, code, file, line, reason, is_line_missing, .. }: &Failure) {
        let error = runtime_errors::find(*code);
        let message = format!("{} (task `{task}`)", error.map_or("unknown run-time error", |error| error.short));
        let long = error.map_or("", |error| error.long);
        let help = match *code {
            runtime_errors::UNLINKED if *is_line_missing => format!("{long} {CONNECT}"),
            runtime_errors::LIBRARY_ITEM_MISSING => format!("{}{long}", self.missing.notes_for_line(file, *line)),
            _ => long.to_owned(),
        };
        let path = self.paths.to_open(file.as_str().into());
        let label = reason.as_deref().unwrap_or(STOPPED);
        let fault = human::ProgramError { code: Some(*code), message, help: &help, label, path: &path, line: *line };
        to_stderr_in_color(self.color, |out| human::write_program_error(&fault, out));
    }

    /// Writes that the arm cannot follow a recorded path, with the move's line.
    fn impossible_path(&self, ImpossiblePath { instruction, file, line, reason, .. }: &ImpossiblePath) {
        let message = format!("the arm cannot follow the path of this `{instruction}`");
        let path = self.paths.to_open(file.as_str().into());
        let fault =
            human::ProgramError { code: None, message, help: CORRECT_PATH, label: reason, path: &path, line: *line };
        to_stderr_in_color(self.color, |out| human::write_program_error(&fault, out));
    }

    /// Writes a contact with the line of its move.
    fn contact(&self, contact: &Encounter) {
        let (message, help) = (contact.sentence(), contact.help());
        let Some(of) = &contact.of else {
            return to_stderr(|out| writeln!(out, "error: {message}\n  help: {help}"));
        };
        let path = self.paths.to_open(of.file.as_str().into());
        let label = "during the move of this line";
        let fault = human::ProgramError { code: None, message, help: &help, label, path: &path, line: of.line };
        to_stderr_in_color(self.color, |out| human::write_program_error(&fault, out));
    }

    /// Writes that the controller does not support an instruction, with its line.
    fn lacking(&self, task: &str, instruction: &str, file: &str, line: u32) {
        let message = format!("{} (task `{task}`)", missing_instruction(instruction));
        let help = "the run has ended here, because the rest of the program depends on the instruction";
        let path = self.paths.to_open(file.into());
        let fault = human::ProgramError { code: None, message, help, label: STOPPED, path: &path, line };
        to_stderr_in_color(self.color, |out| human::write_program_error(&fault, out));
    }

    /// Mentions the user page if it has text. At a terminal, it is shown completely if the application has no other
    /// output.
    pub(crate) fn mention_page(&self, pendant: &Pendant) -> Result<(), UserError> {
        let Some(page) = pendant.page(pendant.shown()) else { return Ok(()) };
        let has_text = !page.title().is_empty() || page.lines().any(|line| !line.trim().is_empty());
        if !has_text || self.is_silent {
            return Ok(());
        }
        if self.speaks && !self.has_said && io::stdout().is_terminal() {
            return self.page(pendant);
        }
        to_stderr(|out| writeln!(out, "note: the user page has text; --screen shows it"));
        Ok(())
    }

    /// Prints the user page that the pendant shows, with its title in the frame. If the standard output is in use, the
    /// page is printed to the standard error output.
    pub(crate) fn page(&self, pendant: &Pendant) -> Result<(), UserError> {
        let Some(page) = pendant.page(pendant.shown()) else { return Ok(()) };
        if self.speaks {
            return to_stdout(self.color, |out| write_page(page, out));
        }
        to_stderr_in_color(self.color, |out| write_page(page, out));
        Ok(())
    }
}

/// Writes the page in a frame with its title.
fn write_page(page: &PageContent, out: &mut dyn WriteColor) -> io::Result<()> {
    let title = one_line(page.title());
    let title = fitting(&title, COLUMNS);
    let after_title = COLUMNS.saturating_sub(display_columns(title));
    writeln!(out, "+{title}{:-<after_title$}+", "")?;
    for line in page.lines() {
        let padding = COLUMNS.saturating_sub(display_columns(&line));
        writeln!(out, "|{line}{:padding$}|", "")?;
    }
    writeln!(out, "+{:-<COLUMNS$}+", "")
}
