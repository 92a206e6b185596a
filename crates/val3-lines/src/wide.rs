//! Multi-byte characters.

use crate::ColumnUnit;

/// A multi-byte character.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct WideCharacter {
    /// Offset.
    pub(crate) at: u32,
    /// Length in bytes.
    pub(crate) len: u32,
    /// Number of bytes minus number of characters in the text, up to the end of this character.
    over_characters: u32,
    /// Number of bytes minus number of UTF-16 units in the text, up to the end of this character.
    over_utf16: u32,
}

impl WideCharacter {
    /// Offset of the byte after it.
    pub(crate) fn end(&self) -> u32 {
        self.at + self.len
    }

    /// Width in columns.
    pub(crate) fn width(&self, unit: ColumnUnit) -> u32 {
        self.len - surplus(self.len, unit)
    }

    /// Number of bytes minus number of units in the text, up to the end of this character.
    pub(crate) fn surplus(&self, unit: ColumnUnit) -> u32 {
        match unit {
            ColumnUnit::Utf8 => 0,
            ColumnUnit::Utf16 => self.over_utf16,
            ColumnUnit::Utf32 => self.over_characters,
        }
    }
}

/// Multi-byte characters of a text, ascending. ASCII texts and ASCII lines are skipped quickly.
pub(crate) fn wide_characters(text: &str) -> Vec<WideCharacter> {
    let (mut wide, mut start) = (Vec::new(), 0_u32);
    if text.is_ascii() {
        return wide;
    }
    let (mut over_characters, mut over_utf16) = (0, 0);
    for line in text.split_inclusive('\n') {
        if !line.is_ascii() {
            for (at, first) in (start..).zip(line.bytes()).filter(|(_, byte)| *byte >= 0xC0) {
                let len = bytes(first);
                over_characters += surplus(len, ColumnUnit::Utf32);
                over_utf16 += surplus(len, ColumnUnit::Utf16);
                wide.push(WideCharacter { at, len, over_characters, over_utf16 });
            }
        }
        start = start.saturating_add(u32::try_from(line.len()).unwrap_or(u32::MAX));
    }
    wide
}

/// Number of bytes minus number of units in a character with `len` bytes.
fn surplus(len: u32, unit: ColumnUnit) -> u32 {
    match unit {
        ColumnUnit::Utf8 => 0,
        ColumnUnit::Utf16 => len - len / 2,
        ColumnUnit::Utf32 => len - 1,
    }
}

/// Length in bytes of the UTF-8 character that begins with this byte.
fn bytes(first: u8) -> u32 {
    match first {
        0xF0.. => 4,
        0xE0.. => 3,
        _ => 2,
    }
}
