//! Observers of a run: the event record, the console and the terminal.

use std::ops::ControlFlow;

use val3_lang::ports::Time;
use val3_machine::controller::{Controller, RunStatus};
use val3_machine::event::{Event, EventKind, seconds};

use super::console::Console;
use super::end::End;
use super::live::Live;
use super::output_errors::OutputErrors;
use super::record::Record;
use super::recorded_options::RecordedOptions;
use super::replay::{Divergence, RunRecording};
use crate::args::RunArgs;
use crate::color::Color;
use crate::output::to_stderr;
use crate::user_error::UserError;

/// Observers that receive the events of a run.
pub(super) struct Observers {
    record: Record,
    console: Console,
    live: Option<Live>,
    /// Recording with which the run is compared.
    recording: Option<RunRecording>,
    /// First difference from the recording, for a client that shows it; `None` without a client.
    for_client: Option<Vec<UserError>>,
}

impl Observers {
    /// Opens the observers that the arguments name.
    pub(super) fn open(args: &RunArgs, recording: Option<RunRecording>, color: Color) -> Result<Self, UserError> {
        let record = Record::open(args.events.as_deref())?;
        let console = match args.summary {
            Some(_) => Console::silent()?,
            None => Console::new(color, !record.takes_stdout())?,
        };
        let live = args.interactive.then(Live::open).transpose()?;
        Ok(Self { record, console, live, recording, for_client: None })
    }

    /// Opens the observers of a run whose client shows the output.
    pub(super) fn silent(args: &RunArgs) -> Result<Self, UserError> {
        let recording = args.replay.as_deref().map(RunRecording::open).transpose()?;
        let record = Record::open(args.events.as_deref())?;
        Ok(Self { record, console: Console::silent()?, live: None, recording, for_client: Some(Vec::new()) })
    }

    /// Records the options of the run, before its events.
    pub(super) fn begin(&mut self, options: &RecordedOptions) -> Result<(), UserError> {
        self.record.begin(options)
    }

    /// Compares a run in which no task can continue with its recording.
    pub(super) fn compare_stuck(&mut self) {
        let divergence = self.recording.as_mut().and_then(RunRecording::compare_stuck);
        self.report(divergence);
    }

    /// Sends events to all observers.
    pub(super) fn notify(&mut self, events: &[Event]) -> Result<(), UserError> {
        events.iter().try_for_each(|event| {
            self.record.write(event)?;
            let divergence = self.recording.as_mut().and_then(|recording| recording.compare(event));
            self.report(divergence);
            let Some(live) = &mut self.live else { return self.console.show(event) };
            self.console.follow(event);
            live.record_event(event);
            Ok(())
        })
    }

    /// Adds the causes to the run-time errors in events.
    pub(super) fn find_causes(&mut self, events: &[Event], controller: &mut Controller) {
        if events.iter().any(|event| matches!(event.kind, EventKind::Error { .. })) {
            self.console.find_causes(controller);
        }
    }

    /// Sends the last events of a run. If the run ends at its limit or is aborted, a longer recording is not compared
    /// further.
    pub(super) fn notify_end(&mut self, end: End, events: &[Event]) -> Result<(), UserError> {
        if matches!(
            end,
            End::Controller(RunStatus::Limit) | End::BrokenOff(_) | End::Unread | End::Unwritten | End::Left
        ) {
            let recording = self.recording.take();
            self.notify(events)?;
            self.recording = recording;
            return Ok(());
        }
        self.notify(events)?;
        let divergence = self.recording.as_mut().and_then(RunRecording::finish);
        self.report(divergence);
        Ok(())
    }

    /// Shows the first difference from the recording, or keeps it for the client.
    fn report(&mut self, divergence: Option<Divergence>) {
        let Some(error) = divergence.map(UserError::from) else { return };
        match &mut self.for_client {
            Some(errors) => errors.push(error),
            None => to_stderr(|out| writeln!(out, "{error}")),
        }
    }

    /// Removes and returns the difference from the recording that the client has not received.
    pub(super) fn take_difference(&mut self) -> Option<UserError> {
        self.for_client.as_mut()?.pop()
    }

    /// Ends the comparison with the recording, because a client debugs the run from now on.
    pub(super) fn end_comparison(&mut self) {
        if let Some(recording) = &mut self.recording {
            recording.end_comparison();
        }
    }

    /// Flushes the outputs, so that all events so far are visible.
    pub(super) fn flush(&mut self, now: Time) -> Result<(), UserError> {
        if self.live.is_none() {
            self.console.show_failures(Some(seconds(now)));
        }
        self.record.flush()
    }

    /// Whether the terminal shows the user page.
    pub(super) fn is_live(&self) -> bool {
        self.live.is_some()
    }

    /// Standard output and standard error output.
    pub(super) fn console(&self) -> &Console {
        &self.console
    }

    /// Recording with which the run is compared.
    pub(super) fn recording(&self) -> Option<&RunRecording> {
        self.recording.as_ref()
    }

    /// Whether the run differs from the recording.
    pub(super) fn has_diverged(&self) -> bool {
        self.recording.as_ref().is_some_and(RunRecording::has_diverged)
    }

    /// Whether a task has stopped with an unhandled error.
    pub(super) fn has_unhandled_errors(&self) -> bool {
        self.console.has_unhandled_errors()
    }

    /// Whether there was a contact.
    pub(super) fn has_contacts(&self) -> bool {
        self.console.has_contacts()
    }

    /// Whether the output of the run is closed.
    pub(super) fn has_left(&self) -> bool {
        self.record.is_abandoned() || self.console.is_abandoned()
    }

    /// Processes operator input, if there is an operator.
    pub(super) fn attend(&mut self, controller: &mut Controller) -> Result<ControlFlow<()>, UserError> {
        self.live.as_mut().map_or(Ok(ControlFlow::Continue(())), |live| live.attend(controller))
    }

    /// Closes the outputs. The journal of the user page, which disappears, is printed to remain readable.
    pub(super) fn close(mut self, errors: &mut OutputErrors) -> Console {
        match self.live.take() {
            // The journal contains the errors.
            Some(live) => {
                errors.collect(live.close().iter().try_for_each(|line| self.console.say(line)));
            }
            None => self.console.show_failures(None),
        }
        self.console.show_encounters();
        errors.collect(self.record.flush());
        self.console
    }
}
