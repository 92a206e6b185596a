//! Who follows a run: the record, and people.

use val3_lang::ports::Time;
use val3_machine::controller::{Controller, Outcome};
use val3_machine::event::{Event, seconds};

use super::End;
use super::console::Console;
use super::live::{Live, Wish};
use super::record::Record;
use super::replay::{Divergence, Recording};
use crate::args::{Color, RunArgs};
use crate::output::to_stderr;
use crate::user_error::UserError;

/// Everybody who is told what happens.
pub(super) struct Audience {
    record: Record,
    console: Console,
    live: Option<Live>,
    /// The run that this one repeats.
    recording: Option<Recording>,
}

impl Audience {
    /// Those that the arguments name.
    pub(super) fn open(args: &RunArgs, recording: Option<Recording>, color: Color) -> Result<Self, UserError> {
        let record = Record::open(args.events.as_deref())?;
        let console = Console::new(color, !record.takes_stdout())?;
        let live = args.interactive.then(Live::open).transpose()?;
        Ok(Self { record, console, live, recording })
    }

    /// Tells what has happened.
    pub(super) fn tell(&mut self, events: &[Event]) -> Result<(), UserError> {
        events.iter().try_for_each(|event| {
            self.record.write(event)?;
            report(self.recording.as_mut().and_then(|recording| recording.compare(event)));
            let Some(live) = &mut self.live else { return self.console.show(event) };
            self.console.follow(event);
            live.hear(event);
            Ok(())
        })
    }

    /// Tells the last events of a run. A recording that goes beyond `--until` is not compared any further.
    pub(super) fn tell_end(&mut self, end: End, events: &[Event]) -> Result<(), UserError> {
        if matches!(end, End::Controller(Outcome::Limit) | End::BrokenOff(_) | End::Unread) {
            let recording = self.recording.take();
            self.tell(events)?;
            self.recording = recording;
            return Ok(());
        }
        self.tell(events)?;
        report(self.recording.as_mut().and_then(Recording::finish));
        Ok(())
    }

    /// Lets those who follow the run see what has happened so far.
    pub(super) fn flush(&mut self, now: Time) -> Result<(), UserError> {
        if self.live.is_none() {
            self.console.show_failures(Some(seconds(now)));
        }
        self.record.flush()
    }

    /// The run that this one repeats.
    pub(super) fn recording(&self) -> Option<&Recording> {
        self.recording.as_ref()
    }

    /// The run differs from the one that it repeats.
    pub(super) fn has_diverged(&self) -> bool {
        self.recording.as_ref().is_some_and(Recording::has_diverged)
    }

    /// A task has ended in an error that no other task has handled.
    pub(super) fn has_unhandled_errors(&self) -> bool {
        self.console.has_unhandled_errors()
    }

    /// Those who read what the run writes have gone.
    pub(super) fn has_left(&self) -> bool {
        self.record.is_abandoned() || self.console.is_abandoned()
    }

    /// Lets the operator do something, if there is one.
    pub(super) fn attend(&mut self, controller: &mut Controller) -> Result<Wish, UserError> {
        self.live.as_mut().map_or(Ok(Wish::GoOn), |live| live.attend(controller))
    }

    /// Nothing happens any more. What was to be read on a page that is gone now stays readable.
    pub(super) fn close(mut self) -> Result<Console, UserError> {
        match self.live.take() {
            // The journal has the errors.
            Some(live) => live.close().iter().try_for_each(|line| self.console.say(line))?,
            None => self.console.show_failures(None),
        }
        self.record.flush()?;
        Ok(self.console)
    }
}

/// Shows the first difference to a recording.
fn report(divergence: Option<Divergence>) {
    if let Some(divergence) = divergence {
        to_stderr(|out| writeln!(out, "{}", UserError::from(divergence)));
    }
}
