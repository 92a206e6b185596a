//! Bytes on a serial line or socket in scripts and tests.
//!
//! ```toml
//! receive = { "Socket\\host" = "START\r" }                                  # a text, in UTF-8
//! receive = { "Socket\\host" = { hex = "CD AB 01" } }
//! receive = { "Socket\\host" = { bytes = [205, 171] } }
//! receive = { "Socket\\host" = { values = [0.1, -2], format = "4.0l" } }     # as `toBinary` encodes numbers
//! receive = { "Socket\\host" = [{ values = [56], format = "4l" }, "text"] }  # one after the other
//! ```

use std::fmt;

use serde::ser::SerializeMap as _;
use serde::{Deserialize, Serialize, Serializer};
use val3_lang::arguments::BINARY_FORMATS;
use val3_lang::values::binary::BinaryFormat;

/// Bytes that a line receives or sends.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(try_from = "Pieces")]
pub struct LineBytes(Vec<u8>);

/// Content of bytes in a file.
#[derive(Deserialize)]
#[serde(
    untagged,
    expecting = "write a text, { hex = \"CD AB\" }, { bytes = [205, 171] }, { values = [0.5], format = \"4.0l\" }, or a \
                 list of these, one after the other"
)]
enum Pieces {
    One(BytePiece),
    Several(Vec<BytePiece>),
}

#[derive(Deserialize)]
#[serde(untagged)]
enum BytePiece {
    Text(String),
    Hex(Hex),
    Bytes(Bytes),
    Values(ByteValues),
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Hex {
    hex: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Bytes {
    bytes: Vec<f64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ByteValues {
    values: Vec<f64>,
    format: String,
}

impl TryFrom<Pieces> for LineBytes {
    type Error = String;

    fn try_from(pieces: Pieces) -> Result<Self, String> {
        let pieces = match pieces {
            Pieces::One(piece) => vec![piece],
            Pieces::Several(pieces) => pieces,
        };
        let bytes: Result<Vec<Vec<u8>>, String> = pieces.into_iter().map(BytePiece::bytes).collect();
        Ok(Self(bytes?.concat()))
    }
}

impl BytePiece {
    fn bytes(self) -> Result<Vec<u8>, String> {
        match self {
            Self::Text(text) => Ok(text.into_bytes()),
            Self::Hex(Hex { hex }) => of_hex(&hex),
            Self::Bytes(Bytes { bytes }) => encoded(&bytes, "1"),
            Self::Values(ByteValues { values, format }) => encoded(&values, &format),
        }
    }
}

/// Parses pairs of hexadecimal digits, with blanks anywhere between them.
fn of_hex(text: &str) -> Result<Vec<u8>, String> {
    let digits: Vec<char> = text.chars().filter(|c| !c.is_whitespace()).collect();
    let bytes: Option<Vec<u8>> = digits.chunks(2).map(hex_byte).collect();
    bytes.ok_or_else(|| {
        format!("{text:?} is no sequence of bytes: write two hexadecimal digits for each, as in \"CD AB\"")
    })
}

fn hex_byte(pair: &[char]) -> Option<u8> {
    let [high, low] = pair else { return None };
    u8::try_from(16 * high.to_digit(16)? + low.to_digit(16)?).ok()
}

/// Numbers in a format of `toBinary`.
fn encoded(values: &[f64], name: &str) -> Result<Vec<u8>, String> {
    let known = || format!("`{name}` is no format of `toBinary`: write one of {}", BINARY_FORMATS.join(", "));
    let format = BinaryFormat::parse(name).map_err(|_| known())?;
    match values.iter().find(|value| !format.holds(**value)) {
        Some(value) if name == "1" => Err(format!("{value} is no byte: write a whole number from 0 to 255")),
        Some(value) => Err(format!("the format `{name}` does not hold {value}")),
        None => Ok(values.iter().flat_map(|value| format.encode(*value)).collect()),
    }
}

impl LineBytes {
    /// Bytes in order.
    pub(crate) fn as_slice(&self) -> &[u8] {
        &self.0
    }
}

impl From<&[u8]> for LineBytes {
    fn from(bytes: &[u8]) -> Self {
        Self(bytes.to_vec())
    }
}

impl From<&str> for LineBytes {
    fn from(text: &str) -> Self {
        Self(text.as_bytes().to_vec())
    }
}

impl LineBytes {
    /// Returns the bytes as a text, if they are readable.
    #[must_use]
    pub fn text(&self) -> Option<&str> {
        std::str::from_utf8(&self.0).ok().filter(|text| !text.contains(is_binary))
    }

    /// The bytes as hexadecimal digits.
    #[must_use]
    pub fn hex(&self) -> String {
        let digits: Vec<String> = self.0.iter().map(|byte| format!("{byte:02X}")).collect();
        digits.join(" ")
    }
}

/// A text, or `{ hex = "CD AB" }`.
impl Serialize for LineBytes {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if let Some(text) = self.text() {
            return serializer.serialize_str(text);
        }
        let mut table = serializer.serialize_map(Some(1))?;
        table.serialize_entry("hex", &self.hex())?;
        table.end()
    }
}

/// A text in quotes, or hexadecimal digits.
impl fmt::Display for LineBytes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.text() {
            Some(text) => write!(f, "{text:?}"),
            None => f.write_str(&self.hex()),
        }
    }
}

/// Whether the character is a control character that readable texts do not contain.
fn is_binary(c: char) -> bool {
    c.is_control() && !matches!(c, '\r' | '\n' | '\t' | '\u{2}' | '\u{3}' | '\u{4}' | '\u{6}' | '\u{15}' | '\u{1b}')
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};

    use super::*;

    fn parse(value: &str) -> Result<LineBytes, String> {
        #[derive(Deserialize)]
        struct BytesTable {
            b: LineBytes,
        }
        toml::from_str::<BytesTable>(&format!("b = {value}"))
            .map(|file| file.b)
            .map_err(|error| error.message().to_owned())
    }

    #[track_caller]
    fn check(value: &str, bytes: &[u8], shown: &str) {
        let parsed = parse(value).unwrap();
        assert_eq!((parsed.as_slice(), parsed.to_string().as_str()), (bytes, shown));
    }

    #[track_caller]
    fn check_error(value: &str, expected: Expect) {
        expected.assert_eq(&parse(value).unwrap_err());
    }

    #[test]
    fn bytes_are_texts_digits_or_numbers() {
        check(r#""é\r""#, b"\xc3\xa9\r", r#""é\r""#);
        check(r#"{ hex = "cd AB 0 1" }"#, &[0xcd, 0xab, 1], "CD AB 01");
        check("{ bytes = [205, 0] }", &[205, 0], "CD 00");
        check(r#"{ values = [0.1], format = "4.0l" }"#, &0.1_f32.to_le_bytes(), "CD CC CC 3D");
        check(r#"{ values = [-2, 3], format = "-2b" }"#, &[0xff, 0xfe, 0, 3], "FF FE 00 03");
        check(r#"[{ values = [56], format = "4b" }, "ok"]"#, b"\0\0\x008ok", "00 00 00 38 6F 6B");
        check(r#""""#, &[], r#""""#);
    }

    #[test]
    fn faults_say_what_can_be_written() {
        let forms = expect![[
            r#"write a text, { hex = "CD AB" }, { bytes = [205, 171] }, { values = [0.5], format = "4.0l" }, or a list of these, one after the other"#
        ]];
        for value in ["5", "{ hexa = \"00\" }", "{ values = [1] }", "{ hex = \"00\", bytes = [1] }"] {
            forms.assert_eq(&parse(value).unwrap_err());
        }
        check_error(
            r#"{ hex = "ABC" }"#,
            expect![[r#""ABC" is no sequence of bytes: write two hexadecimal digits for each, as in "CD AB""#]],
        );
        check_error("{ bytes = [256] }", expect!["256 is no byte: write a whole number from 0 to 255"]);
        check_error("{ bytes = [1.5] }", expect!["1.5 is no byte: write a whole number from 0 to 255"]);
        check_error(r#"{ values = [70000], format = "2l" }"#, expect!["the format `2l` does not hold 70000"]);
        check_error(r#"{ values = [nan], format = "8.0b" }"#, expect!["the format `8.0b` does not hold NaN"]);
        check_error(
            r#"{ values = [1], format = "3l" }"#,
            expect![
                "`3l` is no format of `toBinary`: write one of -1, 1, -2l, -2b, 2l, 2b, -4l, -4b, 4l, 4b, 4.0l, 4.0b, 8.0l, 8.0b"
            ],
        );
    }
}
