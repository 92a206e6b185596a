//! Faults in the encoding of a file.

/// A fault in the encoding of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum EncodingFault {
    /// The file is neither UTF-8 nor declared as ISO-8859-1.
    NotUtf8,
    /// The file is declared as ISO-8859-1 but stored as UTF-8.
    NotLatin1,
    /// The file is ISO-8859-1, and an editor has read it in an encoding without its characters.
    Misread,
    /// A character was replaced when the file was saved.
    Lost,
}
