//! Transfers on data connections.

use std::io::{Read as _, Write as _};

use suppaftp::{FtpResult, Status, TransferStream};

use super::connection::{Connection, data_fault, fault};
use super::tls::TlsSocket;
use crate::access::AccessFault;

/// Limit of a listing in bytes.
const LISTING_LIMIT: u64 = 16 << 20;

/// Receives a file up to a limit.
pub(super) fn read(connection: &mut Connection, remote: &str, limit: u64) -> Result<Vec<u8>, AccessFault> {
    let opened = connection.client.retr_as_stream(remote);
    receive(connection.opened(opened)?, limit)
}

/// Receives the lines of a listing command.
pub(super) fn read_lines(connection: &mut Connection, command: &str) -> Result<Vec<String>, AccessFault> {
    let opened = connection.client.custom_data_command(command, &[Status::AboutToSend, Status::AlreadyOpen]);
    let bytes = receive(connection.opened(opened.map(|(_, stream)| stream))?, LISTING_LIMIT)?;
    let text = String::from_utf8_lossy(&bytes);
    Ok(text.lines().map(str::to_owned).filter(|line| !line.is_empty()).collect())
}

/// Sends a file.
pub(super) fn write(connection: &mut Connection, remote: &str, bytes: &[u8]) -> Result<(), AccessFault> {
    let opened = connection.client.put_with_stream(remote);
    let mut stream = connection.opened(opened)?;
    let written = stream.write_all(bytes).and_then(|()| stream.flush());
    // The reply contains the reason if the server has closed the transfer.
    stream.finish().map_err(fault)?;
    written.map_err(|error| data_fault(&error))
}

fn receive(mut stream: TransferStream<TlsSocket>, limit: u64) -> Result<Vec<u8>, AccessFault> {
    let mut bytes = Vec::new();
    let received = (&mut stream).take(limit.saturating_add(1)).read_to_end(&mut bytes);
    if bytes.len() as u64 > limit {
        // The reply to the interrupted transfer has no meaning. The caller connects again, because a second may follow.
        let _ = stream.finish();
        return Err(AccessFault::TooLarge(limit));
    }
    // A transfer that ends early has no reply of success, even if the connection was closed properly.
    stream.finish().map_err(fault)?;
    received.map_err(|error| data_fault(&error))?;
    Ok(bytes)
}

impl Connection {
    /// Returns the opened data connection, with the transfer timeout.
    fn opened(&self, stream: FtpResult<TransferStream<TlsSocket>>) -> Result<TransferStream<TlsSocket>, AccessFault> {
        let stream = stream.map_err(|error| self.opening_fault(error))?;
        self.limit(stream.get_ref().get_ref())?;
        Ok(stream)
    }
}
