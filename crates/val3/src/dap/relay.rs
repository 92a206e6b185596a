//! Relay for sessions that another process serves: a run with `--debug-port`, or the adapter process of a client on a
//! port.

use std::io::{self, BufReader, Read, Write};
use std::net::{Ipv4Addr, TcpStream};
use std::sync::mpsc::channel;
use std::thread;

use serde_json::{Map, Value};
use val3_dap::{
    Handshake, Incoming, MessageContent, MessageReader, MessageWriter, ProtocolMessage, SessionStart, StandardRequest,
};

use crate::output::to_stderr;

/// Configuration key of the port.
const PORT: &str = "port";

/// Connects to the run at the configuration's port.
///
/// # Errors
/// The reason why there is no such run.
pub(super) fn connect(configuration: &Map<String, Value>) -> Result<TcpStream, String> {
    let port = configuration.get(PORT).and_then(Value::as_u64).and_then(|port| u16::try_from(port).ok());
    let port = port.ok_or_else(|| format!("`{PORT}` is the port of a run that `val3 run --debug-port` has begun"))?;
    TcpStream::connect((Ipv4Addr::LOCALHOST, port))
        .map_err(|error| format!("no run listens on port {port} ({error}); `val3 run --debug-port {port}` begins one"))
}

/// Relays the messages of a session in both directions until one side ends it. `input` has the messages of the other
/// process, which reads `output`.
///
/// # Errors
/// The other process does not read the first messages of the session, or bytes from the client were no message, and the
/// next message could not be found.
pub(super) fn relay(
    handshake: Handshake,
    start: &SessionStart,
    input: impl Read,
    output: impl Write + Send + 'static,
) -> io::Result<()> {
    let (client, introduction) = handshake.into_parts();
    let (from_client, mut to_client) = client.split();
    let (mut from_server, mut to_server) = (MessageReader::new(BufReader::new(input)), MessageWriter::new(output));
    to_server.pass_on(&ProtocolMessage {
        seq: 0,
        content: MessageContent::request(&StandardRequest::Initialize(introduction))?,
    })?;
    to_server.pass_on(&start.message())?;
    let (broken, fault) = channel();
    thread::spawn(move || {
        for incoming in from_client {
            match incoming {
                Incoming::Message(message) if to_server.pass_on(&message).is_err() => return,
                Incoming::Message(_) => {}
                Incoming::Garbage(error) => to_stderr(|out| writeln!(out, "error: {error}")),
                Incoming::End(Some(error)) => {
                    // The receiver is dropped if the other process has ended the session.
                    _ = broken.send(io::Error::other(error.to_string()));
                    return;
                }
                Incoming::End(None) => return,
            }
        }
    });
    while let Ok(Some(message)) = from_server.read() {
        // The handshake has already responded to the client's first request.
        let is_known = matches!(message.content, MessageContent::Response { request_seq: 0, .. });
        // A disconnected client is no error.
        if !is_known && to_client.write(message.content).is_err() {
            break;
        }
    }
    fault.try_recv().map_or(Ok(()), Err)
}
