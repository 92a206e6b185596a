//! A channel: what the instructions of 3.7.2 and 3.7.3 do with a line.
//!
//! An instruction that has to wait is asked again at each turn of its task, with the time it has waited so far. What
//! has come in stays in the channel until it is complete, so any number of tasks may wait at one channel.

mod input;

use val3_lang::arguments::SerialFault;

use super::setting::SettingFault;
use super::{ByteStream, Connection, LineKind, Received, SendResult, Setting, SettingRefusal, SettingValue};
use input::Input;

/// The answer to an instruction: a result, or the task waits and asks again.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Attempt<T> {
    /// Nothing yet.
    Wait,
    /// The instruction is done.
    Done(T),
}

/// Why reading or writing with `=` ends in a run-time error.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SioFault {
    /// The timeout has passed.
    TimedOut,
}

/// Bytes on their way out, and how many of them are gone.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Sending {
    bytes: Vec<u8>,
    sent: usize,
}

/// A line or socket with its parameters and what it has received.
pub struct Channel {
    line: Box<dyn ByteStream>,
    state: ChannelState,
}

/// The unread input of a channel, and its parameters.
#[derive(Debug, Clone)]
pub struct ChannelState {
    input: Input,
    /// The peer of what is in `input` has gone.
    ended: bool,
    /// A peer is connected or called.
    has_peer: bool,
    end_of_string: u8,
    timeout: f64,
}

/// The byte that goes out for a number: the nearest whole one modulo 256 (3.7.2).
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

    /// How many bytes there are in all.
    #[must_use]
    pub fn total(&self) -> usize {
        self.bytes.len()
    }

    /// The bytes that are gone.
    #[must_use]
    pub fn gone(&self) -> &[u8] {
        self.bytes.get(..self.sent).unwrap_or(&self.bytes)
    }

    fn rest(&self) -> &[u8] {
        self.bytes.get(self.sent..).unwrap_or(&[])
    }
}

impl Channel {
    /// A channel on `line`. Strings end with a carriage return and nothing limits a wait, until the configuration
    /// or a program says otherwise.
    #[must_use]
    pub fn new(line: Box<dyn ByteStream>) -> Self {
        let state =
            ChannelState { input: Input::default(), ended: false, has_peer: false, end_of_string: b'\r', timeout: 0.0 };
        Self { line, state }
    }

    /// A copy of its state.
    #[must_use]
    pub fn state(&self) -> ChannelState {
        self.state.clone()
    }

    /// Replaces its state. The line stays unchanged.
    pub fn restore(&mut self, state: ChannelState) {
        self.state = state;
    }

    /// The kind of the line.
    #[must_use]
    pub fn kind(&self) -> LineKind {
        self.line.kind()
    }

    /// Whether a peer is connected, so that its bytes arrive by the clock on the wall, or a server was called and may answer.
    /// A serial line has one, its device; a socket for datagrams has one since the first datagram.
    #[must_use]
    pub fn has_peer(&self) -> bool {
        self.state.has_peer
    }

    /// How long an instruction waits, in seconds: 0 without limit, negative not at all.
    #[must_use]
    pub fn timeout(&self) -> f64 {
        self.state.timeout
    }

    /// Looks after the line without reading: accepts and turns down callers, and takes in what has come.
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

    /// `sText = siInput`: a string, complete when its end has come or when it is as long as a string can be. The end
    /// is taken out and not given; what is no character of a string is passed over.
    ///
    /// The unfinished string of a peer that has gone is lost. A string that the limit has cut continues in the next
    /// one; one of exactly 128 bytes is followed by an empty one, as its end is still to be read.
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

    /// `nData = siInput`: one byte.
    pub fn read_byte(&mut self, waited: f64) -> Attempt<Result<u8, SioFault>> {
        self.attend();
        match self.state.input.take(1).first() {
            Some(byte) => Attempt::Done(Ok(*byte)),
            None => self.wait(waited),
        }
    }

    /// `sioGet`: at most `most` bytes of what is there, at least one from a socket; `None`, which the instruction
    /// gives as -1, after the timeout.
    ///
    /// A serial line does not wait (3.7.3 says so of sockets alone). With a negative timeout a socket does not either:
    /// nothing is received while it is connected, and -1 means that it is not.
    pub fn read_bytes(&mut self, most: usize, waited: f64) -> Attempt<Option<Vec<u8>>> {
        let connection = self.attend();
        let bytes = self.state.input.take(most);
        let at_once = self.kind() == LineKind::Serial || (self.state.timeout < 0.0 && connection == Connection::Open);
        if !bytes.is_empty() || at_once {
            return Attempt::Done(Some(bytes));
        }
        if self.is_over(waited) { Attempt::Done(None) } else { Attempt::Wait }
    }

    /// A text with the end of string, for `siOutput = sText`.
    #[must_use]
    pub fn text(&self, text: &str) -> Sending {
        let mut bytes = text.as_bytes().to_vec();
        bytes.push(self.state.end_of_string);
        Sending::bytes(bytes)
    }

    /// `siOutput = …` and `sioSet`: sends what is left. Gives how many bytes are gone in all, which are fewer than
    /// there were if the connection failed half way.
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

    /// `clearBuffer`: how many bytes were thrown away. A socket is closed as well; `None`, which the instruction
    /// gives as -1, if it was closed already.
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

    /// `sioCtrl`: sets a parameter and gives the instruction's result, 0 or negative.
    pub fn control(&mut self, name: &str, value: SettingValue<'_>) -> i8 {
        match Setting::read(name, value, self.kind()) {
            Ok(setting) => self.set(&setting).map_or_else(refused, |()| 0),
            Err(SettingFault::Argument(fault)) => fault.result(),
            Err(SettingFault::Kind) => OTHER_KIND,
        }
    }

    /// Sets a parameter, as the configuration of the controller does.
    ///
    /// # Errors
    /// If the line cannot, or not now.
    pub fn set(&mut self, setting: &Setting) -> Result<(), SettingRefusal> {
        match setting {
            Setting::EndOfString(byte) => self.state.end_of_string = *byte,
            Setting::Timeout(seconds) => self.state.timeout = *seconds,
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

    /// An instruction that has waited so long, in seconds, waits no more.
    fn is_over(&self, waited: f64) -> bool {
        self.state.timeout < 0.0 || (self.state.timeout > 0.0 && waited >= self.state.timeout)
    }
}

/// A peer that never stops sending is not listened to for ever.
const MOST_CLEARED: usize = 16 * input::CAPACITY;

/// -5: the parameter is of another kind of channel.
const OTHER_KIND: i8 = -5;

fn refused(refused: SettingRefusal) -> i8 {
    match refused {
        SettingRefusal::Value => SerialFault::Value.result(),
        SettingRefusal::Busy => -4,
    }
}

#[cfg(test)]
mod tests;
