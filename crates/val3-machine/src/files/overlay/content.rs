//! Content of a file in memory. Copies share it, and appending to a copy is cheap.

use std::sync::Arc;

/// Size at which the end of a content becomes a piece, in bytes.
const PIECE: usize = 16 << 10;

/// The content of a file.
#[derive(Debug, Clone, Default)]
pub(in crate::files) struct FileContent {
    /// Complete pieces, which are never empty.
    pieces: Arc<Vec<Arc<Vec<u8>>>>,
    /// The rest.
    end: Arc<Vec<u8>>,
    bytes: u64,
}

/// Content with a read position.
#[derive(Debug, Clone)]
pub(in crate::files) struct ContentReader {
    content: FileContent,
    piece: usize,
    at: usize,
}

impl FileContent {
    pub(in crate::files) fn new(bytes: Vec<u8>) -> Self {
        let mut content = Self { bytes: bytes.len() as u64, end: Arc::new(bytes), ..Self::default() };
        content.cut();
        content
    }

    /// Size in bytes.
    pub(in crate::files) fn bytes(&self) -> u64 {
        self.bytes
    }

    /// Appends bytes.
    pub(super) fn append(&mut self, bytes: &[u8]) {
        Arc::make_mut(&mut self.end).extend_from_slice(bytes);
        self.bytes += bytes.len() as u64;
        self.cut();
    }

    fn cut(&mut self) {
        if self.end.len() >= PIECE {
            let piece = std::mem::take(&mut self.end);
            Arc::make_mut(&mut self.pieces).push(piece);
        }
    }

    /// The pieces from the beginning to the end.
    pub(super) fn pieces(&self) -> impl Iterator<Item = &[u8]> {
        self.pieces.iter().chain([&self.end]).map(|piece| piece.as_slice())
    }

    /// All bytes.
    pub(in crate::files) fn to_vec(&self) -> Vec<u8> {
        self.pieces().flatten().copied().collect()
    }

    /// Returns a reader from the beginning.
    pub(in crate::files) fn reader(&self) -> ContentReader {
        ContentReader { content: self.clone(), piece: 0, at: 0 }
    }
}

impl PartialEq for FileContent {
    fn eq(&self, other: &Self) -> bool {
        self.bytes == other.bytes && self.pieces().flatten().eq(other.pieces().flatten())
    }
}

impl Iterator for ContentReader {
    type Item = u8;

    fn next(&mut self) -> Option<u8> {
        let pieces = &self.content.pieces;
        let byte = pieces.get(self.piece).unwrap_or(&self.content.end).get(self.at).copied()?;
        self.at += 1;
        if pieces.get(self.piece).is_some_and(|piece| piece.len() == self.at) {
            (self.piece, self.at) = (self.piece + 1, 0);
        }
        Some(byte)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn copies_keep_what_they_had() {
        let mut content = FileContent::new(vec![1; 3 * PIECE]);
        let before = content.clone();
        for byte in 0..100 {
            content.append(&[byte; PIECE / 10]);
        }
        assert_eq!((before.bytes(), before.to_vec()), (3 * PIECE as u64, vec![1; 3 * PIECE]));
        assert!(content.pieces().all(|piece| piece.len() < 4 * PIECE));
        let whole = content.to_vec();
        assert_eq!((whole.len() as u64, whole.get(3 * PIECE)), (content.bytes(), Some(&0)));
        assert_eq!(content.reader().collect::<Vec<u8>>(), whole);
        assert_eq!(FileContent::new(whole), content);
        assert_eq!(FileContent::default().reader().next(), None);
    }
}
