//! Trigonometry in degrees (manual 3.2.3), with an error of at most one in the last bit.
//!
//! Angles are not rounded to radians before the computation, so mathematically exact results are exact here: `sin(180)`
//! is 0, `sin(30)` and `cos(60)` are 0.5, `tan(45)` is 1, and `asin(0.5)` is 30. No function returns -0.

use crate::sine::{MANY_TURNS, reduce, sine_and_cosine, sine_of, to_radians};

/// Result of `tan` at the poles, odd multiples of 90°: the tangent of the double next to π/2.
///
/// The manual defines no run-time error for `tan`, and a number must not be infinite.
const TANGENT_AT_POLE: f64 = 1.633123935319537e16;

/// Returns the sine of an angle in degrees.
#[must_use]
pub fn sin(degrees: f64) -> f64 {
    sine_of(within_many_turns(degrees), 0)
}

/// Returns the cosine of an angle in degrees.
#[must_use]
pub fn cos(degrees: f64) -> f64 {
    sine_of(within_many_turns(degrees), 1)
}

/// Returns the sine and the cosine of an angle in degrees.
#[must_use]
pub fn sin_cos(degrees: f64) -> (f64, f64) {
    sine_and_cosine(within_many_turns(degrees))
}

/// Returns the tangent of an angle in degrees; at odd multiples of 90°, returns ±1.633e16 with the sign of the angle.
#[must_use]
pub fn tan(degrees: f64) -> f64 {
    let (quarters, rest) = reduce(within_many_turns(degrees));
    let (radians, error) = to_radians(rest);
    let tan = libm::tan(radians);
    let tan = tan + error * (1.0 + tan * tan);
    match quarters.to_bits() & 1 {
        0 => tan + 0.0,
        _ if tan == 0.0 => TANGENT_AT_POLE.copysign(degrees),
        _ => -1.0 / tan,
    }
}

/// Returns the angle in [-90, 90] degrees with this sine; `None` for a value outside [-1, 1].
#[must_use]
pub fn asin(value: f64) -> Option<f64> {
    let angle = libm::asin(value).to_degrees();
    (value.abs() <= 1.0).then(|| whole_if(angle, |whole| sin(whole) == value))
}

/// Returns the angle in [0, 180] degrees with this cosine; `None` for a value outside [-1, 1].
#[must_use]
pub fn acos(value: f64) -> Option<f64> {
    let angle = libm::acos(value).to_degrees();
    (value.abs() <= 1.0).then(|| whole_if(angle, |whole| cos(whole) == value))
}

/// Returns the angle in [-90, 90] degrees with this tangent.
#[must_use]
pub fn atan(value: f64) -> f64 {
    whole_if(libm::atan(value).to_degrees(), |whole| tan(whole) == value)
}

/// Returns the angle in ]-180, 180] degrees of the direction (`x`, `y`); 0 if both are 0.
#[must_use]
pub fn atan2(y: f64, x: f64) -> f64 {
    let angle = libm::atan2(y, x).to_degrees() + 0.0;
    if angle == -180.0 { 180.0 } else { angle }
}

/// Returns the nearest whole number of degrees if it is an exact result, otherwise `angle`.
fn whole_if(angle: f64, is_exact: impl Fn(f64) -> bool) -> f64 {
    let whole = angle.round();
    let near = (angle - whole).abs() < 1e-12;
    if near && is_exact(whole) { whole + 0.0 } else { angle + 0.0 }
}

/// Removes whole turns from an angle with very many turns.
fn within_many_turns(degrees: f64) -> f64 {
    if degrees.abs() < MANY_TURNS { degrees } else { degrees % 360.0 }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_1_SQRT_2;

    use proptest::prelude::*;

    use super::*;

    #[test]
    fn the_examples_of_the_manual() {
        assert_eq!(sin(30.0), 0.5);
        assert_eq!(asin(0.5), Some(30.0));
        assert_eq!(cos(60.0), 0.5);
        assert_eq!(acos(0.5), Some(60.0));
        assert_eq!(tan(45.0), 1.0);
        assert_eq!(atan(1.0), 45.0);
    }

    #[test]
    fn quarter_turns_are_exact_and_never_minus_zero() {
        for turns in [-1e9, -7.0, -1.0, 0.0, 1.0, 3.0, 1e9] {
            let values = [0.0, 90.0, 180.0, 270.0].map(|angle| sin_cos(angle + 360.0 * turns));
            assert_eq!(values, [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)]);
            assert!(values.iter().all(|(sin, cos)| [sin, cos].iter().all(|value| value.to_bits() != 1 << 63)));
        }
        assert_eq!(sin(-0.0).to_bits(), 0);
        assert_eq!(tan(-180.0).to_bits(), 0);
        assert_eq!(atan2(-0.0, 1.0).to_bits(), 0);
    }

    #[test]
    fn the_tangent_stays_finite() {
        assert_eq!([90.0, 270.0, 450.0].map(tan), [TANGENT_AT_POLE; 3]);
        assert_eq!(tan(-90.0), -TANGENT_AT_POLE);
    }

    #[test]
    fn outside_of_their_range_arcs_have_no_value() {
        assert_eq!([asin(-1.0), asin(1.0), acos(-1.0), acos(1.0)], [Some(-90.0), Some(90.0), Some(180.0), Some(0.0)]);
        let above = 1.0_f64.next_up();
        assert_eq!([asin(above), asin(-above), acos(above), acos(-above), acos(f64::NAN)], [None; 5]);
    }

    #[test]
    fn directions() {
        let around = [(0.0, 1.0), (1.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-0.0, -1.0), (-1.0, 0.0), (0.0, 0.0)];
        assert_eq!(around.map(|(y, x)| atan2(y, x)), [0.0, 45.0, 90.0, 180.0, 180.0, -90.0, 0.0]);
    }

    #[test]
    fn whole_degrees_come_back() {
        for whole in -90_i8..=90 {
            let angle = f64::from(whole);
            assert_eq!(asin(sin(angle)), Some(angle));
            assert_eq!(acos(cos(angle + 90.0)), Some(angle + 90.0));
            assert!(whole.abs() == 90 || atan(tan(angle)) == angle, "{whole}");
        }
    }

    #[test]
    fn the_bits_are_the_same_everywhere() {
        let bits = [sin(12.3), cos(12.3), tan(12.3), atan(12.3), asin(0.123).unwrap(), acos(0.123).unwrap()];
        let expected = [
            0.21303038627497659,
            0.9770455744352636,
            0.21803526043102855,
            85.35202930861297,
            7.065272930650028,
            82.93472706934998,
        ];
        assert_eq!(bits, expected);
    }

    #[test]
    fn between_two_axes_both_are_equal() {
        for odd in (-99..100).step_by(2) {
            let (sin, cos) = sin_cos(f64::from(odd) * 45.0);
            assert_eq!((sin.abs(), cos.abs()), (FRAC_1_SQRT_2, FRAC_1_SQRT_2), "{odd}");
        }
    }

    proptest! {
        #[test]
        fn a_turn_changes_nothing(quarter_degrees in -100_000_i32..100_000) {
            let angle = f64::from(quarter_degrees) / 4.0;
            prop_assert_eq!(sin_cos(angle), sin_cos(angle + 360.0));
            prop_assert_eq!(sin(angle), cos(angle - 90.0));
            prop_assert_eq!(sin(angle) + 0.0, -sin(-angle) + 0.0);
        }

        #[test]
        fn an_angle_is_reduced_exactly(angle in any::<f64>(), turns in -1_000_000_i32..1_000_000, ulps in -2_i64..3) {
            let near = f64::from(turns) * 45.0;
            let near = f64::from_bits(near.to_bits().wrapping_add_signed(ulps));
            for angle in [angle, near, near / 1024.0].into_iter().filter(|angle| angle.is_finite()) {
                let (quarters, rest) = reduce(within_many_turns(angle));
                prop_assert!(rest.abs() <= 45.000_01, "{angle}: {rest}");
                let left = angle % 90.0;
                prop_assert!([0.0, 90.0, -90.0].iter().any(|quarter| left - quarter == rest), "{angle}: {rest}");
                let turns = (angle % 360.0 - rest - (quarters.to_bits() & 3) as f64 * 90.0) / 360.0;
                prop_assert!((turns - turns.round()).abs() < 1e-9, "{angle}: {quarters}");
            }
        }

        #[test]
        #[expect(clippy::disallowed_methods, reason = "the machine's own, to compare with")]
        fn degrees_agree_with_radians(angle in -720.0..720.0_f64) {
            let (sin, cos) = sin_cos(angle);
            prop_assert!((sin - angle.to_radians().sin()).abs() < 1e-14);
            prop_assert!((cos - angle.to_radians().cos()).abs() < 1e-14);
            prop_assert!((sin * sin + cos * cos - 1.0).abs() < 1e-15);
        }
    }
}
