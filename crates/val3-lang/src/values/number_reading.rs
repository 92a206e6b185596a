//! Parses numbers: number literals (3.2.1) and `toNum` (3.4.3).

use super::Text;

/// Result of `toNum`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NumberReading {
    /// Number at the start of the string, if there is one: `bReport`, and the new value of `nValue`.
    pub value: Option<f64>,
    /// Remaining string from the next number on; the entire string if it does not start with a number.
    pub rest: Text,
}

/// Value of a number literal in code, without a sign: `12`, `0.2`, `.5`, `6.02e23`, `1e-34`.
///
/// `None` for other text and for a literal that is out of range.
#[must_use]
pub fn literal(text: &str) -> Option<f64> {
    if text.starts_with(['+', '-']) || length(text)? < text.len() {
        return None;
    }
    value(text)
}

/// `toNum`.
///
/// Blanks before the first number are skipped, so that strings from `toString` can be read. Numbers are written as in
/// code, with an optional `+` or `-`. A number that is out of range does not count as a number.
#[must_use]
pub fn to_num(text: &Text) -> NumberReading {
    let start = text.trim_start_matches([' ', '\t']);
    let found = length(start).and_then(|len| start.split_at_checked(len));
    match found.and_then(|(number, behind)| Some((value(number)?, behind))) {
        Some((value, behind)) => NumberReading { value: Some(value), rest: Text::from(from_next_number(behind)) },
        None => NumberReading { value: None, rest: *text },
    }
}

fn from_next_number(text: &str) -> &str {
    text.char_indices().filter_map(|(at, _)| text.get(at..)).find(|rest| length(rest).is_some()).unwrap_or("")
}

fn value(number: &str) -> Option<f64> {
    number.parse().ok().filter(|value: &f64| value.is_finite())
}

/// Length in bytes of the number at the start of the string; `None` if the string starts with no number.
fn length(text: &str) -> Option<usize> {
    let behind_sign = text.strip_prefix(['+', '-']).unwrap_or(text);
    let behind_whole = without_digits(behind_sign);
    let behind_decimals = behind_whole.strip_prefix('.').and_then(some_digits).unwrap_or(behind_whole);
    if behind_decimals.len() == behind_sign.len() {
        return None;
    }
    let rest = exponent(behind_decimals).unwrap_or(behind_decimals);
    Some(text.len() - rest.len())
}

/// Text after an exponent at the start; `None` without an exponent.
fn exponent(text: &str) -> Option<&str> {
    let behind_mark = text.strip_prefix(['e', 'E'])?;
    some_digits(behind_mark.strip_prefix(['+', '-']).unwrap_or(behind_mark))
}

/// Text after digits at the start; `None` if there are none.
fn some_digits(text: &str) -> Option<&str> {
    Some(without_digits(text)).filter(|rest| rest.len() < text.len())
}

fn without_digits(text: &str) -> &str {
    text.trim_start_matches(|next: char| next.is_ascii_digit())
}

#[cfg(test)]
#[expect(clippy::approx_constant, reason = "the manual writes pi and e out")]
mod tests {
    use proptest::prelude::{any, prop_assert_eq, proptest};

    use super::{literal, to_num};
    use crate::values::number_text::{shown, significant, to_string};
    use crate::values::numbers::round;
    use crate::values::{Text, strings};

    fn read(text: &str) -> (String, Option<f64>) {
        let reading = to_num(&Text::from(text));
        (reading.rest.to_string(), reading.value)
    }

    #[track_caller]
    fn check(text: &str, rest: &str, value: f64) {
        assert_eq!(read(text), (rest.to_owned(), Some(value)));
    }

    #[track_caller]
    fn check_none(text: &str) {
        assert_eq!(read(text), (text.to_owned(), None));
    }

    #[test]
    fn reads_as_the_manual_does() {
        check("10 20 30", "20 30", 10.0);
        check_none("a10 20 30");
        check("10 end", "", 10.0);
    }

    #[test]
    fn reads_number_after_number() {
        let (mut buffer, mut lines) = (Text::from("+90 0.0 -7.6 17.3"), Vec::new());
        loop {
            let reading = to_num(&buffer);
            buffer = reading.rest;
            lines.push(shown(reading.value.unwrap()).to_string());
            if buffer.is_empty() {
                break;
            }
        }
        assert_eq!(lines, ["90", "0", "-7.6", "17.3"]);
    }

    #[test]
    fn the_rest_starts_with_the_next_number() {
        check("1,2;3", "2;3", 1.0);
        check("10-20", "-20", 10.0);
        check("10 --5", "-5", 10.0);
        check("10 - 5", "5", 10.0);
        check("1.2.3", ".3", 1.2);
        check("4 x=+.5mm", "+.5mm", 4.0);
        check("7 机器 8", "8", 7.0);
        check("0x10", "10", 0.0);
    }

    #[test]
    fn takes_the_longest_number() {
        check("1e3", "", 1000.0);
        check("-1.5E+02x", "", -150.0);
        check("2e-2 1", "1", 0.02);
        check("3e", "", 3.0);
        check("3e-", "", 3.0);
        check("3 e5", "5", 3.0);
        check("5.", "", 5.0);
        check("5.e3", "3", 5.0);
        check("-.5", "", -0.5);
        check("007", "", 7.0);
    }

    #[test]
    fn blanks_before_the_number_do_not_count() {
        check("  \t2.7   ", "", 2.7);
    }

    #[test]
    fn where_no_number_starts_nothing_changes() {
        for text in ["", " ", "-", "+", ".", "-.", "e5", "+-5", "--5", "- 5", "\n5", "inf", "nan", "é1", "１"] {
            check_none(text);
        }
    }

    #[test]
    fn a_number_too_large_is_none() {
        check("1.7976931348623157e308 1", "1", f64::MAX);
        check_none("1e309 1");
        check_none("-1e309");
        check("1e-400", "", 0.0);
    }

    #[test]
    fn literals_have_their_value() {
        let literals = ["1", "0.2", "3.141592653", "6.02214179e23", "1.054571628e-34", "1e3", "1e-2", ".5", "1E+3"];
        let values = [1.0, 0.2, 3.141592653, 6.02214179e23, 1.054571628e-34, 1000.0, 0.01, 0.5, 1000.0];
        assert_eq!(literals.map(literal), values.map(Some));
    }

    #[test]
    fn other_text_is_no_literal() {
        for text in ["", "-1", "+1", "1.", "1e", "1 ", " 1", "x", "1e309", "0x10", "inf"] {
            assert_eq!(literal(text), None, "{text}");
        }
    }

    proptest! {
        #[test]
        fn reads_what_to_string_writes(value in -1e9..1e9, size in 0..30_usize, precision in 0..16_usize) {
            let text = to_string(&format!("{size}.{precision}"), value).unwrap();
            let nearest: f64 = format!("{value:.precision$}").parse().unwrap();
            let reading = to_num(&text);
            prop_assert_eq!(reading.value, Some(nearest));
            prop_assert_eq!(reading.rest, Text::new());
        }

        #[test]
        fn reads_whole_numbers_back(number in any::<i32>()) {
            let value = f64::from(number);
            prop_assert_eq!(to_num(&to_string("", value).unwrap()).value, Some(value));
            prop_assert_eq!(to_num(&significant(value)).value, Some(value));
            prop_assert_eq!(round(value), value);
        }

        #[test]
        fn reads_14_digits_back(value in any::<f64>()) {
            let value = if value.is_finite() { value } else { 0.0 };
            let printed = significant(value);
            let digits: f64 = format!("{value:.13e}").parse().unwrap();
            prop_assert_eq!(to_num(&printed).value, Some(digits).filter(|digits| digits.is_finite()));
        }

        #[test]
        fn the_rest_is_the_end_of_the_text(text in "[ +.,0-9eéx-]{0,40}") {
            let text = Text::from(text.as_str());
            let rest = to_num(&text).rest;
            prop_assert_eq!(strings::right(&text, strings::len(&rest) as f64).unwrap(), rest);
        }
    }
}
