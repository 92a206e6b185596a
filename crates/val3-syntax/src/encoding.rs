//! Bytes to text and back.
//!
//! s6 to s8 write UTF-8, nearly always with a byte order mark; s5 writes ISO-8859-1 and declares it.

use crate::never::Part;

/// The encoding of a file: the relation of its bytes to its text.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Encoding {
    /// UTF-8; a byte order mark is the first character of the text.
    Utf8,
    /// ISO-8859-1: one byte a character.
    Latin1,
}

/// The text of a file and how it was stored.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Decoded {
    /// The text.
    pub text: String,
    /// The encoding; [`Encoding::encode`] returns the same bytes.
    pub encoding: Encoding,
    /// How the bytes contradict the encoding that the file declares.
    pub mismatch: Option<Mismatch>,
}

/// How the bytes of a file contradict the encoding that it declares.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Mismatch {
    /// They are neither UTF-8 nor declared as ISO-8859-1: they were read as ISO-8859-1, which takes all bytes.
    NotUtf8,
    /// They are declared as ISO-8859-1, and characters beyond ASCII are stored as UTF-8. They were read as declared.
    NotLatin1,
}

/// The character that decoders insert for bytes that they cannot read.
pub const REPLACEMENT: char = '\u{fffd}';

/// Reads the bytes of a file. Every sequence of bytes gives a text.
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

/// The bytes start with a byte order mark of UTF-16, which no controller reads.
pub fn is_utf16(bytes: &[u8]) -> bool {
    bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff")
}

impl Encoding {
    /// The bytes to store for `text`. A character that ISO-8859-1 does not have becomes a numeric reference.
    pub fn encode(self, text: &str) -> Vec<u8> {
        match self {
            Self::Utf8 => text.as_bytes().to_vec(),
            // Only a text whose bytes are not as their mark says starts with one.
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

/// The byte order mark.
const MARK: char = '\u{feff}';

/// As [`latin1`], but a byte order mark of UTF-8 is kept: it shows the encoding of the bytes before one was damaged.
fn latin1_after_mark(bytes: &[u8]) -> String {
    match bytes.strip_prefix(b"\xef\xbb\xbf") {
        Some(bytes) => MARK.to_string() + &latin1(bytes),
        None => latin1(bytes),
    }
}

fn latin1(bytes: &[u8]) -> String {
    bytes.iter().copied().map(char::from).collect()
}

/// The XML declaration names ISO-8859-1 or its superset for Windows.
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
