//! Decoding and encoding of files.
//!
//! Files of s6 to s8 are UTF-8, usually with a byte order mark. Files of s5 are ISO-8859-1 and declare it.

use crate::never::TextSlice;

/// Encoding of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Encoding {
    /// UTF-8. A byte order mark is the first character of the text.
    Utf8,
    /// ISO-8859-1: one byte for each character.
    Latin1,
}

/// Decoded text of a file, with its encoding.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Decoded {
    /// Decoded text.
    pub text: String,
    /// Encoding; [`Encoding::encode`] restores the same bytes.
    pub encoding: Encoding,
    /// Contradiction between the bytes and the declared encoding.
    pub mismatch: Option<Mismatch>,
}

/// Contradiction between the bytes and the declared encoding of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Mismatch {
    /// Neither valid UTF-8 nor declared as ISO-8859-1. The bytes were decoded as ISO-8859-1, where all bytes are valid.
    NotUtf8,
    /// Declared as ISO-8859-1, but non-ASCII characters are stored as UTF-8. The bytes were decoded as declared.
    NotLatin1,
}

/// Character that decoders insert for invalid bytes.
pub const REPLACEMENT: char = '\u{fffd}';

/// Decodes the bytes of a file. Every byte sequence can be decoded.
pub fn decode(bytes: Vec<u8>) -> Decoded {
    if declares_latin1(&bytes) {
        let is_utf8 = !bytes.is_ascii() && std::str::from_utf8(&bytes).is_ok();
        let mismatch = is_utf8.then_some(Mismatch::NotLatin1);
        return Decoded { text: latin1(&bytes), encoding: Encoding::Latin1, mismatch };
    }
    match String::from_utf8(bytes) {
        Ok(text) => Decoded { text, encoding: Encoding::Utf8, mismatch: None },
        Err(error) => {
            let text = latin1_after_mark(error.as_bytes());
            Decoded { text, encoding: Encoding::Latin1, mismatch: Some(Mismatch::NotUtf8) }
        }
    }
}

/// Whether the bytes start with a UTF-16 byte order mark, which no controller supports.
pub fn is_utf16(bytes: &[u8]) -> bool {
    bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff")
}

impl Encoding {
    /// Encodes `text`. A character that does not exist in ISO-8859-1 becomes a numeric reference.
    pub fn encode(self, text: &str) -> Vec<u8> {
        match self {
            Self::Utf8 => text.as_bytes().to_vec(),
            // Only a text with a UTF-8 mark and invalid UTF-8 bytes starts with a mark here.
            Self::Latin1 if let Some(text) = text.strip_prefix(MARK) => {
                [MARK.to_string().into_bytes(), self.encode(text)].concat()
            }
            Self::Latin1 => text.chars().fold(Vec::with_capacity(text.len()), |mut bytes, character| {
                match u8::try_from(u32::from(character)) {
                    Ok(byte) => bytes.push(byte),
                    Err(_) => bytes.extend(format!("&#{};", u32::from(character)).into_bytes()),
                }
                bytes
            }),
        }
    }
}

/// Byte order mark.
const MARK: char = '\u{feff}';

/// Like [`latin1`], but keeps a UTF-8 byte order mark, which shows the encoding before a byte was damaged.
fn latin1_after_mark(bytes: &[u8]) -> String {
    match bytes.strip_prefix(b"\xef\xbb\xbf") {
        Some(bytes) => MARK.to_string() + &latin1(bytes),
        None => latin1(bytes),
    }
}

fn latin1(bytes: &[u8]) -> String {
    bytes.iter().copied().map(char::from).collect()
}

/// Whether the XML declaration names ISO-8859-1 or its Windows superset.
fn declares_latin1(bytes: &[u8]) -> bool {
    let head = bytes.part(..bytes.len().min(200));
    if !head.starts_with(b"<?xml") {
        return false;
    }
    let declaration = head.split(|byte| *byte == b'>').next().unwrap_or(b"").to_ascii_lowercase();
    [&b"iso-8859-1"[..], b"latin1", b"windows-1252"]
        .iter()
        .any(|name| declaration.windows(name.len()).any(|window| window == *name))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn utf8_keeps_its_byte_order_mark() {
        let bytes = "\u{feff}<?xml version=\"1.0\"?>é".as_bytes().to_vec();
        let decoded = decode(bytes.clone());
        assert_eq!((decoded.encoding, decoded.mismatch), (Encoding::Utf8, None));
        assert_eq!(decoded.encoding.encode(&decoded.text), bytes);
    }

    #[test]
    fn declared_latin1_is_decoded() {
        let bytes = b"<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\xe9\xa6".to_vec();
        let decoded = decode(bytes.clone());
        assert_eq!((decoded.encoding, decoded.mismatch), (Encoding::Latin1, None));
        assert!(decoded.text.ends_with("é¦"));
        assert_eq!(decoded.encoding.encode(&decoded.text), bytes);
    }

    #[test]
    fn utf8_declared_as_latin1() {
        let bytes = "<?xml version=\"1.0\" encoding=\"iso-8859-1\"?>café".as_bytes().to_vec();
        let decoded = decode(bytes.clone());
        assert_eq!((decoded.encoding, decoded.mismatch), (Encoding::Latin1, Some(Mismatch::NotLatin1)));
        assert_eq!(decoded.encoding.encode(&decoded.text), bytes);
        let plain = b"<?xml version=\"1.0\" encoding=\"iso-8859-1\"?>cafe".to_vec();
        assert_eq!(decode(plain).mismatch, None);
    }

    #[test]
    fn undeclared_bytes_are_kept() {
        let bytes = b"<a b=\"\xff\xfe\"/>".to_vec();
        let decoded = decode(bytes.clone());
        assert_eq!(decoded.mismatch, Some(Mismatch::NotUtf8));
        assert_eq!(decoded.encoding.encode(&decoded.text), bytes);
    }

    #[test]
    fn a_byte_order_mark_survives_a_damaged_byte() {
        let bytes = b"\xef\xbb\xbf<a b=\"\xf6\"/>".to_vec();
        let decoded = decode(bytes.clone());
        assert_eq!(decoded.mismatch, Some(Mismatch::NotUtf8));
        assert_eq!(decoded.text, "\u{feff}<a b=\"\u{f6}\"/>");
        assert_eq!(decoded.encoding.encode(&decoded.text), bytes);
    }
}
