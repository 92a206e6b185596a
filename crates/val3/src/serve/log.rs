//! Log of the messages for viewers.

use std::collections::VecDeque;

use axum::body::Bytes;
use axum::extract::ws::Utf8Bytes;
use serde_json::json;
use val3_view::wire;

/// Message for viewers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum StoredMessage {
    /// A JSON object.
    Text(Utf8Bytes),
    /// A JSON object that later messages require. It is kept when older messages are dropped.
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

/// Messages of the current run, bounded in bytes. Each viewer has a cursor in the log.
#[derive(Debug, Default)]
pub(crate) struct MessageLog {
    messages: VecDeque<StoredMessage>,
    /// Lasting messages from the dropped part of the log.
    lasting: Vec<StoredMessage>,
    /// Number of the first message that was not dropped.
    first: u64,
    /// Number of the first message of the current run.
    begun: u64,
    bytes: usize,
    limit: usize,
}

impl MessageLog {
    /// Creates an empty log with a maximum size in bytes.
    pub(super) fn new(limit: usize) -> Self {
        Self { limit, ..Self::default() }
    }

    /// Appends a message, and drops the oldest messages if the log is full.
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

    /// Discards the messages of the previous run.
    pub(super) fn begin_run(&mut self) {
        self.first = self.end();
        self.begun = self.first;
        self.messages.clear();
        self.lasting.clear();
        self.bytes = 0;
    }

    /// Size of all messages, in bytes.
    #[cfg(test)]
    pub(super) const fn bytes(&self) -> usize {
        self.bytes
    }

    /// Number of the next message.
    pub(super) fn end(&self) -> u64 {
        self.first + self.messages.len() as u64
    }

    /// Number of messages from a cursor on.
    pub(super) fn count_since(&self, cursor: u64) -> u64 {
        self.end().saturating_sub(cursor.max(self.first))
    }

    /// Returns at most `count` messages from a cursor on, and advances the cursor. If messages at the cursor were
    /// dropped, the lasting messages and a `gap` come first.
    pub(super) fn messages_since(&self, cursor: &mut u64, count: usize) -> Vec<StoredMessage> {
        let mut messages = Vec::new();
        *cursor = (*cursor).max(self.begun);
        if *cursor < self.first {
            messages.extend(self.lasting.iter().cloned());
            messages.push(StoredMessage::Text(json!(wire::Message::Gap).to_string().into()));
            *cursor = self.first;
        }
        let skipped = usize::try_from(*cursor - self.first).unwrap_or(usize::MAX);
        let before = messages.len();
        messages.extend(self.messages.iter().skip(skipped).take(count).cloned());
        *cursor += (messages.len() - before) as u64;
        messages
    }
}
