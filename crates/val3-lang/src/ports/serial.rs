//! Serial lines and sockets (3.7). Nothing here waits: an instruction that has to asks again in its next turn.

use super::Time;
use crate::fault::Result;
use crate::values::Text;

/// Serial lines and sockets of the controller, by the number that a variable holds.
///
/// `waited` is how long the instruction has waited already.
pub trait Serial {
    /// `text = line`: the next string.
    ///
    /// # Errors
    /// 123 without a link, 125 after the timeout.
    fn receive_text(&mut self, port: Option<u32>, waited: Time) -> Result<Reply<Text>>;

    /// `number = line`: the next byte.
    ///
    /// # Errors
    /// 123 without a link, 125 after the timeout.
    fn receive_byte(&mut self, port: Option<u32>, waited: Time) -> Result<Reply<u8>>;

    /// `sioGet`: at most `most` bytes; `None` after the timeout.
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

    /// `clearBuffer`: how many bytes were thrown away; `None` for a socket that is closed.
    ///
    /// # Errors
    /// 123 without a link.
    fn clear_line(&mut self, port: Option<u32>) -> Result<Option<usize>>;

    /// `sioCtrl`: its result.
    ///
    /// # Errors
    /// 123 without a link.
    fn control_line(&mut self, port: Option<u32>, parameter: &str, value: LineValue) -> Result<i8>;
}

/// The answer of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reply<T> {
    /// This.
    Done(T),
    /// Nothing yet; after this time from the start of the instruction, something in any case.
    Wait(Option<Time>),
}

impl<T> Reply<T> {
    /// The same answer with another value.
    pub fn map<U>(self, change: impl FnOnce(T) -> U) -> Reply<U> {
        match self {
            Self::Done(value) => Reply::Done(change(value)),
            Self::Wait(time) => Reply::Wait(time),
        }
    }
}

/// The data to send.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Outgoing<'o> {
    /// A text, followed by the end of string of the line.
    Text(&'o str),
    /// A byte for each number: the nearest whole one modulo 256.
    Numbers(&'o [f64]),
}

/// The value of a parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LineValue {
    /// A truth value.
    Bool(bool),
    /// A number.
    Num(f64),
    /// A text.
    Text(Text),
    /// A value that no parameter takes.
    Other,
}
