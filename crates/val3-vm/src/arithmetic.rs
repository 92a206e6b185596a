//! Computations of operations that need more than one expression.

use val3_lang::fault::{Fault, Result};
use val3_lang::runtime_errors::DIVISION_BY_ZERO;

/// Converts a truth value to 0 or 1.
#[inline]
pub(crate) fn truth(value: bool) -> f64 {
    f64::from(u8::from(value))
}

/// Returns the remainder, with the sign of `a` (3.2.2).
///
/// Most numbers are whole, and the integer remainder is many times faster than the general one.
#[inline]
pub(crate) fn remainder(a: f64, b: f64) -> Result<f64> {
    #[allow(clippy::cast_possible_truncation, reason = "what does not fit is not equal any more")]
    let (left, right) = (a as i32, b as i32);
    if f64::from(left) == a
        && f64::from(right) == b
        && let Some(remainder) = left.checked_rem(right)
    {
        // A remainder of 0 has the sign of `a` too.
        return Ok(f64::from(remainder.abs()).copysign(a));
    }
    remainder_of_any(a, b)
}

#[cold]
fn remainder_of_any(a: f64, b: f64) -> Result<f64> {
    if b == 0.0 { Err(Fault(DIVISION_BY_ZERO)) } else { Ok(a % b) }
}

/// Whether the counter of a `for` has passed the limit (2.2.5).
#[inline]
pub(crate) fn is_beyond(counter: f64, limit: f64, step: f64) -> bool {
    if step < 0.0 { counter < limit } else { counter > limit }
}

#[cfg(test)]
mod tests {
    use super::remainder;

    #[test]
    fn whole_numbers_have_the_remainders_of_all_others() {
        let numbers = [0.0, -0.0, 1.0, -1.0, 3.0, -3.0, 7.0, -7.0, 2.5, f64::from(i32::MIN), f64::from(i32::MAX), 1e18];
        for (a, b) in numbers.iter().flat_map(|a| numbers.map(|b| (*a, b))) {
            let found = remainder(a, b);
            if b == 0.0 {
                assert!(found.is_err(), "{a} % {b}");
            } else {
                assert_eq!(found.unwrap().to_bits(), (a % b).to_bits(), "{a} % {b}");
            }
        }
        assert!(remainder(f64::NAN, 2.0).unwrap().is_nan());
    }
}
