#![expect(clippy::approx_constant, reason = "the manual writes pi and e out")]

use proptest::prelude::{any, prop_assert, prop_assert_eq, proptest};

use super::*;

const TOO_LARGE: Result<f64> = Err(Fault(INVALID_NUMBER));
const BY_ZERO: Result<f64> = Err(Fault(DIVISION_BY_ZERO));

/// Formats as the manual prints results.
fn printed(value: Result<f64>) -> String {
    crate::values::number_text::significant(value.unwrap()).to_string()
}

#[test]
fn a_remainder_has_the_sign_of_its_left_side() {
    assert_eq!(remainder(7.0, 3.0), Ok(1.0));
    assert_eq!(remainder(-7.0, 3.0), Ok(-1.0));
    assert_eq!(remainder(7.0, -3.0), Ok(1.0));
    assert_eq!(remainder(-7.0, -3.0), Ok(-1.0));
    assert_eq!(remainder(5.5, 2.0), Ok(1.5));
    assert_eq!(remainder(5.0, 2.5), Ok(0.0));
    assert_eq!(remainder(5.0, 0.0), BY_ZERO);
    assert_eq!(remainder(0.0, -0.0), BY_ZERO);
}

#[test]
fn a_quotient_has_its_fraction() {
    assert_eq!(divide(7.0, 2.0), Ok(3.5));
    assert_eq!(divide(-1.0, 4.0), Ok(-0.25));
    assert_eq!(divide(1.0, 0.0), BY_ZERO);
    assert_eq!(divide(0.0, 0.0), BY_ZERO);
    assert!(divide(1.0, 1e-300).is_ok());
}

#[test]
fn abs_drops_the_sign() {
    assert_eq!(abs(3.1415), 3.1415);
    assert_eq!(abs(-3.1415), 3.1415);
}

#[test]
fn sqrt_wants_0_or_more() {
    assert_eq!(sqrt(9.0), Ok(3.0));
    assert_eq!(sqrt(0.0), Ok(0.0));
    assert_eq!(sqrt(-f64::MIN_POSITIVE), TOO_LARGE);
    assert_eq!(sqrt(-1.0), TOO_LARGE);
}

#[test]
fn exp_ends_at_the_largest_number() {
    assert_eq!(printed(exp(1.0)), "2.718281828459");
    assert_eq!(exp(0.0), Ok(1.0));
    assert!(exp(709.78).is_ok());
    assert_eq!(exp(709.79), TOO_LARGE);
    assert_eq!(exp(1e9), TOO_LARGE);
    assert_eq!(exp(-1e9), Ok(0.0));
}

#[test]
fn power_wants_a_positive_base() {
    assert_eq!(power(5.0, 7.0), Ok(78125.0));
    assert_eq!(printed(exp(7.0 * ln(5.0).unwrap())), "78125");
    assert_eq!(power(2.0, -1.0), Ok(0.5));
    assert_eq!(power(3.0, 0.0), Ok(1.0));
    assert_eq!(power(0.0, 2.0), TOO_LARGE);
    assert_eq!(power(0.0, 0.0), TOO_LARGE);
    assert_eq!(power(-2.0, 2.0), TOO_LARGE);
    assert!(power(2.0, 1023.0).is_ok());
    assert_eq!(power(2.0, 1024.0), TOO_LARGE);
    assert_eq!(power(2.0, -2000.0), Ok(0.0));
}

#[test]
fn powers_of_two_are_exact() {
    for exponent in 0_u32..=52 {
        assert_eq!(power(2.0, f64::from(exponent)), Ok((1_u64 << exponent) as f64));
    }
}

#[test]
fn logarithms_want_a_positive_number() {
    // The page of `ln` prints one digit 9 too few.
    assert_eq!(printed(ln(2.718281828)), "0.99999999983113");
    assert_eq!(log(1000.0), Ok(3.0));
    for logarithm in [ln, log] {
        assert_eq!(logarithm(1.0), Ok(0.0));
        assert!(logarithm(f64::MIN_POSITIVE).is_ok());
        assert_eq!(logarithm(0.0), TOO_LARGE);
        assert_eq!(logarithm(-1.0), TOO_LARGE);
    }
}

#[test]
fn the_decimal_logarithm_of_a_power_of_ten_is_exact() {
    for exponent in -300_i32..=300 {
        let power: f64 = format!("1e{exponent}").parse().unwrap();
        assert_eq!(log(power), Ok(f64::from(exponent)), "{exponent}");
    }
}

#[test]
fn rounds_up_and_down() {
    assert_eq!([round_up(7.8), round_up(-7.8)], [8.0, -7.0]);
    assert_eq!([round_down(7.8), round_down(-7.8)], [7.0, -8.0]);
    assert_eq!([round_up(7.0), round_down(7.0)], [7.0, 7.0]);
    assert_eq!([round_up(1e300), round_down(-1e300)], [1e300, -1e300]);
    assert!(round_up(-0.5).is_sign_positive());
}

#[test]
fn rounds_halves_up() {
    assert_eq!([round(7.8), round(-7.8), round(0.5), round(-0.5)], [8.0, -8.0, 1.0, 0.0]);
    assert_eq!([round(2.5), round(-2.5), round(7.49), round(-7.51)], [3.0, -2.0, 7.0, -8.0]);
    assert_eq!(round(0.5_f64.next_down()), 0.0);
    assert_eq!(round((-0.5_f64).next_up()), 0.0);
    assert_eq!(round((-0.5_f64).next_down()), -1.0);
    assert_eq!([round(4_503_599_627_370_497.0), round(-1e300)], [4_503_599_627_370_497.0, -1e300]);
    assert!(round(-0.2).is_sign_positive());
}

#[test]
fn min_max_limit_sel() {
    assert_eq!(min(-1.0, 10.0), -1.0);
    assert_eq!(max(-1.0, 10.0), 10.0);
    assert_eq!(limit(30.0, -90.0, 90.0), 30.0);
    assert_eq!(limit(100.0, -90.0, 90.0), 90.0);
    assert_eq!(limit(-100.0, -90.0, 90.0), -90.0);
    assert_eq!([limit(90.0, -90.0, 90.0), limit(-90.0, -90.0, 90.0)], [90.0, -90.0]);
    assert_eq!(limit(0.0, 10.0, 5.0), 10.0);
    assert_eq!(sel(true, -90.0, 90.0), -90.0);
    assert_eq!(sel(false, -90.0, 90.0), 90.0);
}

#[test]
fn an_index_is_rounded_and_lies_in_the_array() {
    assert_eq!([index(5.01, 8), index(6.99, 8)], [Ok(5), Ok(7)]);
    assert_eq!([index(0.0, 1), index(-0.5, 1), index(0.49, 1)], [Ok(0); 3]);
    assert_eq!(index(7.49, 8), Ok(7));
    for beyond in [7.5, 8.0, 1e300, f64::INFINITY] {
        assert_eq!(index(beyond, 8), Err(Fault::INDEX_TOO_LARGE), "{beyond}");
    }
    for below in [-0.51, -1.0, -1e300, f64::NAN] {
        assert_eq!(index(below, 8), Err(Fault::INDEX_NEGATIVE), "{below}");
    }
    assert_eq!(index(0.0, 0), Err(Fault::INDEX_TOO_LARGE));
}

#[test]
fn a_count_is_rounded_and_not_negative() {
    assert_eq!([count(0.0), count(-0.5), count(2.5), count(2.49)], [Ok(0), Ok(0), Ok(3), Ok(2)]);
    assert_eq!(count(1e300), Ok(usize::MAX));
    assert_eq!([count(-0.51), count(f64::NAN)], [Err(Fault::INVALID_PARAMETER); 2]);
}

proptest! {
    #[test]
    fn whole_numbers_surround_their_number(value in -1e9..1e9) {
        prop_assert!(round_down(value) <= value && value <= round_up(value));
        prop_assert!(round(value) == round_down(value) || round(value) == round_up(value));
        prop_assert!((round(value) - value).abs() <= 0.5);
    }

    #[test]
    fn a_remainder_is_smaller_than_its_divisor(left in -1e9..1e9, right in 1e-3..1e9) {
        let rest = remainder(left, right).unwrap();
        prop_assert!(rest.abs() < right && rest * left >= 0.0);
    }

    #[test]
    fn a_limited_number_lies_between_its_bounds(value in any::<f64>(), lower in -9.0..0.0, upper in 0.0..9.0) {
        let limited = limit(value, lower, upper);
        prop_assert!((lower..=upper).contains(&limited));
        prop_assert_eq!(limit(limited, lower, upper), limited);
    }
}
