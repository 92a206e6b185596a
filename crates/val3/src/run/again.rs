//! Served run after its end: its server continues, and operators start the application again.

use super::course::Course;
use super::end::EndedRun;
use super::observers::Observers;
use super::opening::{OpenedApplication, open};
use super::replay::RunRecording;
use crate::args::RunArgs;
use crate::color::Color;
use crate::output::{to_stderr, to_stderr_in_color};
use crate::serve::PendingCommand;
use crate::signals::Signals;
use crate::sockets::AnnouncementReader;
use crate::user_error::UserError;

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
            let command = self.next_start(signals)?;
            match reopen(args, color) {
                Ok(mut course) => {
                    self.viewers.carry(&self.standby.controller, &mut course.debugger.controller);
                    to_stderr(|out| writeln!(out, "note: the application starts again"));
                    command.answer(Ok(serde_json::Map::new()));
                    self.viewers.begin(&course.debugger.controller);
                    course.serve(self.viewers);
                    return Some(course);
                }
                Err(reason) => command.answer(Err(reason)),
            }
        }
    }

    /// Next command that starts the application. Until then, the operator may move the arm by hand. At a signal, `None`
    /// after unsaved points were written.
    fn next_start(&mut self, signals: &Signals) -> Option<PendingCommand> {
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
}

/// Opens the application with its present files. The error is the reason for the page; the terminal shows details.
fn reopen(args: &RunArgs, color: Color) -> Result<Course<'_>, String> {
    let opened = open(args, AnnouncementReader::Terminal, &mut |write| to_stderr_in_color(color, write));
    match opened {
        Ok(OpenedApplication::Ready(ready)) => observers(args, color)
            .and_then(|observers| Course::open(args, *ready, observers))
            .map_err(|error| told(&error)),
        Ok(OpenedApplication::Faulty { errors, .. }) => Err(refusal(&errors)),
        Err(error) => Err(told(&error)),
    }
}

fn observers(args: &RunArgs, color: Color) -> Result<Observers, UserError> {
    let recording = args.replay.as_deref().map(RunRecording::open).transpose()?;
    Observers::open(args, recording, color)
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
    fn a_refusal_names_the_first_error() {
        let errors = ["start.pgx:3: x".to_owned(), "stop.pgx:4: y".to_owned()];
        assert_eq!(refusal(&errors[..1]), "the application does not start: start.pgx:3: x");
        assert_eq!(refusal(&errors), "the application does not start: start.pgx:3: x (and 1 more errors)");
    }
}
