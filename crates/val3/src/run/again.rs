//! Served run after its end: its server continues, and operators start the application again.

use val3_view::wire::StartAgain;

use super::course::Course;
use super::end::EndedRun;
use super::observers::Observers;
use super::opening::{OpenedApplication, open};
use super::replay::RunRecording;
use crate::args::{ControllerArgs, RunArgs};
use crate::color::Color;
use crate::output::{to_stderr, to_stderr_in_color};
use crate::serve::PendingCommand;
use crate::signals::Signals;
use crate::sockets::AnnouncementReader;
use crate::user_error::UserError;

/// Beginning of the notes about a new start.
const AGAIN: &str = "the application starts again";

/// Note about a new start at the initial position of the settings.
const INITIAL: &str = "the application starts again; the arm is at its initial position";

/// Application that starts again.
struct Restart<'a> {
    course: Course<'a>,
    /// Properties of its controller, with the position of the arm at the start.
    controller: ControllerArgs,
    /// Note for users.
    note: String,
}

impl EndedRun {
    /// Serves viewers until an operator starts the application again. `None` if a signal ends the server.
    pub(super) fn wait_for_start<'a>(
        mut self,
        args: &'a RunArgs,
        color: Color,
        signals: &Signals,
    ) -> Option<Course<'a>> {
        to_stderr(|out| {
            writeln!(out, "note: the run has ended; Run on the page starts it again, Ctrl-C ends the server")
        });
        loop {
            let (command, start) = self.next_start(signals)?;
            match Restart::open(args, color, self.kept_position(args, &start)) {
                Ok(Restart { mut course, controller, note }) => {
                    self.viewers.carry(&self.standby.controller, &mut course.debugger.controller);
                    to_stderr(|out| writeln!(out, "note: {note}"));
                    command.answer(Ok(serde_json::Map::new()));
                    self.viewers.begin(&course.debugger.controller, controller, note);
                    course.serve(self.viewers);
                    return Some(course);
                }
                Err(reason) => command.answer(Err(reason)),
            }
        }
    }

    /// Next command that starts the application. Until then, the operator may move the arm by hand. At a signal, `None`
    /// after unsaved points were written.
    fn next_start(&mut self, signals: &Signals) -> Option<(PendingCommand, StartAgain)> {
        while signals.exit_code().is_none() {
            self.viewers.wait(self.standby.wait_time());
            let start = self.viewers.attend_end(&mut self.standby);
            if start.is_some() {
                return start;
            }
            self.standby.advance(&mut self.viewers);
        }
        self.viewers.rescue(&mut self.standby.controller);
        None
    }

    /// Joint position at which the arm stays, as on a real controller; `None` for the initial position of the settings.
    /// A replay repeats its recording from its beginning.
    fn kept_position(&self, args: &RunArgs, start: &StartAgain) -> Option<Vec<f64>> {
        let arm = self.standby.controller.arm();
        let joints = arm.joint().into_iter().take(arm.model().axes()).collect();
        (!start.at_initial_position && args.replay.is_none()).then_some(joints)
    }
}

impl<'a> Restart<'a> {
    /// Opens the application with its present files. The arm starts at the kept position; without one, or if the settings
    /// no longer permit it, at the initial position. The error is the reason for the page; the terminal shows details.
    fn open(args: &'a RunArgs, color: Color, kept: Option<Vec<f64>>) -> Result<Self, String> {
        let Some(joints) = kept else { return Self::at_initial_position(args, color, INITIAL.to_owned()) };
        let at = shown_joints(&joints);
        let staying =
            RunArgs { controller: ControllerArgs { start: Some(joints), ..args.controller.clone() }, ..args.clone() };
        match reopen(&staying, color) {
            Err(error) => {
                let note = format!("{INITIAL}, because it cannot stay at {at}: {}", error.message());
                Self::at_initial_position(args, color, note)
            }
            Ok(opened) => Self::of(args, color, staying.controller, opened, format!("{AGAIN}; the arm stays at {at}")),
        }
    }

    fn at_initial_position(args: &'a RunArgs, color: Color, note: String) -> Result<Self, String> {
        let opened = reopen(args, color).map_err(|error| told(&error))?;
        Self::of(args, color, args.controller.clone(), opened, note)
    }

    fn of(
        args: &'a RunArgs,
        color: Color,
        controller: ControllerArgs,
        opened: OpenedApplication,
        note: String,
    ) -> Result<Self, String> {
        let ready = match opened {
            OpenedApplication::Ready(ready) => *ready,
            OpenedApplication::Faulty { errors, .. } => return Err(refusal(&errors)),
        };
        let course = observers(args, color).and_then(|observers| Course::open(args, ready, observers));
        Ok(Self { course: course.map_err(|error| told(&error))?, controller, note })
    }
}

/// Opens the application with its present files.
fn reopen(args: &RunArgs, color: Color) -> Result<OpenedApplication, UserError> {
    open(args, AnnouncementReader::Terminal, &mut |write| to_stderr_in_color(color, write))
}

fn observers(args: &RunArgs, color: Color) -> Result<Observers, UserError> {
    let recording = args.replay.as_deref().map(RunRecording::open).transpose()?;
    Observers::open(args, recording, color)
}

/// Formats a joint position for users, with at most three decimals.
fn shown_joints(joints: &[f64]) -> String {
    let shown: Vec<String> = joints.iter().map(|joint| ((joint * 1000.0).round() / 1000.0 + 0.0).to_string()).collect();
    format!("({})", shown.join(", "))
}

/// Writes an error to the terminal, and returns its text for the page.
fn told(error: &UserError) -> String {
    to_stderr(|out| writeln!(out, "{error}"));
    error.lines()
}

/// Reason why an application with errors does not start, in one sentence.
fn refusal(errors: &[String]) -> String {
    match errors {
        [] => "the application has errors, which the terminal shows".to_owned(),
        [error] => format!("the application does not start: {error}"),
        [error, rest @ ..] => format!("the application does not start: {error} (and {} more errors)", rest.len()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn joints_of_notes_are_rounded() {
        assert_eq!(shown_joints(&[10.0, -1e-9, 89.999_96, -30.123_46]), "(10, 0, 90, -30.123)");
    }

    #[test]
    fn a_refusal_names_the_first_error() {
        let errors = ["start.pgx:3: x".to_owned(), "stop.pgx:4: y".to_owned()];
        assert_eq!(refusal(&errors[..1]), "the application does not start: start.pgx:3: x");
        assert_eq!(refusal(&errors), "the application does not start: start.pgx:3: x (and 1 more errors)");
    }
}
