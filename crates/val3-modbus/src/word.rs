//! Conversion of a number in an `aio` variable to a word.

/// Least number that a word can contain, if it is read as a signed number.
const LOWEST_WORD: f64 = -32_768.0;

/// Greatest number that a word can contain.
const HIGHEST_WORD: f64 = 65_535.0;

/// Converts a number to a word: rounded to the nearest integer, and limited to -32768 to 65535. A negative number is
/// written in two's complement.
///
/// ```
/// use val3_modbus::word;
/// assert_eq!([word(7.4), word(65_535.0), word(-1.0), word(1e9)], [7, 65_535, 65_535, 65_535]);
/// ```
#[must_use]
pub fn word(number: f64) -> u16 {
    let whole = (number + 0.5).floor().clamp(LOWEST_WORD, HIGHEST_WORD);
    // NaN becomes 0.
    #[expect(clippy::cast_possible_truncation, reason = "-32768 to 65535")]
    let whole = whole as i32;
    let [.., high, low] = whole.to_be_bytes();
    u16::from_be_bytes([high, low])
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::word;

    #[test]
    fn numbers_are_rounded_and_limited() {
        assert_eq!([0.4, 0.5, -0.5, -0.6, 65_535.4].map(word), [0, 1, 0, 65_535, 65_535]);
        assert_eq!([-32_768.0, -1e9, 1e300, f64::INFINITY, f64::NAN].map(word), [32_768, 32_768, 65_535, 65_535, 0]);
    }

    proptest! {
        #[test]
        fn every_word_is_its_own_number(value: u16) {
            prop_assert_eq!(word(f64::from(value)), value);
        }

        #[test]
        fn a_signed_number_is_read_back(value: i16) {
            prop_assert_eq!(word(f64::from(value)).cast_signed(), value);
        }
    }
}
