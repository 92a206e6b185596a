//! `val3 dap --port`: each connection has an adapter process of its own.

use std::io;
use std::net::TcpStream;
use std::process::{Command, ExitCode, Stdio};
use std::thread;

use super::listener::{checked, listen, streams};
use crate::output::to_stderr;
use crate::user_error::UserError;

/// Serves clients until the process is ended.
///
/// # Errors
/// The port is not free.
pub(super) fn serve(port: u16) -> Result<ExitCode, UserError> {
    let listener = listen(port)?;
    let address = listener.local_addr().map_err(|error| UserError::new(format!("port {port}: {error}")))?;
    to_stderr(|out| writeln!(out, "note: debuggers can connect to {address}"));
    for stream in listener.incoming() {
        thread::spawn(|| {
            if let Err(error) = stream.and_then(attend) {
                to_stderr(|out| writeln!(out, "error: a session has failed: {error}"));
            }
        });
    }
    Ok(ExitCode::SUCCESS)
}

/// Connects a client with an adapter, until one of them has ended.
fn attend(stream: TcpStream) -> io::Result<()> {
    let (input, mut output) = streams(stream)?;
    let mut input = checked(input)?;
    let mut adapter =
        Command::new(std::env::current_exe()?).arg("dap").stdin(Stdio::piped()).stdout(Stdio::piped()).spawn()?;
    let (to_adapter, from_adapter) = (adapter.stdin.take(), adapter.stdout.take());
    if let (Some(mut to_adapter), Some(mut from_adapter)) = (to_adapter, from_adapter) {
        // The adapter ends with its input, and closes its output then. Its end closes the input.
        thread::spawn(move || io::copy(&mut input, &mut to_adapter));
        // A client that has left is no error.
        _ = io::copy(&mut from_adapter, &mut output);
    }
    drop(output);
    adapter.wait()?;
    Ok(())
}
