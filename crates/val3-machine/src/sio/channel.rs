//! A serial line or socket as `sio` instructions use it (3.7.2, 3.7.3).
//!
//! A waiting instruction is called again in each turn of the task, with the elapsed waiting time. Received bytes stay
//! in the channel's buffer until the value is complete, so several tasks can wait on one channel.

mod input;

use val3_lang::arguments::SerialFault;

use super::setting::SettingFault;
use super::{ByteStream, Connection, LineKind, LineSetting, Received, SendResult, SettingRefusal, SettingValue};
use input::Input;

/// Result of a call by a waiting instruction.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Attempt<T> {
    /// Not complete: the task waits and calls again.
    Wait,
    /// Result of the completed instruction.
    Done(T),
}

/// Cause of the run-time error of reading or writing with `=`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SioFault {
    /// The timeout has passed.
    TimedOut,
}

/// Bytes to send, and the number of sent bytes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Sending {
    bytes: Vec<u8>,
    sent: usize,
}

/// Received bytes that do not contain the end of a string.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct UnfinishedString {
    /// Number of bytes.
    pub bytes: usize,
    /// Byte that ends a string of the channel.
    pub end: u8,
}

/// Line or socket with its parameters and received bytes.
pub struct Channel {
    line: Box<dyn ByteStream>,
    state: ChannelState,
}

/// The unread input of a channel, and its parameters.
#[derive(Debug, Clone)]
pub struct ChannelState {
    input: Input,
    /// Whether the peer that sent `input` has disconnected.
    ended: bool,
    /// Whether a peer is connected or called.
    has_peer: bool,
    end_of_string: u8,
    timeout: f64,
}

/// Converts a number to the byte to send: the nearest integer modulo 256 (3.7.2).
#[must_use]
pub fn byte_of(number: f64) -> u8 {
    let whole = (number + 0.5).floor().rem_euclid(256.0);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the remainder fits a byte")]
    let byte = whole as u8;
    byte
}

impl Sending {
    /// Sends bytes.
    #[must_use]
    pub fn bytes(bytes: Vec<u8>) -> Self {
        Self { bytes, sent: 0 }
    }

    /// Number of bytes to send, including the sent bytes.
    #[must_use]
    pub fn total(&self) -> usize {
        self.bytes.len()
    }

    /// Sent bytes.
    #[must_use]
    pub fn gone(&self) -> &[u8] {
        self.bytes.get(..self.sent).unwrap_or(&self.bytes)
    }

    fn rest(&self) -> &[u8] {
        self.bytes.get(self.sent..).unwrap_or(&[])
    }
}

impl Channel {
    /// Channel on `line`. By default, strings end with a carriage return and waiting has no limit.
    #[must_use]
    pub fn new(line: Box<dyn ByteStream>) -> Self {
        let state =
            ChannelState { input: Input::default(), ended: false, has_peer: false, end_of_string: b'\r', timeout: 0.0 };
        Self { line, state }
    }

    /// Returns a copy of the state.
    #[must_use]
    pub fn state(&self) -> ChannelState {
        self.state.clone()
    }

    /// Replaces the state. The line stays unchanged.
    pub fn restore(&mut self, state: ChannelState) {
        self.state = state;
    }

    /// The kind of the line.
    #[must_use]
    pub fn kind(&self) -> LineKind {
        self.line.kind()
    }

    /// Whether a peer is connected, or a called server may still accept the connection. Its bytes arrive in wall-clock
    /// time. The peer of a serial line is its device; a UDP socket has a peer from the first datagram.
    #[must_use]
    pub fn has_peer(&self) -> bool {
        self.state.has_peer
    }

    /// Timeout of instructions, in seconds: 0 waits without limit, a negative value does not wait.
    #[must_use]
    pub fn timeout(&self) -> f64 {
        self.state.timeout
    }

    /// The unread bytes, if there are any and no string among them is complete.
    #[must_use]
    pub fn unfinished_string(&self) -> Option<UnfinishedString> {
        let ChannelState { input, end_of_string: end, .. } = &self.state;
        let is_unfinished = !input.is_empty() && !input.contains(*end);
        is_unfinished.then(|| UnfinishedString { bytes: input.len(), end: *end })
    }

    /// Services the line between instructions: accepts and rejects callers, and buffers received bytes.
    pub fn attend(&mut self) -> Connection {
        if self.state.ended && self.state.input.is_empty() {
            self.state.ended = false;
        }
        let connection = self.line.open();
        if self.kind() != LineKind::Udp {
            self.state.has_peer = connection != Connection::Closed;
        }
        if self.state.ended || self.state.input.room() == 0 {
            return connection;
        }
        match self.line.receive(self.state.input.room(), self.state.input.is_empty()) {
            Received::Nothing => connection,
            Received::Bytes(bytes) => {
                self.state.input.extend(&bytes);
                self.state.has_peer = true;
                Connection::Open
            }
            Received::Ended => {
                self.state.ended = true;
                Connection::Closed
            }
        }
    }

    /// `sText = siInput`: reads a string, which is complete at its end or at the maximum length of a string. The end is
    /// removed; bytes that are no characters of a string are skipped.
    ///
    /// An unfinished string is discarded when its peer disconnects. A string that was cut at the maximum length
    /// continues in the next string. A string of exactly 128 bytes is followed by an empty string, because its end is
    /// still unread.
    pub fn read_text(&mut self, waited: f64) -> Attempt<Result<String, SioFault>> {
        if let Some(text) = self.next_text() {
            return Attempt::Done(Ok(text));
        }
        self.attend();
        match self.next_text() {
            Some(text) => Attempt::Done(Ok(text)),
            None => self.wait(waited),
        }
    }

    fn next_text(&mut self) -> Option<String> {
        let text = self.state.input.take_text(self.state.end_of_string);
        if text.is_none() && self.state.ended {
            self.state.input.clear();
        }
        text
    }

    /// `nData = siInput`: reads one byte.
    pub fn read_byte(&mut self, waited: f64) -> Attempt<Result<u8, SioFault>> {
        self.attend();
        match self.state.input.take(1).first() {
            Some(byte) => Attempt::Done(Ok(*byte)),
            None => self.wait(waited),
        }
    }

    /// `sioGet`: reads at most `most` available bytes, and from a socket at least one. `None` after the timeout: the
    /// instruction then returns -1.
    ///
    /// A serial line does not wait, because 3.7.3 describes the wait only for sockets. With a negative timeout a socket
    /// does not wait either: it returns no bytes while it is connected, and -1 means that it is not connected.
    pub fn read_bytes(&mut self, most: usize, waited: f64) -> Attempt<Option<Vec<u8>>> {
        let connection = self.attend();
        let bytes = self.state.input.take(most);
        let at_once = self.kind() == LineKind::Serial || (self.state.timeout < 0.0 && connection == Connection::Open);
        if !bytes.is_empty() || at_once {
            return Attempt::Done(Some(bytes));
        }
        if self.is_over(waited) { Attempt::Done(None) } else { Attempt::Wait }
    }

    /// Returns a string with its end, for `siOutput = sText`.
    #[must_use]
    pub fn text(&self, text: &str) -> Sending {
        let mut bytes = text.as_bytes().to_vec();
        bytes.push(self.state.end_of_string);
        Sending::bytes(bytes)
    }

    /// `siOutput = …` and `sioSet`: sends the remaining bytes. Returns the total number of sent bytes, which is below
    /// [`Sending::total`] if the connection failed half way.
    ///
    /// A connection that fails before any byte is sent is opened again, until the timeout.
    pub fn send(&mut self, sending: &mut Sending, waited: f64) -> Attempt<Result<usize, SioFault>> {
        let mut lost = self.attend() != Connection::Open;
        while !lost && sending.sent < sending.total() {
            match self.line.send(sending.rest()) {
                SendResult::Taken(0) => break,
                SendResult::Taken(count) => {
                    sending.sent += count;
                    self.state.has_peer = true;
                }
                SendResult::Lost => lost = true,
            }
        }
        let partly = sending.sent > 0 && (lost || self.state.timeout < 0.0);
        if sending.sent >= sending.total() || partly {
            return Attempt::Done(Ok(sending.sent));
        }
        self.wait(waited)
    }

    /// `clearBuffer`: discards the unread bytes and returns their number. A socket is closed as well; `None`, for which
    /// the instruction returns -1, if it was closed already.
    pub fn clear(&mut self) -> Option<usize> {
        let mut count = self.state.input.len();
        self.state.input.clear();
        while !self.state.ended && count < MOST_CLEARED {
            let Received::Bytes(bytes) = self.line.receive(input::CAPACITY, true) else { break };
            count += bytes.len();
        }
        (self.state.ended, self.state.has_peer) = (false, self.kind() == LineKind::Serial);
        let closed = self.line.kind() == LineKind::Serial || self.line.close();
        closed.then_some(count)
    }

    /// `sioCtrl`: sets a parameter and returns the instruction's result, 0 or negative.
    pub fn control(&mut self, name: &str, value: SettingValue<'_>) -> i8 {
        match LineSetting::read(name, value, self.kind()) {
            Ok(setting) => self.set(&setting).map_or_else(refused, |()| 0),
            Err(SettingFault::Argument(fault)) => fault.result(),
            Err(SettingFault::Kind) => OTHER_KIND,
        }
    }

    /// Sets a parameter.
    ///
    /// # Errors
    /// If the line does not support the value, or cannot change it while it is connected.
    pub fn set(&mut self, setting: &LineSetting) -> Result<(), SettingRefusal> {
        match setting {
            LineSetting::EndOfString(byte) => self.state.end_of_string = *byte,
            LineSetting::Timeout(seconds) => self.state.timeout = *seconds,
            _ => return self.line.apply(setting),
        }
        Ok(())
    }

    /// Closes the channel at the end of the application (3.7.1). Unread bytes are lost.
    pub fn shut_down(&mut self) {
        self.state.input.clear();
        (self.state.ended, self.state.has_peer) = (false, false);
        self.line.shut_down();
    }

    fn wait<T>(&self, waited: f64) -> Attempt<Result<T, SioFault>> {
        if self.is_over(waited) { Attempt::Done(Err(SioFault::TimedOut)) } else { Attempt::Wait }
    }

    /// Whether an instruction that has waited for `waited` seconds has timed out.
    fn is_over(&self, waited: f64) -> bool {
        self.state.timeout < 0.0 || (self.state.timeout > 0.0 && waited >= self.state.timeout)
    }
}

/// Byte limit of `clearBuffer`, because a peer may never stop sending.
const MOST_CLEARED: usize = 16 * input::CAPACITY;

/// -5: the parameter belongs to another kind of channel.
const OTHER_KIND: i8 = -5;

fn refused(refused: SettingRefusal) -> i8 {
    match refused {
        SettingRefusal::Value => SerialFault::Value.result(),
        SettingRefusal::Busy => -4,
    }
}

#[cfg(test)]
mod tests;
