//! Log of the messages for viewers.
//!
//! A run is logged in parts, each with the complete state at its beginning. So a viewer that connects late begins with
//! the newest part, and the older parts follow in blocks, the latest first.

use std::collections::VecDeque;

use axum::body::Bytes;
use axum::extract::ws::Utf8Bytes;
use serde_json::json;
use val3_view::wire;

use super::block::PartBlock;

/// Message for viewers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum StoredMessage {
    /// A JSON object.
    Text(Utf8Bytes),
    /// A JSON object that messages of all later parts require.
    Lasting(Utf8Bytes),
    /// A batch of samples, or a block.
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

/// Part of a run.
#[derive(Debug, Default)]
struct LogPart {
    /// Time of the beginning, in s.
    start: f64,
    /// Complete state at the beginning; empty in the first part of a run.
    state: Vec<StoredMessage>,
    /// Number of the first message.
    first: u64,
    messages: Vec<StoredMessage>,
    /// Size of the state and the messages.
    bytes: usize,
}

impl LogPart {
    fn block(&self) -> PartBlock {
        PartBlock { start: self.start, state: self.state.clone(), messages: self.messages.clone() }
    }
}

/// Place in a log up to which a viewer has received messages.
#[derive(Debug, Clone, Copy)]
pub(super) struct LogCursor {
    /// Number of the run.
    run: u64,
    /// Number of the next message.
    next: u64,
    /// Number of the oldest part that the viewer has received, while older ones remain.
    oldest: Option<u64>,
}

/// Messages of the current run, bounded in bytes.
#[derive(Debug)]
pub(crate) struct MessageLog {
    /// Parts in their order; at least one.
    parts: VecDeque<LogPart>,
    /// Number of the first part. Parts are numbered over all runs.
    first_part: u64,
    /// Lasting messages of the current run.
    lasting: Vec<StoredMessage>,
    /// Number of the current run, and of its first message.
    run: u64,
    begun: u64,
    bytes: usize,
    limit: usize,
}

impl MessageLog {
    /// Creates an empty log with a maximum size in bytes.
    pub(super) fn new(limit: usize) -> Self {
        let parts = VecDeque::from([LogPart::default()]);
        Self { parts, first_part: 0, lasting: Vec::new(), run: 0, begun: 0, bytes: 0, limit }
    }

    /// Appends a message to the newest part.
    pub(crate) fn append(&mut self, message: StoredMessage) {
        if let StoredMessage::Lasting(_) = message {
            self.lasting.push(message.clone());
        }
        let Some(part) = self.parts.back_mut() else { return };
        part.bytes += message.bytes();
        self.bytes += message.bytes();
        part.messages.push(message);
        self.drop_oldest();
    }

    /// Begins a new part at a time in seconds with the complete state.
    pub(super) fn begin_part(&mut self, start: f64, state: Vec<StoredMessage>) {
        let bytes = state.iter().map(StoredMessage::bytes).sum();
        self.bytes += bytes;
        self.parts.push_back(LogPart { start, state, first: self.end(), messages: Vec::new(), bytes });
        self.drop_oldest();
    }

    /// Discards the messages of the previous run.
    pub(super) fn begin_run(&mut self) {
        self.begun = self.end();
        self.first_part += self.parts.len() as u64;
        self.parts = VecDeque::from([LogPart { first: self.begun, ..LogPart::default() }]);
        self.lasting.clear();
        self.run += 1;
        self.bytes = 0;
    }

    /// Drops the oldest parts of a log that is too large. The newest part remains.
    fn drop_oldest(&mut self) {
        while self.bytes > self.limit && self.parts.len() > 1 {
            let Some(dropped) = self.parts.pop_front() else { return };
            self.bytes -= dropped.bytes;
            self.first_part += 1;
        }
    }

    /// Size of all messages, in bytes.
    #[cfg(test)]
    pub(super) const fn bytes(&self) -> usize {
        self.bytes
    }

    /// Number of the next message.
    pub(super) fn end(&self) -> u64 {
        self.parts.back().map_or(0, |part| part.first + part.messages.len() as u64)
    }

    /// Number of the first message that was not dropped.
    fn first(&self) -> u64 {
        self.parts.front().map_or(0, |part| part.first)
    }

    /// Returns the messages after a cursor, at most `count`, and advances the cursor. A new viewer, and a viewer whose next
    /// message was dropped, receives the entrance instead: the newest part and everything that it requires.
    pub(super) fn messages_since(&self, cursor: &mut Option<LogCursor>, count: usize) -> Vec<StoredMessage> {
        let is_new = cursor.is_none();
        let place = match *cursor {
            Some(place) if place.run == self.run => place,
            _ => LogCursor { run: self.run, next: self.begun, oldest: None },
        };
        if self.has_past() && (is_new || place.next < self.first()) {
            let (place, messages) = self.entrance();
            *cursor = Some(place);
            return messages;
        }
        let messages = self.messages_from(place.next, count);
        *cursor = Some(LogCursor { next: place.next + messages.len() as u64, ..place });
        messages
    }

    /// Whether the newest part is not the first part of its run.
    fn has_past(&self) -> bool {
        self.parts.back().is_some_and(|part| !part.state.is_empty())
    }

    /// Returns the messages with which a late viewer begins: all lasting ones, the times of the past, and the newest part.
    fn entrance(&self) -> (LogCursor, Vec<StoredMessage>) {
        let mut messages = self.lasting.clone();
        let newest = self.first_part + self.parts.len() as u64 - 1;
        if let (Some(first), Some(last)) = (self.parts.front(), self.parts.back()) {
            messages.push(past(first.start, last.start));
            messages.push(last.block().encoded());
        }
        (LogCursor { run: self.run, next: self.end(), oldest: Some(newest) }, messages)
    }

    fn messages_from(&self, next: u64, count: usize) -> Vec<StoredMessage> {
        let part = self.parts.partition_point(|part| part.first <= next).saturating_sub(1);
        let skipped = self.parts.get(part).map_or(0, |part| usize::try_from(next - part.first).unwrap_or(usize::MAX));
        self.parts.iter().skip(part).flat_map(|part| &part.messages).skip(skipped).take(count).cloned().collect()
    }

    /// Returns the next older part for a late viewer, or, after the oldest one, the message that no part follows; `None`
    /// if the viewer has received that message, or needs none.
    pub(super) fn older(&self, cursor: &mut Option<LogCursor>) -> Option<OlderPart> {
        let place = cursor.as_mut().filter(|place| place.run == self.run)?;
        let oldest = place.oldest?;
        if let Some(part) = oldest.checked_sub(1).and_then(|number| self.part(number)) {
            place.oldest = Some(oldest - 1);
            return Some(OlderPart::Block(part.block()));
        }
        place.oldest = None;
        let start = self.part(oldest).or_else(|| self.parts.front()).map_or(0.0, |part| part.start);
        Some(OlderPart::End(past(start, start)))
    }

    fn part(&self, number: u64) -> Option<&LogPart> {
        self.parts.get(usize::try_from(number.checked_sub(self.first_part)?).ok()?)
    }
}

/// Message for a late viewer about an older part.
#[derive(Debug)]
pub(super) enum OlderPart {
    /// Messages of the part.
    Block(PartBlock),
    /// Message that no older part follows.
    End(StoredMessage),
}

/// Message about the times of the past.
fn past(from: f64, to: f64) -> StoredMessage {
    StoredMessage::Text(json!(wire::Message::Past(wire::Past { from, to })).to_string().into())
}

#[cfg(test)]
mod tests;
