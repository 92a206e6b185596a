//! Conversion of external bytes to strings of the language.

/// Maximum size of a string, in bytes (3.4.1).
pub(crate) const STRING: usize = 128;

/// String from the beginning of a byte sequence.
pub(crate) struct FilledString {
    /// At most [`STRING`] bytes.
    pub(crate) text: String,
    /// Number of consumed bytes.
    pub(crate) used: usize,
    /// Whether the string is full.
    pub(crate) full: bool,
}

/// Fills a string. Bytes that are no UTF-8 are skipped, and so is the zero that ends a string in memory. A character
/// that does not fit completely remains for the next string.
pub(crate) fn fill(bytes: &[u8]) -> FilledString {
    let mut filled = FilledString { text: String::new(), used: 0, full: false };
    for chunk in bytes.utf8_chunks() {
        for character in chunk.valid().chars() {
            if character != '\0' && filled.text.len() + character.len_utf8() > STRING {
                filled.full = true;
                return filled;
            }
            filled.used += character.len_utf8();
            filled.text.extend(Some(character).filter(|character| *character != '\0'));
            if filled.text.len() == STRING {
                filled.full = true;
                return filled;
            }
        }
        filled.used += chunk.invalid().len();
    }
    filled
}
