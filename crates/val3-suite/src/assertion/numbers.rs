//! Formats two different numbers with as many digits as necessary to show the difference.

use val3_lang::values::printed;

/// Unit of angles.
pub(super) const DEGREE: &str = "degree";

/// Minimum number of significant digits of a value.
const DIGITS: usize = 9;

/// Minimum number of significant digits of a difference.
const DIFFERENCE_DIGITS: usize = 6;

/// Number of significant digits with which different numbers always have different texts.
const ALL_DIGITS: usize = 17;

/// Numbers of decimals for position fields, in the order in which they are tried.
const DECIMALS: [usize; 4] = [3, 6, 9, ALL_DIGITS];

/// Message for two numbers whose difference exceeds the tolerance.
pub(super) fn difference(actual: f64, expected: f64, tolerance: f64) -> String {
    let (left, right) = apart(actual, expected, DIGITS);
    format!("{left} instead of {right}{}", excess(actual, expected, tolerance, ""))
}

/// Difference between two numbers, and its tolerance, in parentheses; `unit` is `degree`, `mm`, or empty.
pub(super) fn excess(actual: f64, expected: f64, tolerance: f64, unit: &str) -> String {
    let distance = (actual - expected).abs();
    if !distance.is_finite() {
        return String::new();
    }
    let (distance, tolerance) = apart(distance, tolerance, DIFFERENCE_DIGITS);
    let distance = if unit.is_empty() { distance } else { measured(&distance, unit) };
    format!(" ({distance} away, tolerance {tolerance})")
}

/// Formats a number with its unit; `degree` has a plural.
pub(super) fn measured(number: &str, unit: &str) -> String {
    let ending = if unit == DEGREE && number != "1" { "s" } else { "" };
    format!("{number} {unit}{ending}")
}

/// Formats both numbers with at least `digits` significant digits, and with more if the texts would be equal.
pub(super) fn apart(one: f64, other: f64, digits: usize) -> (String, String) {
    let texts = |digits| (significant(one, digits), significant(other, digits));
    (digits..ALL_DIGITS).map(texts).find(|(one, other)| one != other).unwrap_or_else(|| texts(ALL_DIGITS))
}

/// Formats both positions in VAL 3 notation, with enough decimals to show the difference.
pub(super) fn structures_apart(one: &[f64], other: &[f64]) -> (String, String) {
    let texts = |decimals| (structure(one, decimals), structure(other, decimals));
    DECIMALS.into_iter().map(texts).find(|(one, other)| one != other).unwrap_or_else(|| texts(ALL_DIGITS))
}

fn structure(numbers: &[f64], decimals: usize) -> String {
    printed::structure(&numbers.iter().map(|number| fixed(*number, decimals)).collect::<Vec<_>>())
}

fn significant(value: f64, digits: usize) -> String {
    let rounded: f64 = format!("{value:.*e}", digits.saturating_sub(1)).parse().unwrap_or(value);
    match rounded.abs() {
        _ if !rounded.is_finite() => printed::num(value).to_string(),
        0.0 => "0".to_owned(),
        size if !(1e-6..1e15).contains(&size) => format!("{rounded:e}"),
        _ => rounded.to_string(),
    }
}

fn fixed(value: f64, decimals: usize) -> String {
    if !value.is_finite() {
        return printed::num(value).to_string();
    }
    let text = format!("{value:.decimals$}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_told_apart() {
        for (actual, expected, tolerance, message) in [
            (1.5, 1.0, 0.4, "1.5 instead of 1 (0.5 away, tolerance 0.4)"),
            (0.1 + 0.2, 0.3, 0.0, "0.30000000000000004 instead of 0.3 (5.55112e-17 away, tolerance 0)"),
            (123_456.7, 200_000.0, 1.0, "123456.7 instead of 200000 (76543.3 away, tolerance 1)"),
            (1.400_001, 1.0, 0.4, "1.400001 instead of 1 (0.400001 away, tolerance 0.4)"),
            (-0.0, 1e-300, 0.0, "0 instead of 1e-300 (1e-300 away, tolerance 0)"),
            (f64::NAN, 5.0, 0.0, "nan instead of 5"),
            (f64::INFINITY, -1.0, 0.0, "inf instead of -1"),
        ] {
            assert_eq!(difference(actual, expected, tolerance), message);
        }
    }

    #[test]
    fn positions_are_told_apart() {
        let apart = |one: &[f64], other: &[f64]| structures_apart(one, other);
        assert_eq!(apart(&[1.0, -0.000_01], &[1.5, 0.0]), ("{1,0}".to_owned(), "{1.5,0}".to_owned()));
        assert_eq!(apart(&[100.0], &[100.000_04]), ("{100}".to_owned(), "{100.00004}".to_owned()));
        assert_eq!(apart(&[f64::NAN], &[10.0]), ("{nan}".to_owned(), "{10}".to_owned()));
    }
}
