//! Functions of number instructions and operators (3.2).
//!
//! `sin` and similar functions belong to the geometry. Infinite and undefined numbers follow IEEE 754: `+`, `-`, `*`
//! and `/` return infinity for results that are out of range.

use crate::fault::{Fault, Result};
use crate::runtime_errors::{DIVISION_BY_ZERO, INVALID_NUMBER};

/// `/`.
///
/// # Errors
/// 10: the right operand is 0.
pub fn divide(left: f64, right: f64) -> Result<f64> {
    if right == 0.0 { Err(Fault(DIVISION_BY_ZERO)) } else { Ok(left / right) }
}

/// `%`: remainder of `left / right`, with the sign of `left`.
///
/// # Errors
/// 10: the right operand is 0.
pub fn remainder(left: f64, right: f64) -> Result<f64> {
    if right == 0.0 { Err(Fault(DIVISION_BY_ZERO)) } else { Ok(left % right) }
}

/// `abs`.
#[must_use]
pub fn abs(value: f64) -> f64 {
    value.abs()
}

/// `sqrt`.
///
/// # Errors
/// 11: the value is negative.
pub fn sqrt(value: f64) -> Result<f64> {
    if value < 0.0 { Err(Fault(INVALID_NUMBER)) } else { Ok(value.sqrt()) }
}

/// `exp`. An underflow returns 0.
///
/// # Errors
/// 11: the result is too large.
pub fn exp(value: f64) -> Result<f64> {
    not_too_large(libm::exp(value))
}

/// `power` up to s7. An underflow returns 0.
///
/// # Errors
/// 11: the base is 0 or negative, regardless of the exponent, or the result is too large.
pub fn power(base: f64, exponent: f64) -> Result<f64> {
    not_too_large(libm::pow(positive(base)?, exponent))
}

/// `power` from s8 on: also accepts base 0 with a positive exponent, and a negative base with a whole exponent.
///
/// # Errors
/// 11: the power is undefined or too large.
pub fn signed_power(base: f64, exponent: f64) -> Result<f64> {
    let is_defined = base > 0.0 || base == 0.0 && exponent > 0.0 || base < 0.0 && exponent.fract() == 0.0;
    if is_defined { not_too_large(unsigned_zero(libm::pow(base, exponent))) } else { power(base, exponent) }
}

/// `ln`.
///
/// # Errors
/// 11: the value is 0 or negative.
pub fn ln(value: f64) -> Result<f64> {
    positive(value).map(libm::log)
}

/// `log`: decimal logarithm, exact for powers of ten.
///
/// # Errors
/// 11: the value is 0 or negative.
pub fn log(value: f64) -> Result<f64> {
    positive(value).map(libm::log10)
}

fn positive(value: f64) -> Result<f64> {
    if value <= 0.0 { Err(Fault(INVALID_NUMBER)) } else { Ok(value) }
}

fn not_too_large(value: f64) -> Result<f64> {
    if value.is_infinite() { Err(Fault(INVALID_NUMBER)) } else { Ok(value) }
}

/// `roundUp`: smallest whole number that is at least the value.
#[must_use]
pub fn round_up(value: f64) -> f64 {
    unsigned_zero(value.ceil())
}

/// `roundDown`: largest whole number that is at most the value.
#[must_use]
pub fn round_down(value: f64) -> f64 {
    unsigned_zero(value.floor())
}

/// Largest double below 0.5. For `x > 0`, `trunc(x + BELOW_HALF) == round(x)`. Adding 0.5 instead would round
/// 0.49999999999999994 up to 1.
pub const BELOW_HALF: f64 = 0.499_999_999_999_999_94;

/// `round`: nearest whole number; halves are rounded up.
#[must_use]
pub fn round(value: f64) -> f64 {
    // Adding 0.5 first would round the largest number below 0.5 up.
    let below = value.floor();
    unsigned_zero(if value - below >= 0.5 { below + 1.0 } else { below })
}

/// Converts the negative zero of IEEE 754, which VAL 3 does not have, to 0.
fn unsigned_zero(value: f64) -> f64 {
    value + 0.0
}

/// `min`; the first of equal numbers.
#[must_use]
pub fn min(x: f64, y: f64) -> f64 {
    if y < x || x.is_nan() { y } else { x }
}

/// `max`; the first of equal numbers.
#[must_use]
pub fn max(x: f64, y: f64) -> f64 {
    if y > x || x.is_nan() { y } else { x }
}

/// `limit`. If `lower` exceeds `upper`, the result is `lower`.
#[must_use]
pub fn limit(value: f64, lower: f64, upper: f64) -> f64 {
    max(min(value, upper), lower)
}

/// `sel`.
#[must_use]
pub fn sel(condition: bool, if_true: f64, if_false: f64) -> f64 {
    if condition { if_true } else { if_false }
}

/// Converts an index to an element number below `size`: the index is rounded as by `round` (2.5.3).
///
/// # Errors
/// 20: not below the size; 21: below 0, or NaN.
pub fn index(index: f64, size: usize) -> Result<usize> {
    let index = count_from_zero(index).ok_or(Fault::INDEX_NEGATIVE)?;
    if index < size { Ok(index) } else { Err(Fault::INDEX_TOO_LARGE) }
}

/// Converts a number argument to a count or start index, rounded like an array index.
///
/// # Errors
/// 70: negative, or NaN.
pub fn count(number: f64) -> Result<usize> {
    count_from_zero(number).ok_or(Fault::INVALID_PARAMETER)
}

/// Rounded number; `None` below 0.
pub(super) fn count_from_zero(number: f64) -> Option<usize> {
    let whole = round(number);
    // The cast saturates.
    (whole >= 0.0).then_some(whole as usize)
}

#[cfg(test)]
mod tests;
