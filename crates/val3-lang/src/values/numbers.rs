//! Functions of the instructions and operators of numbers (3.2).
//!
//! `sin` and similar functions belong to the geometry. Infinite and undefined numbers follow IEEE 754: `+`, `-`, `*`
//! and `/` may leave the range of a number and then give an infinity.

use crate::fault::{Fault, Result};
use crate::runtime_errors::{DIVISION_BY_ZERO, INVALID_NUMBER};

/// `/`.
///
/// # Errors
/// 10: the right side is 0.
pub fn divide(left: f64, right: f64) -> Result<f64> {
    if right == 0.0 { Err(Fault(DIVISION_BY_ZERO)) } else { Ok(left / right) }
}

/// `%`: what remains of `left` after a division by `right`, with the sign of `left`.
///
/// # Errors
/// 10: the right side is 0.
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

/// `exp`. A result too small for a number is 0.
///
/// # Errors
/// 11: the result is too large.
pub fn exp(value: f64) -> Result<f64> {
    not_too_large(libm::exp(value))
}

/// `power` up to s7. A result too small for a number is 0.
///
/// # Errors
/// 11: the base is 0 or negative, whatever the exponent, or the result is too large.
pub fn power(base: f64, exponent: f64) -> Result<f64> {
    not_too_large(libm::pow(positive(base)?, exponent))
}

/// `power` from s8 on: also that of 0 to a positive exponent, and of a negative base to a whole one.
///
/// # Errors
/// 11: there is no such power, or it is too large.
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

/// `log`: the decimal logarithm. That of a power of ten is exact.
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

/// `roundUp`: the smallest whole number that is not below the value.
#[must_use]
pub fn round_up(value: f64) -> f64 {
    unsigned_zero(value.ceil())
}

/// `roundDown`: the largest whole number that is not above the value.
#[must_use]
pub fn round_down(value: f64) -> f64 {
    unsigned_zero(value.floor())
}

/// The largest number below a half. The whole part of what is higher by this than a number above zero is that number
/// rounded as by [`round`]: with a half, the number just below a half would become 1.
pub const BELOW_HALF: f64 = 0.499_999_999_999_999_94;

/// `round`: the nearest whole number; of two equally near ones the larger.
#[must_use]
pub fn round(value: f64) -> f64 {
    // Adding 0.5 first would round the number just below 0.5 up.
    let below = value.floor();
    unsigned_zero(if value - below >= 0.5 { below + 1.0 } else { below })
}

/// 0 for the negative zero of IEEE 754, which VAL 3 does not know.
fn unsigned_zero(value: f64) -> f64 {
    value + 0.0
}

/// `min`. Of equal ones it is the first.
#[must_use]
pub fn min(x: f64, y: f64) -> f64 {
    if y < x || x.is_nan() { y } else { x }
}

/// `max`. Of equal ones it is the first.
#[must_use]
pub fn max(x: f64, y: f64) -> f64 {
    if y > x || x.is_nan() { y } else { x }
}

/// `limit`. Where the bounds are the wrong way round the result is the lower bound.
#[must_use]
pub fn limit(value: f64, lower: f64, upper: f64) -> f64 {
    max(min(value, upper), lower)
}

/// `sel`.
#[must_use]
pub fn sel(condition: bool, if_true: f64, if_false: f64) -> f64 {
    if condition { if_true } else { if_false }
}

/// The place in an array of `size` elements that an index means: the index is rounded as by `round` (2.5.3).
///
/// # Errors
/// 20: not below the size; 21: below 0, or no number.
pub fn index(index: f64, size: usize) -> Result<usize> {
    let index = count_from_zero(index).ok_or(Fault::INDEX_NEGATIVE)?;
    if index < size { Ok(index) } else { Err(Fault::INDEX_TOO_LARGE) }
}

/// How many, or from where on, an instruction shall take: the number is rounded as an index is.
///
/// # Errors
/// 70: negative, or no number.
pub fn count(number: f64) -> Result<usize> {
    count_from_zero(number).ok_or(Fault::INVALID_PARAMETER)
}

/// The number rounded; `None` below 0.
pub(super) fn count_from_zero(number: f64) -> Option<usize> {
    let whole = round(number);
    // The cast ends at the largest size; nothing is that large.
    (whole >= 0.0).then_some(whole as usize)
}

#[cfg(test)]
mod tests;
