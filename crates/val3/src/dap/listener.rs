//! Connections of debuggers through a TCP port of this machine.

use std::io::{self, BufReader, Cursor, Read, Write};
use std::net::{Ipv4Addr, Shutdown, SocketAddr, TcpListener, TcpStream};
use std::sync::mpsc::{Sender, channel};
use std::thread;
use std::time::Duration;

use val3_dap::{Client, read_messages};

use crate::user_error::UserError;

/// The longest wait for a client that does not read.
const PATIENCE: Duration = Duration::from_secs(5);

/// The beginning of the first header of every client.
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

/// Passes clients that connect to a port on to a run. Returns the address.
///
/// # Errors
/// The port is not free.
pub(crate) fn receive(port: u16, entrance: Sender<Client>) -> Result<SocketAddr, UserError> {
    let listener = listen(port)?;
    let address = listener.local_addr().map_err(|error| UserError::new(format!("port {port}: {error}")))?;
    thread::spawn(move || {
        let clients = listener.incoming().filter_map(|stream| client(stream.ok()?).ok());
        for client in clients {
            if entrance.send(client).is_err() {
                return;
            }
        }
    });
    Ok(address)
}

/// A client with a thread that reads its messages.
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

/// The two directions of a connection. It ends with the second one.
pub(super) fn streams(stream: TcpStream) -> io::Result<(TcpStream, Connection)> {
    stream.set_nodelay(true)?;
    stream.set_write_timeout(Some(PATIENCE))?;
    Ok((stream.try_clone()?, Connection(stream)))
}

/// The input of a connection after a look at its first bytes: pages in browsers can send requests to ports of this machine,
/// and a debugger can do whatever a program can.
///
/// # Errors
/// It does not begin as a client does.
fn checked(mut input: TcpStream) -> io::Result<impl Read> {
    let mut start = [0; GREETING.len()];
    input.read_exact(&mut start)?;
    match start.eq_ignore_ascii_case(GREETING) {
        true => Ok(Cursor::new(start).chain(input)),
        false => Err(io::ErrorKind::InvalidData.into()),
    }
}

/// The output of a connection, which ends with it.
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
        // A connection that the other side has ended cannot be ended again.
        _ = self.0.shutdown(Shutdown::Both);
    }
}
