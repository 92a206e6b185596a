//! Runs with a debug client.

use std::process::ExitCode;

use val3_dap::{AttachServer, DebugSession, NextAction, RunState, SessionSettings};

use super::course::Course;
use super::end::End;
use super::guide::ATTENTION;
use super::observers::Observers;
use super::opening::{OpenedApplication, ReadyApplication, Show, open};
use crate::args::RunArgs;
use crate::dap::end::ended;
use crate::dap::listener;
use crate::output::{text, to_stderr};
use crate::secret::DebugSecret;
use crate::signals::Signals;
use crate::sockets::AnnouncementReader;
use crate::test::open_test;
use crate::user_error::{EXIT_USAGE, UserError};

/// Number of `ATTENTION` intervals that an attached client has for disconnecting at the end of the run.
const FAREWELLS: usize = 10;

/// Settings of a launch configuration that are no options of `val3 run`.
#[derive(Debug, Clone)]
pub(crate) struct DebugSettings {
    /// Session settings.
    pub(crate) session: SessionSettings,
    /// Whether the run has no stops and no history (`noDebug`).
    pub(crate) is_plain_run: bool,
    /// Debugged test.
    pub(crate) test: Option<String>,
}

/// Opens the application, or the test that the settings name.
pub(crate) fn open_debugged(
    args: &RunArgs,
    settings: &DebugSettings,
    show: Show<'_>,
) -> Result<OpenedApplication, UserError> {
    match &settings.test {
        Some(test) => open_test(args, test).map(|ready| OpenedApplication::Ready(Box::new(ready))),
        None => open(args, AnnouncementReader::Debugger, show),
    }
}

/// Continuation after a run that the client has launched.
enum Next {
    /// The process exits with this code.
    Exit(u8),
    /// The client inspects the end of the run, which has this exit code.
    Over(u8),
    /// The client has requested a restart.
    Restart,
}

/// Runs an application until it has ended and the client has disconnected. Repeats this if the client requests a
/// restart.
///
/// # Errors
/// Signals cannot be caught, or bytes from the client were no message, and the next message could not be found.
pub(crate) fn debug(
    mut session: DebugSession,
    args: &RunArgs,
    settings: &DebugSettings,
    ready: ReadyApplication,
) -> Result<ExitCode, UserError> {
    let code = attend(&mut session, args, settings, ready)?;
    ended(ExitCode::from(code), session.fault())
}

/// Runs an application until the session has ended, and returns the exit code.
fn attend(
    session: &mut DebugSession,
    args: &RunArgs,
    settings: &DebugSettings,
    ready: ReadyApplication,
) -> Result<u8, UserError> {
    let signals = Signals::catch()?;
    let mut next = run(session, args, settings, ready, &signals);
    loop {
        let next_or_failed = next.unwrap_or_else(|error| {
            session.say(&format!("{error}\n"));
            Next::Over(EXIT_USAGE)
        });
        match next_or_failed {
            Next::Exit(code) => return Ok(code),
            Next::Over(code) => {
                session.end(code);
                if !wants_restart(session, &signals) {
                    return Ok(code);
                }
            }
            Next::Restart => {}
        }
        next = match reopen(session, args, settings) {
            Some(ready) => run(session, args, settings, ready, &signals),
            None => Ok(Next::Over(1)),
        };
    }
}

/// Waits after the end of a run until the client disconnects or requests a restart. Returns whether it requests a
/// restart.
fn wants_restart(session: &mut DebugSession, signals: &Signals) -> bool {
    loop {
        match session.attend_end() {
            NextAction::Restart => return true,
            NextAction::Wait if signals.exit_code().is_none() => session.wait(ATTENTION),
            _ => return false,
        }
    }
}

/// Opens the application again with its present files. An error is sent to the client.
fn reopen(session: &mut DebugSession, args: &RunArgs, settings: &DebugSettings) -> Option<ReadyApplication> {
    let (mut shown, has_colors) = (String::new(), session.shows_colors());
    let opened = open_debugged(args, settings, &mut |write| shown.push_str(&text(has_colors, write)));
    if !shown.is_empty() {
        session.say(&shown);
    }
    match opened {
        Ok(OpenedApplication::Ready(ready)) => Some(*ready),
        Ok(OpenedApplication::Faulty { .. }) => None,
        Err(error) => {
            session.say(&format!("{error}\n"));
            None
        }
    }
}

fn run(
    session: &mut DebugSession,
    args: &RunArgs,
    settings: &DebugSettings,
    ready: ReadyApplication,
    signals: &Signals,
) -> Result<Next, UserError> {
    let mut course = Course::open(args, ready, Observers::silent(args)?)?;
    if !settings.is_plain_run {
        settings.session.apply(&mut course.debugger);
    }
    session.begin(&mut course.target());
    let end = course.run(session, signals);
    let code = course.exit_code(end);
    course.close(end)?;
    Ok(match end {
        End::Restart => Next::Restart,
        End::Left => Next::Exit(0),
        End::BrokenOff(code) => {
            session.end(code);
            Next::Exit(code)
        }
        End::Controller(_) | End::Recorded(_) | End::Unread | End::Unwritten => Next::Over(code),
    })
}

/// Opens a port of this machine, through which clients can attach to the runs of an application.
///
/// # Errors
/// The port is in use, or the chosen secret is too short.
pub(super) fn open_port(args: &RunArgs, port: u16) -> Result<AttachServer, UserError> {
    let waits = args.debug_wait;
    let secret = DebugSecret::choose()?;
    let state = if waits { RunState::Fresh } else { RunState::Running };
    let server = AttachServer::new(state, secret.secret.clone());
    let address = listener::receive(port, server.clients())?;
    let state = if waits { "the run waits for a debugger" } else { "a debugger can attach" };
    to_stderr(|out| writeln!(out, "note: {state} on {address} {secret}"));
    Ok(server)
}

/// Runs a course to which clients can attach.
pub(super) fn run_attended(course: &mut Course<'_>, server: &mut AttachServer, signals: &Signals) -> End {
    let end = course.run(server, signals);
    if let Some(session) = server.session() {
        session.end(course.exit_code(end));
        for _ in 0..FAREWELLS {
            if session.attend_end() != NextAction::Wait {
                break;
            }
            session.wait(ATTENTION);
        }
    }
    server.end_session();
    end
}
