//! Client of a session: received messages, and the connection to send messages.

use std::collections::VecDeque;
use std::fmt;
use std::io::{BufRead, Write};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, TryRecvError};
use std::time::Duration;

use serde_json::{Value, json};

use crate::error::ReadError;
use crate::failure::RequestFailure;
use crate::frame::{MessageReader, MessageWriter};
use crate::message::{MessageContent, ProtocolMessage};
use crate::protocol::{CancelArguments, Message, OutputEvent, OutputEventCategory, StandardEvent};

/// Message from the client, or the reason why none could be read.
#[derive(Debug)]
pub enum Incoming {
    /// A message.
    Message(ProtocolMessage),
    /// Bytes that are no message. Reading continues with the next message.
    Garbage(ReadError),
    /// The connection has ended. It contains the error after which no further message can be read.
    End(Option<ReadError>),
}

/// Reason why a client no longer expects the result of a request.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Interruption {
    /// The client has cancelled the request, or ended the run.
    Cancel,
    /// The client has requested `pause`.
    Pause,
}

/// Reads the messages of a client until its connection ends. The caller runs this on a separate thread.
pub fn read_messages(input: impl BufRead, inbox: &Sender<Incoming>) {
    let mut reader = MessageReader::new(input);
    loop {
        let incoming = match reader.read() {
            Ok(Some(message)) => Incoming::Message(message),
            Ok(None) => Incoming::End(None),
            Err(error) if error.can_continue() => Incoming::Garbage(error),
            // Nothing after a frame of unknown length can be read.
            Err(error) => Incoming::End(Some(error)),
        };
        let is_end = matches!(incoming, Incoming::End(_));
        if inbox.send(incoming).is_err() || is_end {
            return;
        }
    }
}

/// The connection to a client.
pub struct Client {
    inbox: Receiver<Incoming>,
    /// Received messages that are not handled yet.
    queue: VecDeque<Incoming>,
    output: MessageWriter<Box<dyn Write + Send>>,
    is_connected: bool,
    /// Error that has ended the connection.
    fault: Option<ReadError>,
}

impl Client {
    /// A client whose messages arrive in `inbox`, and that reads `output`.
    #[must_use]
    pub fn new(inbox: Receiver<Incoming>, output: Box<dyn Write + Send>) -> Self {
        Self { inbox, queue: VecDeque::new(), output: MessageWriter::new(output), is_connected: true, fault: None }
    }

    /// Whether the client can still receive messages.
    #[must_use]
    pub const fn is_connected(&self) -> bool {
        self.is_connected
    }

    /// Splits the client into its messages and the writer.
    pub fn split(self) -> (impl Iterator<Item = Incoming> + Send, MessageWriter<Box<dyn Write + Send>>) {
        (self.queue.into_iter().chain(self.inbox), self.output)
    }

    /// Returns the error that has ended the connection.
    #[must_use]
    pub const fn fault(&self) -> Option<&ReadError> {
        self.fault.as_ref()
    }

    /// Returns the next received message; `None` if there is none.
    pub(crate) fn poll(&mut self) -> Option<Incoming> {
        loop {
            match self.inbox.try_recv() {
                Ok(incoming) => self.queue.push_back(incoming),
                Err(TryRecvError::Empty) => return self.queue.pop_front(),
                Err(TryRecvError::Disconnected) if !self.is_connected => return self.queue.pop_front(),
                Err(TryRecvError::Disconnected) => return Some(self.queue.pop_front().unwrap_or(Incoming::End(None))),
            }
        }
    }

    /// Waits until a message has arrived, at most for this time. The message stays for [`poll`](Self::poll).
    pub fn wait(&mut self, time: Duration) {
        if !self.queue.is_empty() || !self.is_connected {
            return;
        }
        match self.inbox.recv_timeout(time) {
            Ok(incoming) => self.queue.push_back(incoming),
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => self.queue.push_back(Incoming::End(None)),
        }
    }

    /// Whether the client no longer expects the result of this request: see [`interruption`](Self::interruption).
    pub(crate) fn has_cancelled(&mut self, request: i64, progress: &str) -> bool {
        self.interruption(request, progress).is_some()
    }

    /// Returns the reason why the client no longer expects the result of this request: it has cancelled the request or
    /// the progress with this id, requested `pause`, or ended the run.
    ///
    /// Waiting requests that the client has cancelled are rejected now, so that they do not wait for this request.
    pub(crate) fn interruption(&mut self, request: i64, progress: &str) -> Option<Interruption> {
        self.queue.extend(self.inbox.try_iter());
        self.reject_cancelled();
        let cancels = |incoming: &Incoming| is_end(incoming) || is_cancel(incoming, request, progress);
        if self.queue.iter().any(cancels) {
            return Some(Interruption::Cancel);
        }
        self.queue.iter().any(is_pause).then_some(Interruption::Pause)
    }

    /// Rejects the waiting requests that the client has cancelled, and responds to these `cancel` requests.
    fn reject_cancelled(&mut self) {
        while let Some((waiting, cancel)) = self.cancelled_pair() {
            // The later message first, so that the position of the other one stays.
            let cancel = self.queue.remove(cancel).as_ref().and_then(request_of).map(|(seq, _)| seq);
            let waiting = self.queue.remove(waiting);
            if let Some((seq, command)) = waiting.as_ref().and_then(request_of) {
                self.refuse(seq, command, &RequestFailure::Cancelled);
            }
            if let Some(seq) = cancel {
                self.send(Ok(MessageContent::answer(seq, "cancel", None)));
            }
        }
    }

    /// Returns the positions of a waiting request and of the `cancel` after it that names only this request.
    fn cancelled_pair(&self) -> Option<(usize, usize)> {
        self.queue.iter().enumerate().find_map(|(cancel, incoming)| {
            let cancelled = cancelled_request(incoming)?;
            let waiting = self.queue.iter().take(cancel).position(|waiting| {
                request_of(waiting).is_some_and(|(seq, command)| seq == cancelled && command != "cancel")
            });
            Some((waiting?, cancel))
        })
    }

    /// Whether the client has cancelled a request before it is handled.
    pub(crate) fn withdraws(&mut self, request: i64) -> bool {
        self.queue.extend(self.inbox.try_iter());
        self.queue.iter().any(|incoming| is_cancel(incoming, request, ""))
    }

    /// Shows a text in the debug console as standard error output.
    pub(crate) fn say(&mut self, text: &str) {
        let (output, category) = (text.to_owned(), Some(OutputEventCategory::Stderr));
        self.event(&StandardEvent::Output(OutputEvent { output, category, ..OutputEvent::default() }));
    }

    /// Sends an event of the specification.
    pub(crate) fn event(&mut self, event: &StandardEvent) {
        self.send(MessageContent::event(event));
    }

    /// Sends an event `val3/…`.
    pub(crate) fn custom_event(&mut self, name: &str, body: Value) {
        self.send(Ok(MessageContent::Event { event: name.to_owned(), body: Some(body) }));
    }

    /// Sends the response to a failed request.
    pub(crate) fn refuse(&mut self, request: i64, command: &str, reason: impl fmt::Display) {
        let reason = reason.to_string();
        // The reason is passed as a variable of the format, so that braces in it are not read as placeholders.
        let variables = [("reason".to_owned(), reason.clone())].into_iter().collect();
        let message =
            Message { id: 3, format: "{reason}".to_owned(), variables: Some(variables), ..Message::default() };
        self.send(MessageContent::failure(request, command, &reason, message));
    }

    /// Sends a message. If that fails, the client counts as disconnected. A message without a JSON form is reported in
    /// the debug console.
    pub(crate) fn send(&mut self, content: serde_json::Result<MessageContent>) {
        let content = content.unwrap_or_else(|error| {
            let output = format!("the debug adapter cannot send a message: {error}\n");
            MessageContent::Event {
                event: "output".to_owned(),
                body: Some(json!({ "category": "stderr", "output": output })),
            }
        });
        if self.is_connected && self.output.write(content).is_err() {
            self.is_connected = false;
        }
    }

    /// Handles the end of the connection. An error that has ended it is shown in the debug console.
    pub(crate) fn disconnect(&mut self, fault: Option<ReadError>) {
        if let Some(error) = &fault {
            self.say(&format!("{error}\n"));
        }
        self.is_connected = false;
        self.fault = fault;
    }
}

/// Whether a message cancels the request, or the progress with this id.
fn is_cancel(incoming: &Incoming, request: i64, progress: &str) -> bool {
    let Incoming::Message(ProtocolMessage { content: MessageContent::Request { command, arguments }, .. }) = incoming
    else {
        return false;
    };
    let argument = |name: &str| arguments.as_ref().and_then(|arguments| arguments.get(name));
    command == "cancel"
        && (argument("requestId").and_then(Value::as_i64) == Some(request)
            || argument("progressId").and_then(Value::as_str) == Some(progress))
}

/// Returns the number and the command of a request.
fn request_of(incoming: &Incoming) -> Option<(i64, &str)> {
    match incoming {
        Incoming::Message(ProtocolMessage { seq, content: MessageContent::Request { command, .. } }) => {
            Some((*seq, command))
        }
        _ => None,
    }
}

/// Returns the number of the request that a `cancel` without a progress id names.
fn cancelled_request(incoming: &Incoming) -> Option<i64> {
    let Incoming::Message(ProtocolMessage { content: MessageContent::Request { command, arguments }, .. }) = incoming
    else {
        return None;
    };
    let arguments: CancelArguments = serde_json::from_value(arguments.clone()?).ok()?;
    let names_one = command == "cancel" && arguments.progress_id.is_none();
    arguments.request_id.filter(|_| names_one).map(i64::from)
}

impl fmt::Debug for Client {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Client").field("is_connected", &self.is_connected).finish_non_exhaustive()
    }
}

/// Whether a message is the request `pause`.
fn is_pause(incoming: &Incoming) -> bool {
    match incoming {
        Incoming::Message(ProtocolMessage { content: MessageContent::Request { command, .. }, .. }) => {
            command == "pause"
        }
        _ => false,
    }
}

/// Whether a message ends the run or the connection.
fn is_end(incoming: &Incoming) -> bool {
    match incoming {
        Incoming::End(_) => true,
        Incoming::Message(ProtocolMessage { content: MessageContent::Request { command, .. }, .. }) => {
            ["disconnect", "terminate", "restart"].contains(&command.as_str())
        }
        Incoming::Message(_) | Incoming::Garbage(_) => false,
    }
}

#[cfg(test)]
mod tests {
    use std::sync::mpsc::channel;

    use super::*;
    use crate::handshake::{Handshake, HandshakeResult};

    /// Returns the error that ends the connection of a client that sends these bytes.
    fn fault(bytes: &[u8]) -> Option<String> {
        let (sender, inbox) = channel();
        read_messages(bytes, &sender);
        let mut handshake = Handshake::new(Client::new(inbox, Box::new(std::io::sink())));
        assert!(matches!(handshake.attend(), HandshakeResult::Disconnected));
        handshake.fault().map(ToString::to_string)
    }

    #[test]
    fn unreadable_bytes_end_the_connection_with_an_error() {
        assert_eq!(fault(b""), None);
        assert_eq!(fault(b"Content-Length: 2\r\n\r\n{}"), None, "the next message can be read");
        let number = "the value of `Content-Length` is not a number: \"abc\"";
        assert_eq!(fault(b"Content-Length: abc\r\n\r\n"), Some(number.to_owned()));
        assert_eq!(fault(b"Content-Length: 9\r\n\r\n{}"), Some("the input ends inside a message".to_owned()));
    }
}
