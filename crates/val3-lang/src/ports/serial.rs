//! Serial lines and sockets (3.7). No function waits: a waiting instruction calls the function again in every turn of
//! its task.

use super::Time;
use crate::fault::Result;
use crate::values::Text;

/// Serial lines and sockets of the controller, identified by the number in a variable.
///
/// `waited` is the instruction's elapsed waiting time.
pub trait Serial {
    /// `text = line`: receives the next string.
    ///
    /// # Errors
    /// 123 without a link, 125 after the timeout.
    fn receive_text(&mut self, port: Option<u32>, waited: Time) -> Result<Reply<Text>>;

    /// `number = line`: receives the next byte.
    ///
    /// # Errors
    /// 123 without a link, 125 after the timeout.
    fn receive_byte(&mut self, port: Option<u32>, waited: Time) -> Result<Reply<u8>>;

    /// `sioGet`: receives at most `most` bytes; `None` after the timeout.
    ///
    /// # Errors
    /// 123 without a link.
    fn receive(&mut self, port: Option<u32>, most: usize, waited: Time) -> Result<Reply<Option<Vec<u8>>>>;

    /// Sends for `line = …` and `sioSet`; returns the number of bytes sent, or `None` after the timeout. `first` begins
    /// a new transfer. Otherwise the transfer that the task has begun continues.
    ///
    /// # Errors
    /// 123 without a link.
    fn send(
        &mut self,
        port: Option<u32>,
        what: Outgoing<'_>,
        first: bool,
        waited: Time,
    ) -> Result<Reply<Option<usize>>>;

    /// `clearBuffer`: returns the number of discarded bytes; `None` for a closed socket.
    ///
    /// # Errors
    /// 123 without a link.
    fn clear_line(&mut self, port: Option<u32>) -> Result<Option<usize>>;

    /// `sioCtrl`: sets a parameter and returns the result.
    ///
    /// # Errors
    /// 123 without a link.
    fn control_line(&mut self, port: Option<u32>, parameter: &str, value: LineValue) -> Result<i8>;
}

/// Result of a call to a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reply<T> {
    /// Completed, with this value.
    Done(T),
    /// Not completed. It will be completed at the latest after this time since the instruction's start.
    Wait(Option<Time>),
}

impl<T> Reply<T> {
    /// Converts the value.
    pub fn map<U>(self, change: impl FnOnce(T) -> U) -> Reply<U> {
        match self {
            Self::Done(value) => Reply::Done(change(value)),
            Self::Wait(time) => Reply::Wait(time),
        }
    }
}

/// Data to send.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Outgoing<'o> {
    /// Text, followed by the line's end of string.
    Text(&'o str),
    /// A byte for each number: the nearest integer modulo 256.
    Numbers(&'o [f64]),
}

/// Parameter value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LineValue {
    /// Bool.
    Bool(bool),
    /// Number.
    Num(f64),
    /// Text.
    Text(Text),
    /// Value that no parameter accepts.
    Other,
}
