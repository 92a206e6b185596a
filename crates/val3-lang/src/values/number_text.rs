//! Formats numbers (3.4.3 `toString`, 4.3 `put`, `val3 eval`).
//!
//! Numbers are rounded to the nearest decimal number, and halfway values to the even digit. Zero has no sign. Special
//! values of IEEE 754 are written `inf`, `-inf` and `nan`.

use super::Text;
use crate::fault::{Fault, Result};

/// Number of significant digits (3.2.1).
const SIGNIFICANT: usize = 14;

/// Absolute value from which the integer part with its sign exceeds [`Text::CAPACITY`] characters.
const TOO_LONG: f64 = 1e127;

/// Absolute value up to which every whole number is exact: 2^53.
const EXACT: f64 = 9_007_199_254_740_992.0;

/// `toString`: `format` is `"size.precision"`; missing parts are 0.
///
/// Trailing zeros of the decimals are replaced by blanks, and so is a point without decimals. Blanks before the number
/// fill it up to `size` characters. The integer part is never shortened; a number that is too long for a string is
/// written with an exponent. Text after the precision is ignored, because existing programs contain such formats
/// (`".2,"`).
///
/// # Errors
/// 70: the format starts with neither a digit nor a point, or a size or precision exceeds the 128 characters of a
/// string.
pub fn to_string(format: &str, value: f64) -> Result<Text> {
    let NumberFormat { size, precision, .. } = NumberFormat::parse(format).ok_or(Fault::INVALID_PARAMETER)?;
    let number = fixed(value, precision);
    let kept = without_final_zeros(&number);
    let dropped = number.len() - kept.len();
    if dropped == 0 && size <= number.len() {
        return Ok(number);
    }
    let front = size.saturating_sub(dropped);
    Ok(Text::from(format_args!("{kept:>front$}{:dropped$}", "")))
}

/// End of a `toString` format that the instruction ignores: `,` in `".2,"`. `None` for an invalid format.
#[must_use]
pub fn ignored(format: &str) -> Option<&str> {
    NumberFormat::parse(format).map(|format| format.ignored)
}

struct NumberFormat<'t> {
    size: usize,
    precision: usize,
    ignored: &'t str,
}

impl<'t> NumberFormat<'t> {
    fn parse(text: &'t str) -> Option<Self> {
        if !text.is_empty() && !text.starts_with(|first: char| first.is_ascii_digit() || first == '.') {
            return None;
        }
        let (size, rest) = leading_count(text)?;
        let (precision, ignored) = rest.strip_prefix('.').map_or(Some((0, rest)), leading_count)?;
        Some(Self { size, precision, ignored })
    }
}

/// Number at the start of the text, or 0 without digits, and the remaining text.
fn leading_count(text: &str) -> Option<(usize, &str)> {
    let (digits, rest) = text.split_at(text.bytes().take_while(u8::is_ascii_digit).count());
    let count = if digits.is_empty() { 0 } else { digits.parse().ok()? };
    (count <= Text::CAPACITY).then_some((count, rest))
}

/// Formats a number as `put` and `putln` display it: at most 3 decimals, without trailing zeros.
#[must_use]
pub fn shown(value: f64) -> Text {
    Text::from(without_final_zeros(&fixed(value, 3)))
}

/// Formats a number as `?` and `val3 eval` print it: at most 14 significant digits.
///
/// Numbers below 0.0001 and numbers with more than 14 digits have an exponent in VAL 3 notation: `1e-5`.
#[must_use]
pub fn significant(value: f64) -> Text {
    let scientific = scientific(value);
    match exponent_and_digits(&scientific) {
        Some((exponent, digits)) if (-4..SIGNIFICANT as i32).contains(&exponent) => {
            fixed(value, usize::try_from(digits - 1 - exponent).unwrap_or(0))
        }
        _ => scientific,
    }
}

/// Exponent of a number in scientific notation, and number of digits before the exponent.
fn exponent_and_digits(scientific: &str) -> Option<(i32, i32)> {
    let (mantissa, exponent) = scientific.split_once('e')?;
    let digits = mantissa.bytes().filter(u8::is_ascii_digit).count();
    Some((exponent.parse().ok()?, digits as i32))
}

/// Formats all `precision` decimals; cut at the capacity of a string.
fn fixed(value: f64, precision: usize) -> Text {
    if precision == 0 && value.abs() < EXACT && value.fract() == 0.0 {
        #[allow(clippy::cast_possible_truncation, reason = "a whole number, and exact")]
        return Text::from(format_args!("{}", value as i64));
    }
    if value.abs() >= TOO_LONG || value.is_nan() {
        return scientific(value);
    }
    let text = Text::from(format_args!("{value:.precision$}"));
    match text.strip_prefix('-') {
        Some(zero) if zero.bytes().all(|byte| matches!(byte, b'0' | b'.')) => Text::from(zero),
        _ => text,
    }
}

/// Formats in scientific notation with all significant digits.
fn scientific(value: f64) -> Text {
    if value.is_nan() {
        return Text::from("nan");
    }
    let text = Text::from(format_args!("{value:.0$e}", SIGNIFICANT - 1));
    match text.split_once('e') {
        Some((mantissa, exponent)) => Text::from_iter([without_final_zeros(mantissa), "e", exponent]),
        None => text,
    }
}

/// Removes trailing zeros of the decimals, and a point without decimals.
fn without_final_zeros(number: &str) -> &str {
    if number.contains('.') && !number.contains('e') {
        number.trim_end_matches('0').trim_end_matches('.')
    } else {
        number
    }
}

#[cfg(test)]
#[expect(clippy::approx_constant, reason = "the manual writes pi and e out")]
mod tests {
    use super::{ignored, significant, to_string};
    use crate::fault::Fault;

    fn formatted(format: &str, value: f64) -> String {
        to_string(format, value).unwrap().to_string()
    }

    fn shown(value: f64) -> String {
        super::shown(value).to_string()
    }

    fn printed(value: f64) -> String {
        significant(value).to_string()
    }

    #[test]
    fn formats_as_the_manual_does() {
        let pi = 3.141592654;
        assert_eq!(formatted(".4", pi), "3.1416");
        assert_eq!(formatted("8", pi), "       3");
        assert_eq!(formatted("8.4", pi), "  3.1416");
        assert_eq!(formatted("8.4", 2.70001), "  2.7   ");
        assert_eq!(formatted("", pi), "3");
        assert_eq!(formatted("1.2", 1234.1234), "1234.12");
    }

    #[test]
    fn zeros_at_the_end_become_blanks() {
        assert_eq!(formatted(".2", 3.0), "3   ");
        assert_eq!(formatted("7.2", -3.0), "  -3   ");
        assert_eq!(formatted(".3", 100.5), "100.5  ");
        assert_eq!(formatted("5", 100.0), "  100");
        assert_eq!(formatted("7.1", 0.0), "    0  ");
    }

    #[test]
    fn a_part_of_the_format_may_be_missing() {
        assert_eq!(formatted(".", 2.6), "3");
        assert_eq!(formatted("4.", 2.6), "   3");
        assert_eq!(formatted("0.1", 2.65625), "2.7");
        assert_eq!(formatted(".2,", 2.65625), "2.66");
    }

    #[test]
    fn rounds_to_the_decimals() {
        assert_eq!([formatted("", 2.4), formatted("", 2.6), formatted("", -2.6)], ["2", "3", "-3"]);
        assert_eq!([formatted("", 1.5), formatted("", 2.5)], ["2", "2"]);
        assert_eq!([formatted("", -0.4), formatted(".1", -0.04)], ["0", "0  "]);
        assert_eq!(formatted(".1", 0.96), "1  ");
    }

    #[test]
    fn other_formats_are_refused() {
        for format in ["x", "-5", "+5", " 5", "%5.2", "129", ".129", "99999999999999999999999"] {
            assert_eq!(to_string(format, 1.0), Err(Fault::INVALID_PARAMETER), "{format}");
        }
    }

    #[test]
    fn the_end_of_a_format_is_ignored() {
        assert_eq!([ignored(".2,"), ignored("8,2"), ignored("3.2.1")], [Some(","), Some(",2"), Some(".1")]);
        assert_eq!([ignored(""), ignored("8.2"), ignored("8.")], [Some(""); 3]);
        assert_eq!([ignored("%8.2f"), ignored(" 8"), ignored("129")], [None; 3]);
    }

    #[test]
    fn fills_a_string_at_most() {
        assert_eq!(formatted("128", 1.0), format!("{:>128}", 1));
        assert_eq!(formatted(".126", 0.5), format!("{:<128}", 0.5));
        assert_eq!(formatted(".128", 0.5), format!("{:<128}", 0.5));
        assert_eq!(formatted("128.128", 1.0 / 3.0).len(), 128);
    }

    #[test]
    fn the_whole_part_is_never_cut() {
        assert_eq!(formatted("1", 12_345.0), "12345");
        assert_eq!(formatted("", 1.5e126).len(), 127);
        assert_eq!(formatted("", -1.5e126).len(), 128);
        assert_eq!(formatted(".2", -1.5e126).len(), 128);
        assert_eq!([formatted("", 1e127), formatted("9.2", -1.5e130)], ["1e127", " -1.5e130"]);
    }

    #[test]
    fn writes_values_that_are_no_numbers() {
        let odd = [f64::INFINITY, f64::NEG_INFINITY, f64::NAN];
        assert_eq!(odd.map(|value| formatted("5.2", value)), ["  inf", " -inf", "  nan"]);
        assert_eq!(odd.map(shown), ["inf", "-inf", "nan"]);
        assert_eq!(odd.map(printed), ["inf", "-inf", "nan"]);
    }

    #[test]
    fn put_shows_three_decimals() {
        assert_eq!([90.0, 0.0, -7.6, 17.3].map(shown), ["90", "0", "-7.6", "17.3"]);
        assert_eq!([1.23456, 1.9996, -0.0004, -0.0006].map(shown), ["1.235", "2", "0", "-0.001"]);
        assert_eq!([100.0, 0.5, 1e-20, -0.0].map(shown), ["100", "0.5", "0", "0"]);
        assert_eq!(shown(1e20), "100000000000000000000");
        assert_eq!(shown(1e200), "1e200");
    }

    #[test]
    fn eval_prints_14_digits() {
        assert_eq!([1.0, 0.2, -3.141592653, 0.1 + 0.2].map(printed), ["1", "0.2", "-3.141592653", "0.3"]);
        assert_eq!([6.02214179e23, 1.054571628e-34].map(printed), ["6.02214179e23", "1.054571628e-34"]);
        assert_eq!(printed(1.0 / 3.0), "0.33333333333333");
        assert_eq!(printed(2e4 / 3.0), "6666.6666666667");
        assert_eq!([0.0, -0.0, 1000.0, -120.0].map(printed), ["0", "0", "1000", "-120"]);
    }

    #[test]
    fn eval_takes_an_exponent_where_digits_do_not_suffice() {
        assert_eq!([99_999_999_999_999.0, 1e14, -1e14].map(printed), ["99999999999999", "1e14", "-1e14"]);
        assert_eq!([99_999_999_999_999.6, 123_456_789_012_345.0].map(printed), ["1e14", "1.2345678901234e14"]);
        assert_eq!([0.0001, 0.00012345, 0.00001].map(printed), ["0.0001", "0.00012345", "1e-5"]);
        assert_eq!([f64::MAX, 5e-324].map(printed), ["1.7976931348623e308", "4.9406564584125e-324"]);
    }
}
