//! Part of a run as one binary message (docs/src/view.md).

use super::frames::{FrameKind, write_frame};
use super::log::StoredMessage;

/// First byte of a block, which identifies its kind.
const KIND: u8 = 2;

/// Part of a run that a late viewer receives at once.
#[derive(Debug)]
pub(super) struct PartBlock {
    /// Time of the beginning, in s.
    pub(super) start: f64,
    /// Complete state at the beginning; empty in the first part of a run.
    pub(super) state: Vec<StoredMessage>,
    /// Messages of the part. Lasting ones are not part of the block, because the viewer has received them before.
    pub(super) messages: Vec<StoredMessage>,
}

impl PartBlock {
    /// Encodes the block.
    pub(super) fn encoded(&self) -> StoredMessage {
        let mut bytes = vec![KIND, 0, 0, 0];
        bytes.extend(u32::try_from(self.state.len()).unwrap_or(u32::MAX).to_le_bytes());
        bytes.extend(self.start.to_le_bytes());
        for message in self.state.iter().chain(&self.messages) {
            let (kind, content) = match message {
                StoredMessage::Lasting(_) => continue,
                StoredMessage::Text(text) => (FrameKind::Object, text.as_bytes()),
                StoredMessage::Binary(samples) => (FrameKind::Samples, &samples[..]),
            };
            // Writing to memory does not fail, and no message has 4 GiB.
            let _ = write_frame(&mut bytes, kind, content);
        }
        StoredMessage::Binary(bytes.into())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_has_the_layout_of_the_protocol() {
        let state = vec![StoredMessage::Text("{}".into())];
        let messages =
            vec![StoredMessage::Lasting("{\"kind\":\"tool\"}".into()), StoredMessage::Binary(vec![1, 6].into())];
        let StoredMessage::Binary(bytes) = (PartBlock { start: 1.5, state, messages }).encoded() else { panic!() };
        let head = [&[2, 0, 0, 0, 1, 0, 0, 0][..], &1.5_f64.to_le_bytes()].concat();
        assert_eq!(bytes[..16], head);
        assert_eq!(bytes[16..], [0, 2, 0, 0, 0, b'{', b'}', 1, 2, 0, 0, 0, 1, 6]);
    }
}
