//! Decoding and encoding of files.
//!
//! Files of s6 to s8 are UTF-8, usually with a byte order mark. Files of s5 are ISO-8859-1 and declare it. Editors of
//! Windows also write Windows-1252, which differs from ISO-8859-1 in the bytes 80 to 9F.

use crate::never::TextSlice;

/// Encoding of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Encoding {
    /// UTF-8. A byte order mark is the first character of the text.
    Utf8,
    /// ISO-8859-1: one byte for each character.
    Latin1,
    /// Windows-1252: one byte for each character. The five bytes without a character are the control characters of
    /// ISO-8859-1, so that every byte is preserved.
    Windows1252,
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
    /// Neither valid UTF-8 nor declared as another encoding. The bytes were decoded as ISO-8859-1, where all bytes are
    /// valid.
    NotUtf8,
    /// Declared as an encoding with one byte for each character, but non-ASCII characters are stored as UTF-8. The bytes
    /// were decoded as declared.
    StoredAsUtf8,
    /// Non-ASCII characters in an encoding that is not supported. The bytes were decoded as UTF-8 if they are valid, and
    /// as ISO-8859-1 otherwise.
    Unsupported,
}

/// Character that decoders insert for invalid bytes.
pub const REPLACEMENT: char = '\u{fffd}';

/// Decodes the bytes of a file. Every byte sequence can be decoded.
pub fn decode(bytes: Vec<u8>) -> Decoded {
    let declared = declared(&bytes);
    if let Some(Declared::Supported(encoding @ (Encoding::Latin1 | Encoding::Windows1252))) = declared {
        let is_utf8 = !bytes.is_ascii() && std::str::from_utf8(&bytes).is_ok();
        let mismatch = is_utf8.then_some(Mismatch::StoredAsUtf8);
        return Decoded { text: encoding.characters(&bytes), encoding, mismatch };
    }
    let unsupported = (declared == Some(Declared::Unsupported) && !bytes.is_ascii()).then_some(Mismatch::Unsupported);
    match String::from_utf8(bytes) {
        Ok(text) => Decoded { text, encoding: Encoding::Utf8, mismatch: unsupported },
        Err(error) => {
            let text = latin1_after_mark(error.as_bytes());
            Decoded { text, encoding: Encoding::Latin1, mismatch: unsupported.or(Some(Mismatch::NotUtf8)) }
        }
    }
}

/// Whether the bytes start with a UTF-16 byte order mark, which no controller supports.
pub fn is_utf16(bytes: &[u8]) -> bool {
    bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff")
}

impl Encoding {
    /// Returns the name of the encoding in messages.
    pub fn name(self) -> &'static str {
        match self {
            Self::Utf8 => "UTF-8",
            Self::Latin1 => "ISO-8859-1",
            Self::Windows1252 => "Windows-1252",
        }
    }

    /// Whether the encoding has the character.
    pub fn supports(self, character: char) -> bool {
        self == Self::Utf8 || self.byte(character).is_some()
    }

    /// Encodes `text`. A character that does not exist in the encoding becomes a numeric reference.
    pub fn encode(self, text: &str) -> Vec<u8> {
        match self {
            Self::Utf8 => text.as_bytes().to_vec(),
            // Only a text with a UTF-8 mark and invalid UTF-8 bytes starts with a mark here.
            Self::Latin1 if let Some(text) = text.strip_prefix(MARK) => {
                [MARK.to_string().into_bytes(), self.encode(text)].concat()
            }
            Self::Latin1 | Self::Windows1252 => {
                text.chars().fold(Vec::with_capacity(text.len()), |mut bytes, character| {
                    match self.byte(character) {
                        Some(byte) => bytes.push(byte),
                        None => bytes.extend(format!("&#{};", u32::from(character)).into_bytes()),
                    }
                    bytes
                })
            }
        }
    }

    /// Returns the byte of a character in an encoding with one byte for each character.
    fn byte(self, character: char) -> Option<u8> {
        if self == Self::Windows1252 {
            let special = (FIRST_SPECIAL..).zip(WINDOWS_1252).find(|(_, special)| *special == character);
            if let Some((byte, _)) = special {
                return Some(byte);
            }
        }
        u8::try_from(u32::from(character)).ok().filter(|byte| self.character(*byte) == character)
    }

    /// Returns the character of a byte in an encoding with one byte for each character.
    fn character(self, byte: u8) -> char {
        let special = byte.checked_sub(FIRST_SPECIAL).and_then(|index| WINDOWS_1252.get(usize::from(index)));
        match special {
            Some(special) if self == Self::Windows1252 => *special,
            _ => char::from(byte),
        }
    }

    fn characters(self, bytes: &[u8]) -> String {
        bytes.iter().map(|byte| self.character(*byte)).collect()
    }
}

/// First byte whose character differs between Windows-1252 and ISO-8859-1.
const FIRST_SPECIAL: u8 = 0x80;

/// Characters of Windows-1252 for the bytes 80 to 9F, as in the Encoding Standard of the WHATWG.
const WINDOWS_1252: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}', '\u{90}', '‘', '’',
    '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
];

/// Byte order mark.
const MARK: char = '\u{feff}';

/// Decodes ISO-8859-1, but keeps a UTF-8 byte order mark, which shows the encoding before a byte was damaged.
fn latin1_after_mark(bytes: &[u8]) -> String {
    match bytes.strip_prefix(b"\xef\xbb\xbf") {
        Some(bytes) => MARK.to_string() + &Encoding::Latin1.characters(bytes),
        None => Encoding::Latin1.characters(bytes),
    }
}

/// Encoding in an XML declaration.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Declared {
    Supported(Encoding),
    Unsupported,
}

/// Maximum length of an XML declaration, in bytes.
const DECLARATION_LIMIT: usize = 200;

/// Returns the encoding that the XML declaration names. A UTF-8 byte order mark before the declaration takes precedence.
fn declared(bytes: &[u8]) -> Option<Declared> {
    let head = bytes.part(..bytes.len().min(DECLARATION_LIMIT));
    let declaration = head.strip_prefix(b"<?xml")?.split(|byte| *byte == b'>').next()?.to_ascii_lowercase();
    let declaration = String::from_utf8_lossy(&declaration);
    let (_, value) = declaration.split_once("encoding")?;
    let value = value.trim_start().strip_prefix('=')?.trim_start();
    let quote = value.chars().next().filter(|quote| matches!(quote, '"' | '\''))?;
    let name = value.strip_prefix(quote)?.split(quote).next()?.trim();
    Some(match name {
        "utf-8" | "utf8" | "us-ascii" | "ascii" => Declared::Supported(Encoding::Utf8),
        "iso-8859-1" | "iso8859-1" | "iso_8859-1" | "latin1" | "latin-1" | "l1" => {
            Declared::Supported(Encoding::Latin1)
        }
        "windows-1252" | "cp1252" | "cp-1252" | "x-cp1252" => Declared::Supported(Encoding::Windows1252),
        _ => Declared::Unsupported,
    })
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
        assert_eq!((decoded.encoding, decoded.mismatch), (Encoding::Latin1, Some(Mismatch::StoredAsUtf8)));
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

    fn with_declaration(encoding: &str, rest: &[u8]) -> Vec<u8> {
        [format!("<?xml version=\"1.0\" {encoding}?>").as_bytes(), rest].concat()
    }

    #[test]
    fn declared_windows_1252_is_decoded() {
        for declaration in ["encoding=\"windows-1252\"", "encoding = 'CP1252'"] {
            let decoded = decode(with_declaration(declaration, b"\x80\x85\x93\xe9\x94"));
            assert_eq!((decoded.encoding, decoded.mismatch), (Encoding::Windows1252, None));
            assert!(decoded.text.ends_with("€…“é”"), "{}", decoded.text);
        }
    }

    #[test]
    fn every_byte_of_windows_1252_is_preserved() {
        let bytes = with_declaration("encoding=\"windows-1252\"", &(0..=255).collect::<Vec<u8>>());
        let decoded = decode(bytes.clone());
        assert_eq!(decoded.encoding.encode(&decoded.text), bytes);
        assert!(decoded.text.chars().all(|character| decoded.encoding.supports(character)));
    }

    #[test]
    fn characters_outside_the_encoding_become_references() {
        assert_eq!(Encoding::Latin1.encode("€é"), b"&#8364;\xe9");
        assert_eq!(Encoding::Windows1252.encode("€é日\u{80}"), b"\x80\xe9&#26085;&#128;");
        assert!(!Encoding::Latin1.supports('€') && !Encoding::Windows1252.supports('\u{80}'));
        assert!(Encoding::Utf8.supports('日'));
    }

    #[test]
    fn an_unsupported_encoding_is_a_mismatch_if_it_matters() {
        let mismatch = |encoding: &str, rest: &[u8]| {
            let bytes = with_declaration(encoding, rest);
            let decoded = decode(bytes.clone());
            assert_eq!(decoded.encoding.encode(&decoded.text), bytes);
            (decoded.encoding, decoded.mismatch)
        };
        assert_eq!(mismatch("encoding=\"gbk\"", b"\xe9"), (Encoding::Latin1, Some(Mismatch::Unsupported)));
        assert_eq!(mismatch("encoding=\"koi8-r\"", "é".as_bytes()), (Encoding::Utf8, Some(Mismatch::Unsupported)));
        assert_eq!(mismatch("encoding=\"gbk\"", b"cafe"), (Encoding::Utf8, None));
        assert_eq!(mismatch("encoding=\"us-ascii\"", "é".as_bytes()), (Encoding::Utf8, None));
        assert_eq!(mismatch("standalone='yes'", b"\xe9"), (Encoding::Latin1, Some(Mismatch::NotUtf8)));
    }
}
