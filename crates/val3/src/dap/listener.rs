//! Debugger connections through a TCP port of this machine.

use std::io::{self, BufReader, Cursor, Read, Write};
use std::net::{Ipv4Addr, Shutdown, SocketAddr, TcpListener, TcpStream};
use std::sync::mpsc::{Sender, channel};
use std::thread;
use std::time::Duration;

use val3_dap::{Client, read_messages};

use crate::user_error::UserError;

/// Write timeout for a client that does not read.
const TIMEOUT: Duration = Duration::from_secs(5);

/// First bytes of every client's first header, in lower case.
const GREETING: &[u8; 8] = b"content-";

/// Listens on a port that only this machine can reach.
///
/// # Errors
/// The port is not free.
pub(super) fn listen(port: u16) -> Result<TcpListener, UserError> {
    TcpListener::bind((Ipv4Addr::LOCALHOST, port)).map_err(|error| {
        UserError::new(format!("cannot listen on port {port}: {error}"))
            .with_help("choose another port, or 0 for a free one")
    })
}

/// Listens on a port and sends each connecting client to `server`. Returns the address.
///
/// # Errors
/// The port is not free.
pub(crate) fn receive(port: u16, server: Sender<Client>) -> Result<SocketAddr, UserError> {
    let listener = listen(port)?;
    let address = listener.local_addr().map_err(|error| UserError::new(format!("port {port}: {error}")))?;
    thread::spawn(move || {
        let clients = listener.incoming().filter_map(|stream| client(stream.ok()?).ok());
        for client in clients {
            if server.send(client).is_err() {
                return;
            }
        }
    });
    Ok(address)
}

/// Creates a client with a thread that reads its messages.
pub(super) fn client(stream: TcpStream) -> io::Result<Client> {
    let (sender, inbox) = channel();
    let (input, output) = streams(stream)?;
    thread::spawn(move || {
        if let Ok(input) = checked(input) {
            read_messages(BufReader::new(input), &sender);
        }
    });
    Ok(Client::new(inbox, Box::new(output)))
}

/// Both directions of a connection. Dropping the output closes the connection.
pub(super) fn streams(stream: TcpStream) -> io::Result<(TcpStream, Connection)> {
    stream.set_nodelay(true)?;
    stream.set_write_timeout(Some(TIMEOUT))?;
    Ok((stream.try_clone()?, Connection(stream)))
}

/// Returns the input of a connection after a check of its first bytes. Pages in browsers can send requests to ports of
/// this machine, and a debugger has the rights of a program.
///
/// # Errors
/// The input does not begin like a debugger client's.
fn checked(mut input: TcpStream) -> io::Result<impl Read> {
    let mut start = [0; GREETING.len()];
    input.read_exact(&mut start)?;
    match start.eq_ignore_ascii_case(GREETING) {
        true => Ok(Cursor::new(start).chain(input)),
        false => Err(io::ErrorKind::InvalidData.into()),
    }
}

/// Output of a connection; dropping it closes the connection.
pub(super) struct Connection(TcpStream);

impl Write for Connection {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}

impl Drop for Connection {
    fn drop(&mut self) {
        // Fails if the client has already closed the connection.
        _ = self.0.shutdown(Shutdown::Both);
    }
}
