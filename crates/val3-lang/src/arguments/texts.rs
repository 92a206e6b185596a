//! Format strings in arguments of instructions.

use crate::values::number_text;

/// Format of a string argument.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TextForm {
    /// A binary encoding, one of [`BINARY_FORMATS`]. Other strings cause run-time error 70 (3.3.3).
    Binary,
    /// `size.precision` of a number as string; each is a whole number and optional (3.4.3). Text after it is ignored.
    /// Another prefix causes run-time error 70.
    Number,
    /// A string in which each of [`DATE_KEYS`] is replaced by a part of the date; other text is copied (4.3).
    Date,
}

/// Binary encodings of numbers: sign, bytes, floating point, byte order (3.3.3).
pub const BINARY_FORMATS: [&str; 14] =
    ["-1", "1", "-2l", "-2b", "2l", "2b", "-4l", "-4b", "4l", "4b", "4.0l", "4.0b", "8.0l", "8.0b"];

/// Keys in a date format: year, month, day, hours, half of the day, minutes, seconds (4.3).
pub const DATE_KEYS: [&str; 9] = ["%y", "%Y", "%m", "%d", "%H", "%I", "%p", "%M", "%S"];

/// Size of a number in a binary encoding, in bytes.
#[must_use]
pub fn bytes(format: &str) -> Option<u32> {
    let known = BINARY_FORMATS.contains(&format);
    format.trim_start_matches('-').chars().next().filter(|_| known)?.to_digit(10)
}

/// Format in which `instruction` reads the parameter `parameter`.
#[must_use]
pub fn text_form(instruction: &str, parameter: &str) -> Option<TextForm> {
    match (instruction, parameter) {
        ("toBinary" | "fromBinary", "sDataFormat") => Some(TextForm::Binary),
        ("toString", "sFormat") => Some(TextForm::Number),
        ("getDate", "sFormat") => Some(TextForm::Date),
        _ => None,
    }
}

impl TextForm {
    /// First part of `text` that the instruction cannot read; for a date format without keys, the entire text.
    #[must_use]
    pub fn fault(self, text: &str) -> Option<&str> {
        match self {
            Self::Binary => (!BINARY_FORMATS.contains(&text)).then_some(text),
            Self::Number => number_text::ignored(text).is_none().then_some(text),
            Self::Date => date_fault(text),
        }
    }
}

/// Text from the first `%` that begins no key.
fn date_fault(text: &str) -> Option<&str> {
    let mut keys = text.char_indices().filter(|(_, character)| *character == '%').peekable();
    if keys.peek().is_none() {
        return Some(text);
    }
    keys.find_map(|(at, _)| {
        let rest = text.get(at..)?;
        let key = rest.get(..rest.char_indices().nth(2).map_or(rest.len(), |(end, _)| end))?;
        (!DATE_KEYS.contains(&key)).then_some(key)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn binary_formats_are_listed() {
        assert_eq!(TextForm::Binary.fault("-4l"), None);
        assert_eq!(TextForm::Binary.fault("4"), Some("4"));
        assert_eq!(TextForm::Binary.fault("-8.0b"), Some("-8.0b"));
    }

    #[test]
    fn encodings_have_a_length() {
        assert_eq!((bytes("-1"), bytes("2b"), bytes("8.0l"), bytes("3l")), (Some(1), Some(2), Some(8), None));
    }

    #[test]
    fn numbers_have_a_size_and_a_precision() {
        for good in ["", "8", ".4", "8.4", "0.2", "8.", ".2,", "8,4"] {
            assert_eq!(TextForm::Number.fault(good), None, "{good}");
        }
        for bad in ["%d", "-3", "x", " 8"] {
            assert_eq!(TextForm::Number.fault(bad), Some(bad));
        }
    }

    #[test]
    fn dates_hold_keys() {
        assert_eq!(TextForm::Date.fault("%H:%M:%S on %d"), None);
        assert_eq!(TextForm::Date.fault("%Y-%D"), Some("%D"));
        assert_eq!(TextForm::Date.fault("100%"), Some("%"));
        assert_eq!(TextForm::Date.fault("H:M"), Some("H:M"));
    }

    #[test]
    fn forms_belong_to_parameters() {
        assert_eq!(text_form("toString", "sFormat"), Some(TextForm::Number));
        assert_eq!(text_form("toString", "nValue"), None);
    }
}
