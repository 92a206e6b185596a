//! The messages of a run for its viewers.

use std::collections::VecDeque;

use axum::body::Bytes;
use axum::extract::ws::Utf8Bytes;

/// A message for viewers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum StoredMessage {
    /// A JSON object.
    Text(Utf8Bytes),
    /// A JSON object that later messages need: it is kept when older messages are dropped.
    Lasting(Utf8Bytes),
    /// A batch of samples.
    Binary(Bytes),
}

impl StoredMessage {
    pub(crate) fn bytes(&self) -> usize {
        match self {
            Self::Text(text) | Self::Lasting(text) => text.len(),
            Self::Binary(bytes) => bytes.len(),
        }
    }
}

/// The message in the place of those that were dropped.
const GAP: &str = r#"{"kind":"gap"}"#;

/// The messages of a run, bounded in bytes. Viewers have a cursor in it.
#[derive(Debug, Default)]
pub(crate) struct MessageLog {
    messages: VecDeque<StoredMessage>,
    /// The lasting messages among those that were dropped.
    lasting: Vec<StoredMessage>,
    /// The number of the first message that is left.
    first: u64,
    bytes: usize,
    limit: usize,
}

impl MessageLog {
    /// An empty log that keeps this many bytes.
    pub(super) fn new(limit: usize) -> Self {
        Self { limit, ..Self::default() }
    }

    /// Adds a message, and removes the oldest ones if the log is full.
    pub(crate) fn append(&mut self, message: StoredMessage) {
        self.bytes += message.bytes();
        self.messages.push_back(message);
        while self.bytes > self.limit {
            let Some(removed) = self.messages.pop_front() else { return };
            self.bytes -= removed.bytes();
            self.first += 1;
            if let StoredMessage::Lasting(_) = removed {
                self.lasting.push(removed);
            }
        }
    }

    /// The bytes of all messages.
    #[cfg(test)]
    pub(super) const fn bytes(&self) -> usize {
        self.bytes
    }

    /// The number of the message after the last one.
    pub(super) fn end(&self) -> u64 {
        self.first + self.messages.len() as u64
    }

    /// At most `count` messages from a cursor on, and moves it. If some of them were dropped, the lasting ones and a `gap` come
    /// first.
    pub(super) fn messages_since(&self, cursor: &mut u64, count: usize) -> Vec<StoredMessage> {
        let mut messages = Vec::new();
        if *cursor < self.first {
            messages.extend(self.lasting.iter().cloned());
            messages.push(StoredMessage::Text(Utf8Bytes::from_static(GAP)));
            *cursor = self.first;
        }
        let skipped = usize::try_from(*cursor - self.first).unwrap_or(usize::MAX);
        let before = messages.len();
        messages.extend(self.messages.iter().skip(skipped).take(count).cloned());
        *cursor += (messages.len() - before) as u64;
        messages
    }
}
