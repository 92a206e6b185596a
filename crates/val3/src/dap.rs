//! `val3 dap`: the debug adapter.

mod launch;
pub(crate) mod listener;
mod relay;
pub(crate) mod schema;
mod server;

use std::io::{self, BufReader};
use std::process::ExitCode;
use std::sync::mpsc;
use std::time::Duration;

use val3_dap::{Client, Handshake, HandshakeResult, ReadError, RunState, SessionStart, read_messages};

use self::listener::streams;
use self::relay::{connect, relay};
use crate::args::{DapArgs, RunArgs};
use crate::output::text;
use crate::run::{self, DebugSettings, OpenedApplication, ReadyApplication};
use crate::user_error::UserError;

/// Timeout for a client that may stay idle.
const FOREVER: Duration = Duration::from_secs(3600);

/// Runs the command.
///
/// # Errors
/// The port is not free, or signals cannot be caught.
pub(crate) fn run(args: &DapArgs) -> Result<ExitCode, UserError> {
    args.port.map_or_else(attend, server::serve)
}

/// Serves the client on the standard input and output.
fn attend() -> Result<ExitCode, UserError> {
    let (sender, inbox) = mpsc::channel();
    // The standard input can only be read by a blocking thread, which ends with the process.
    std::thread::spawn(move || read_messages(BufReader::new(io::stdin()), &sender));
    let mut handshake = Handshake::new(Client::new(inbox, Box::new(io::stdout())));
    loop {
        match handshake.attend() {
            HandshakeResult::None => handshake.wait(FOREVER),
            HandshakeResult::Disconnected => return ended(ExitCode::SUCCESS, handshake.fault()),
            HandshakeResult::Launch(start) => match open(&start, &mut handshake) {
                Ok((args, settings, ready)) => {
                    return run::debug(handshake.accept(&start, RunState::Fresh), &args, &settings, ready);
                }
                Err(reason) => handshake.refuse(&start, &reason),
            },
            HandshakeResult::Attach(start) => match connect(&start.arguments) {
                Ok(stream) => {
                    let relayed = streams(stream).and_then(|(input, output)| relay(handshake, &start, input, output));
                    relayed.map_err(|error| UserError::new(format!("the connection has failed: {error}")))?;
                    return Ok(ExitCode::SUCCESS);
                }
                Err(reason) => handshake.refuse(&start, &reason),
            },
        }
    }
}

/// Returns the exit code of a session that has ended.
///
/// # Errors
/// Bytes from the client were no message, and the next message could not be found.
pub(crate) fn ended(code: ExitCode, fault: Option<&ReadError>) -> Result<ExitCode, UserError> {
    match fault {
        None => Ok(code),
        Some(error) => {
            Err(UserError::new(format!("the session has ended, because the client sent no message: {error}")))
        }
    }
}

/// Opens the application in a launch configuration.
fn open(start: &SessionStart, handshake: &mut Handshake) -> Result<(RunArgs, DebugSettings, ReadyApplication), String> {
    let mut args = launch::arguments(&start.arguments)?;
    if start.settings.starts_at_end {
        launch::go_to_end(&mut args)?;
    }
    run::complete_by_recording(&mut args).map_err(|error| error.to_string())?;
    let test = launch::test(&start.arguments)?;
    let settings = DebugSettings { session: start.settings.clone(), is_plain_run: start.is_plain_run, test };
    let (mut shown, has_colors) = (String::new(), handshake.shows_colors());
    let opened = run::open_debugged(&args, &settings, &mut |write| shown.push_str(&text(has_colors, write)));
    if !shown.is_empty() {
        handshake.say(&shown);
    }
    match opened {
        Ok(OpenedApplication::Ready(ready)) => Ok((args, settings, *ready)),
        Ok(OpenedApplication::Faulty { .. }) => {
            Err("the application has errors, which the debug console shows".to_owned())
        }
        Err(error) => Err(error.to_string()),
    }
}
