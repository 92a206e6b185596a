//! How the encoding of a file can be at fault.

/// A fault in the encoding of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum EncodingFault {
    /// It is neither in UTF-8 nor declares ISO-8859-1.
    NotUtf8,
    /// It declares ISO-8859-1 and is stored as UTF-8.
    NotLatin1,
    /// It is in ISO-8859-1, and an editor has read it in an encoding that does not have its characters.
    Misread,
    /// A character was replaced when the file was saved.
    Lost,
}
