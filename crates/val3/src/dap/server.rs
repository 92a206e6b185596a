//! `val3 dap --port`: each client that has sent the secret gets its own adapter process.

use std::io;
use std::net::TcpStream;
use std::process::{Command, ExitCode, Stdio};
use std::thread;

use val3_dap::{Handshake, HandshakeResult, Secret, SessionStart};

use super::FOREVER;
use super::listener::{client, listen};
use super::relay::relay;
use crate::output::to_stderr;
use crate::secret::DebugSecret;
use crate::user_error::UserError;

/// Serves clients until the process ends.
///
/// # Errors
/// The port is not free, or the secret cannot be chosen.
pub(super) fn serve(port: u16) -> Result<ExitCode, UserError> {
    let secret = DebugSecret::choose()?;
    let listener = listen(port)?;
    let address = listener.local_addr().map_err(|error| UserError::new(format!("port {port}: {error}")))?;
    to_stderr(|out| writeln!(out, "note: debuggers can connect to {address} {secret}"));
    for stream in listener.incoming() {
        let secret = secret.secret.clone();
        thread::spawn(|| {
            if let Err(error) = stream.and_then(|stream| attend(stream, secret)) {
                to_stderr(|out| writeln!(out, "error: a session has failed: {error}"));
            }
        });
    }
    Ok(ExitCode::SUCCESS)
}

/// Connects a client with an adapter process until one of them ends the session.
fn attend(stream: TcpStream, secret: Secret) -> io::Result<()> {
    let mut handshake = Handshake::through_port(client(stream)?, secret);
    match start(&mut handshake) {
        Some(start) => serve_in_a_process(handshake, &start),
        None => handshake.fault().map_or(Ok(()), |error| Err(io::Error::other(error.to_string()))),
    }
}

/// Waits for the request that begins the session. `None` if the client disconnects before.
fn start(handshake: &mut Handshake) -> Option<SessionStart> {
    loop {
        match handshake.attend() {
            HandshakeResult::None => handshake.wait(FOREVER),
            HandshakeResult::Disconnected => return None,
            HandshakeResult::Launch(start) | HandshakeResult::Attach(start) => return Some(start),
        }
    }
}

/// Relays a session to a new adapter process, which ends with the session.
fn serve_in_a_process(handshake: Handshake, start: &SessionStart) -> io::Result<()> {
    let mut adapter =
        Command::new(std::env::current_exe()?).arg("dap").stdin(Stdio::piped()).stdout(Stdio::piped()).spawn()?;
    let relayed = match (adapter.stdin.take(), adapter.stdout.take()) {
        // When its input ends, the adapter exits and closes its output.
        (Some(to_adapter), Some(from_adapter)) => relay(handshake, start, from_adapter, to_adapter),
        _ => Ok(()),
    };
    adapter.wait()?;
    relayed
}
