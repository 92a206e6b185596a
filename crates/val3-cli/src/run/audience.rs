//! Who follows a run: the record, and people.

use val3_machine::controller::Controller;
use val3_machine::event::Event;

use super::console::Console;
use super::live::{Live, Wish};
use super::record::Record;
use crate::args::{Color, RunArgs};
use crate::user_error::UserError;

/// Everybody who is told what happens.
pub(super) struct Audience {
    record: Record,
    console: Console,
    live: Option<Live>,
}

impl Audience {
    /// Those that the arguments name.
    pub(super) fn open(args: &RunArgs, color: Color) -> Result<Self, UserError> {
        let record = Record::open(args.events.as_deref())?;
        let console = Console::new(color, !record.takes_stdout())?;
        let live = args.interactive.then(Live::open).transpose()?;
        Ok(Self { record, console, live })
    }

    /// Tells what has happened.
    pub(super) fn tell(&mut self, events: &[Event]) -> Result<(), UserError> {
        events.iter().try_for_each(|event| {
            self.record.write(event)?;
            let Some(live) = &mut self.live else { return self.console.show(event) };
            self.console.follow(event);
            live.hear(event);
            Ok(())
        })
    }

    /// Lets those who follow the record see what has happened so far.
    pub(super) fn flush(&mut self) -> Result<(), UserError> {
        self.record.flush()
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
        let read = self.live.take().map(Live::close).unwrap_or_default();
        for line in &read {
            self.console.say(line)?;
        }
        self.record.flush()?;
        Ok(self.console)
    }
}
