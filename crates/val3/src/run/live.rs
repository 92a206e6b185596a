//! `--interactive`: shows the user page in a terminal, and maps the keyboard to the keys of the pendant.

mod journal;
mod keyboard;
mod view;

use std::io::{self, IsTerminal};
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use ratatui::DefaultTerminal;
use ratatui::crossterm::event::{self, Event as Input};
use val3_machine::controller::{Controller, OperatorAction};
use val3_machine::event::Event;

use crate::user_error::UserError;
use journal::Journal;
use keyboard::KeyCommand;
use view::View;

/// Minimum time between two redraws.
const REFRESH: Duration = Duration::from_millis(40);

/// A terminal that shows the pendant.
///
/// While it exists, the terminal is in raw mode and on its alternate screen. A drop or a panic restores it.
pub(super) struct Live {
    terminal: DefaultTerminal,
    journal: Journal,
    drawn: Option<Instant>,
    interrupted: bool,
}

/// Checks that a terminal is available for the page and the keys.
///
/// # Errors
/// The standard input or output is no terminal.
pub(super) fn check_terminal(events_to_stdout: bool) -> Result<(), UserError> {
    if events_to_stdout {
        return Err(UserError::new("the standard output cannot show both the events and the user page")
            .with_help("name a file for --events, or run without --interactive"));
    }
    if io::stdin().is_terminal() && io::stdout().is_terminal() {
        return Ok(());
    }
    Err(UserError::new("--interactive needs a terminal for the standard input and output")
        .with_help("run without it, and pass keys with --keys or --script"))
}

impl Live {
    /// Initialises the terminal.
    ///
    /// # Errors
    /// The terminal cannot be controlled.
    pub(super) fn open() -> Result<Self, UserError> {
        let terminal = ratatui::try_init().map_err(|error| {
            ratatui::restore();
            refused(&error)
        })?;
        Ok(Self { terminal, journal: Journal::default(), drawn: None, interrupted: false })
    }

    /// Records an event's text, if it is relevant for the user.
    pub(super) fn record_event(&mut self, event: &Event) {
        self.journal.record_event(event);
    }

    /// Sends pressed keys to the pendant, and redraws it.
    ///
    /// # Errors
    /// The terminal was closed.
    pub(super) fn attend(&mut self, controller: &mut Controller) -> Result<ControlFlow<()>, UserError> {
        let wish = self.listen(controller).map_err(|error| refused(&error))?;
        if self.drawn.is_none_or(|drawn| drawn.elapsed() >= REFRESH) {
            self.draw(controller).map_err(|error| refused(&error))?;
        }
        Ok(wish)
    }

    /// Restores the terminal and returns the lines of the journal.
    pub(super) fn close(mut self) -> Vec<String> {
        self.journal.take()
    }

    fn listen(&mut self, controller: &mut Controller) -> io::Result<ControlFlow<()>> {
        while event::poll(Duration::ZERO)? {
            match event::read()? {
                Input::Key(key) if self.apply_command(keyboard::command(key), controller).is_break() => {
                    return Ok(ControlFlow::Break(()));
                }
                Input::Resize(..) => self.drawn = None,
                _ => {}
            }
        }
        Ok(ControlFlow::Continue(()))
    }

    /// The first interrupt stops the application, so that its program `stop` runs; the second interrupt ends the run.
    fn apply_command(&mut self, command: Option<KeyCommand>, controller: &mut Controller) -> ControlFlow<()> {
        match command {
            Some(KeyCommand::Tap(code)) => controller.operate(OperatorAction::Tap(code)),
            Some(KeyCommand::NextPage) => controller.operate(OperatorAction::NextPage),
            Some(KeyCommand::PreviousPage) => controller.operate(OperatorAction::PreviousPage),
            Some(KeyCommand::Interrupt) if self.interrupted => return ControlFlow::Break(()),
            Some(KeyCommand::Interrupt) => {
                self.interrupted = true;
                controller.operate(OperatorAction::Stop);
            }
            None => return ControlFlow::Continue(()),
        }
        self.drawn = None;
        ControlFlow::Continue(())
    }

    fn draw(&mut self, controller: &Controller) -> io::Result<()> {
        let devices = &controller.devices;
        let (now, stopping) = (controller.now(), self.interrupted);
        let view = View {
            pendant: &devices.state.pendant,
            robot: &devices.state.robot,
            journal: &self.journal,
            now,
            stopping,
        };
        self.terminal.draw(|frame| view.draw(frame))?;
        self.drawn = Some(Instant::now());
        Ok(())
    }
}

impl Drop for Live {
    fn drop(&mut self) {
        ratatui::restore();
    }
}

fn refused(error: &io::Error) -> UserError {
    UserError::new(format!("cannot show the user page in the terminal: {error}")).with_help("run without --interactive")
}
