//! Received unread bytes, with a fixed limit, so that a peer that floods the channel is held back on its own side.

use std::collections::VecDeque;

use crate::string_bytes::fill;

/// Maximum number of unread bytes: the maximum size of a datagram.
pub(super) const CAPACITY: usize = 65_536;

#[derive(Debug, Clone, Default)]
pub(super) struct Input {
    bytes: VecDeque<u8>,
}

impl Input {
    pub(super) fn is_empty(&self) -> bool {
        self.bytes.is_empty()
    }

    pub(super) fn len(&self) -> usize {
        self.bytes.len()
    }

    pub(super) fn contains(&self, byte: u8) -> bool {
        self.bytes.contains(&byte)
    }

    pub(super) fn room(&self) -> usize {
        CAPACITY.saturating_sub(self.bytes.len())
    }

    pub(super) fn extend(&mut self, bytes: &[u8]) {
        self.bytes.extend(bytes);
    }

    pub(super) fn clear(&mut self) {
        self.bytes.clear();
    }

    pub(super) fn take(&mut self, most: usize) -> Vec<u8> {
        let count = most.min(self.bytes.len());
        self.bytes.drain(..count).collect()
    }

    /// Removes and returns the first string if it is complete.
    pub(super) fn take_text(&mut self, end: u8) -> Option<String> {
        let bytes: &[u8] = self.bytes.make_contiguous();
        let at = bytes.iter().position(|byte| *byte == end);
        let (head, _) = bytes.split_at(at.unwrap_or(bytes.len()));
        let filled = fill(head);
        if !filled.full && at.is_none() {
            self.shrink(&filled.text);
            return None;
        }
        let used = if filled.full { filled.used } else { head.len() + 1 };
        self.bytes.drain(..used);
        Some(filled.text)
    }

    /// Removes bytes that are no part of a string if the buffer is full.
    fn shrink(&mut self, text: &str) {
        if self.room() == 0 {
            self.bytes = text.bytes().collect();
        }
    }
}
