//! Contents that are no controller text: damaged files, and other kinds of files under the name of a text file.

use std::fmt;

use crate::encoding::is_utf16;

/// Number of consecutive NUL bytes that occur in no text encoding.
const NUL_RUN: usize = 4;

/// The first line of a Git LFS pointer.
const LFS_POINTER: &[u8] = b"version https://git-lfs.github.com/spec/";

/// Kind of content that is no controller text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ForeignContent {
    /// No bytes, or only blanks.
    Empty,
    /// UTF-16, with or without a byte order mark.
    Utf16,
    /// Consecutive NUL bytes, as in files on media that have lost power.
    NulBytes {
        /// Offset of the first NUL byte.
        start: usize,
    },
    /// A Git LFS pointer instead of the file's content.
    LfsPointer,
    /// A ZIP archive.
    Archive,
}

impl ForeignContent {
    /// Returns the foreign content in these bytes; `None` if they may be a text.
    pub fn of(bytes: &[u8]) -> Option<Self> {
        let content = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        if content.trim_ascii().is_empty() {
            return Some(Self::Empty);
        }
        if is_utf16(bytes) || content.starts_with(b"<\0") || content.starts_with(b"\0<") {
            return Some(Self::Utf16);
        }
        if content.starts_with(LFS_POINTER) {
            return Some(Self::LfsPointer);
        }
        if content.starts_with(b"PK\x03\x04") {
            return Some(Self::Archive);
        }
        let start = memchr::memmem::find(bytes, &[0; NUL_RUN])?;
        Some(Self::NulBytes { start })
    }
}

impl fmt::Display for ForeignContent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => f.write_str("it is empty; copy it again"),
            Self::Utf16 => f.write_str("its text is UTF-16; save it as UTF-8"),
            Self::NulBytes { start: 0 } => {
                f.write_str("it is filled with NUL bytes, as after an interrupted copy; copy it again")
            }
            Self::NulBytes { start } => {
                write!(f, "it has NUL bytes from byte {start} on, as after an interrupted copy; copy it again")
            }
            Self::LfsPointer => f.write_str("it is a Git LFS pointer and not the file; run `git lfs pull`"),
            Self::Archive => f.write_str("it is a ZIP archive; unpack it"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn foreign_contents_are_told_from_texts() {
        let of = |bytes: &[u8]| ForeignContent::of(bytes);
        assert_eq!(of(b""), Some(ForeignContent::Empty));
        assert_eq!(of(b"\xef\xbb\xbf \r\n"), Some(ForeignContent::Empty));
        assert_eq!(of(b"\xff\xfe<\0"), Some(ForeignContent::Utf16));
        assert_eq!(of(b"<\0?\0x\0"), Some(ForeignContent::Utf16));
        assert_eq!(of(&[0; 100]), Some(ForeignContent::NulBytes { start: 0 }));
        assert_eq!(of(b"<a>\0\0\0\0"), Some(ForeignContent::NulBytes { start: 3 }));
        assert_eq!(of(b"version https://git-lfs.github.com/spec/v1\n"), Some(ForeignContent::LfsPointer));
        assert_eq!(of(b"PK\x03\x04\0\0\0\0"), Some(ForeignContent::Archive));
        assert_eq!(of(b"<a>\0</a>"), None, "one NUL byte is reported at its place");
        assert_eq!(of(b"\xef\xbb\xbf<a/>"), None);
    }
}
