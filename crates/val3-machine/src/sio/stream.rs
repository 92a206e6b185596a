//! Non-blocking TCP connection.

use std::collections::VecDeque;
use std::io::{ErrorKind, Read, Write};
use std::net::{Shutdown, TcpStream};

use super::SendResult;

/// Maximum size of a connection's unread input, in bytes.
const CAPACITY: usize = 65_536;

/// Maximum number of bytes in one read from the system.
const CHUNK: usize = 8_192;

#[derive(Debug)]
pub(super) struct Stream {
    tcp: TcpStream,
    input: VecDeque<u8>,
    gone: bool,
}

impl Stream {
    /// Returns `None` if the connection has failed already.
    pub(super) fn new(tcp: TcpStream, nagle: bool) -> Option<Self> {
        tcp.set_nonblocking(true).ok()?;
        let mut stream = Self { tcp, input: VecDeque::new(), gone: false };
        stream.set_nagle(nagle);
        Some(stream)
    }

    /// Sets Nagle's algorithm. A connection that rejects the option has failed, which the next read reports.
    pub(super) fn set_nagle(&mut self, on: bool) {
        self.gone |= self.tcp.set_nodelay(!on).is_err();
    }

    /// Reads received bytes as long as there is room.
    pub(super) fn listen(&mut self) {
        let mut chunk = [0; CHUNK];
        while !self.gone && self.input.len() + CHUNK <= CAPACITY {
            match self.tcp.read(&mut chunk) {
                Ok(0) => self.gone = true,
                Ok(count) => self.input.extend(chunk.iter().take(count)),
                Err(error) if error.kind() == ErrorKind::WouldBlock => return,
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(_) => self.gone = true,
            }
        }
    }

    pub(super) fn has_input(&self) -> bool {
        !self.input.is_empty()
    }

    /// Whether the other end has closed or the connection has failed. Bytes received before can still be read.
    pub(super) fn is_gone(&self) -> bool {
        self.gone
    }

    pub(super) fn take(&mut self, most: usize) -> Vec<u8> {
        let count = most.min(self.input.len());
        self.input.drain(..count).collect()
    }

    pub(super) fn send(&mut self, bytes: &[u8]) -> SendResult {
        if self.gone {
            return SendResult::Lost;
        }
        match self.tcp.write(bytes) {
            Ok(count) => SendResult::Taken(count),
            Err(error) if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::Interrupted) => {
                SendResult::Taken(0)
            }
            Err(_) => {
                self.gone = true;
                SendResult::Lost
            }
        }
    }
}

impl Drop for Stream {
    /// Sent bytes still arrive. The task is no longer notified when the other end closes first.
    fn drop(&mut self) {
        drop(self.tcp.shutdown(Shutdown::Write));
    }
}
