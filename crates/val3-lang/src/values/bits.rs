//! Numbers as 32-bit fields (3.3).
//!
//! A number is rounded as by `round` and limited to the range of a field: negative numbers become 0, too large numbers
//! have all bits set.

use super::numbers::round;

/// Converts a number to 32 bits.
#[must_use]
pub fn field(value: f64) -> u32 {
    // The cast saturates.
    round(value) as u32
}

/// `bNot`: inverts every bit.
#[must_use]
pub fn not(value: f64) -> f64 {
    f64::from(!field(value))
}

/// `bAnd`: bits that are set in both numbers.
#[must_use]
pub fn and(left: f64, right: f64) -> f64 {
    f64::from(field(left) & field(right))
}

/// `bOr`: bits that are set in at least one number.
#[must_use]
pub fn or(left: f64, right: f64) -> f64 {
    f64::from(field(left) | field(right))
}

/// `bXor`: bits that are set in exactly one number.
#[must_use]
pub fn xor(left: f64, right: f64) -> f64 {
    f64::from(field(left) ^ field(right))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::{any, prop_assert_eq, proptest};

    use super::{and, field, not, or, xor};
    use crate::values::numbers::power;

    const ALL: f64 = 4_294_967_295.0;

    fn bit(number: u32) -> f64 {
        power(2.0, f64::from(number)).unwrap()
    }

    /// Mask of bits `i` to `j`, computed as on the page of `bOr`.
    fn mask(i: u32, j: u32) -> f64 {
        (bit(j - i + 1) - 1.0) * bit(i)
    }

    #[test]
    fn works_on_every_bit() {
        assert_eq!([not(0.0), not(ALL), not(255.0)], [ALL, 0.0, 4_294_967_040.0]);
        assert_eq!([and(12.0, 10.0), or(12.0, 10.0), xor(12.0, 10.0)], [8.0, 14.0, 6.0]);
        assert_eq!([and(ALL, bit(31)), or(0.0, bit(31)), xor(ALL, bit(31))], [bit(31), bit(31), bit(31) - 1.0]);
    }

    #[test]
    fn numbers_are_rounded_into_the_range() {
        assert_eq!([2.4, 2.5, 0.5, -0.5, -0.51, -1.0, -1e300].map(field), [2, 3, 1, 0, 0, 0, 0]);
        assert_eq!([ALL, ALL - 0.5, ALL + 0.49, ALL + 1.0, 1e300, f64::INFINITY].map(field), [u32::MAX; 6]);
        assert_eq!(field(ALL - 0.51), u32::MAX - 1);
        assert_eq!(field(f64::NAN), 0);
        assert_eq!([not(-1.0), and(-1.0, 1.0)], [ALL, 0.0]);
    }

    #[test]
    fn resets_bits_with_a_mask() {
        assert_eq!(and(ALL, not(mask(4, 7))), 4_294_967_055.0);
        assert_eq!(and(ALL, not(mask(0, 31))), 0.0);
    }

    #[test]
    fn prints_bit_by_bit() {
        let value = 2_147_483_653.0;
        let bits: String = (0..=31).rev().map(|i| if and(value, bit(i)) == bit(i) { '1' } else { '0' }).collect();
        assert_eq!(bits, "10000000000000000000000000000101");
    }

    #[test]
    fn both_ways_to_a_mask_agree() {
        for (i, j) in [(0, 0), (0, 31), (3, 9), (31, 31)] {
            assert_eq!((i..=j).fold(0.0, |field, k| or(field, bit(k))), mask(i, j));
        }
    }

    #[test]
    fn inverts_bits_with_a_mask() {
        assert_eq!(xor(165.0, mask(0, 3)), 170.0);
        assert_eq!(xor(xor(165.0, mask(2, 9)), mask(2, 9)), 165.0);
    }

    proptest! {
        #[test]
        fn does_what_a_machine_does(left in any::<u32>(), right in any::<u32>()) {
            let (x, y) = (f64::from(left), f64::from(right));
            prop_assert_eq!([field(not(x)), field(and(x, y))], [!left, left & right]);
            prop_assert_eq!([field(or(x, y)), field(xor(x, y))], [left | right, left ^ right]);
        }
    }
}
