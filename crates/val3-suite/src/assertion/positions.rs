//! Describes two different positions: the axes, or distance and rotation, and both positions.

use val3_geometry::Trsf;
use val3_geometry::rotation::angle_between;
use val3_lang::types::{Arm, BaseType, fields};

use super::numbers::{DEGREE, apart, excess, measured, structures_apart};

/// Index of the SCARA axis that is measured in mm.
const SLIDE: usize = 3;

/// Distances and angles up to this value are computation errors, in mm and degrees.
const NOISE: f64 = 1e-9;

/// Number of significant digits for an axis.
const DIGITS: usize = 9;

/// Minimum number of significant digits of a distance or angle.
const DISTANCE_DIGITS: usize = 6;

/// Message for joint positions: the axes that are not within the tolerance, and both positions. `None` if all axes are
/// within the tolerance.
pub(super) fn joints(arm: Option<Arm>, actual: &[f64], expected: &[f64], tolerance: f64) -> Option<String> {
    let axes = fields(BaseType::Joint, arm).len();
    let (actual, expected) = (actual.get(..axes)?, expected.get(..axes)?);
    let mut axes: Vec<String> = Vec::new();
    for ((actual, expected), number) in actual.iter().zip(expected).zip(1..) {
        // False for NaN.
        let is_near = (actual - expected).abs() <= tolerance;
        if !is_near {
            let unit = if arm == Some(Arm::Scara) && number == SLIDE { "mm" } else { DEGREE };
            let (left, right) = apart(*actual, *expected, DIGITS);
            let excess = excess(*actual, *expected, tolerance, unit);
            axes.push(format!("axis {number}: {left} instead of {right}{excess}"));
        }
    }
    (!axes.is_empty()).then(|| axes.join("\n") + &both(actual, expected))
}

/// Message for transformations: distance, rotation, and both values. `None` if the values are no transformations.
pub(super) fn poses(actual: &[f64], expected: &[f64], millimetres: f64, degrees: f64) -> Option<String> {
    let (one, other) = (trsf(actual)?, trsf(expected)?);
    let distance = one.distance(&other);
    let angle = angle_between(&one.isometry().rotation, &other.isometry().rotation).to_degrees();
    let quiet = |value: f64, tolerance: f64| if value <= tolerance.min(NOISE) { 0.0 } else { value };
    let (distance, millimetres) = apart(quiet(distance, millimetres), millimetres, DISTANCE_DIGITS);
    let (angle, degrees) = apart(quiet(angle, degrees), degrees, DISTANCE_DIGITS);
    let (angle, degrees) = (measured(&angle, DEGREE), measured(&degrees, DEGREE));
    let tolerances = format!("tolerances {millimetres} mm and {degrees}");
    Some(format!("{distance} mm and {angle} away, {tolerances}{}", both(actual, expected)))
}

fn trsf(numbers: &[f64]) -> Option<Trsf> {
    let &[x, y, z, rx, ry, rz] = numbers else { return None };
    Some(Trsf { x, y, z, rx, ry, rz })
}

fn both(actual: &[f64], expected: &[f64]) -> String {
    let (actual, expected) = structures_apart(actual, expected);
    sides(&actual, &expected)
}

/// Formats an assertion's sides in two lines.
pub(super) fn sides(actual: &str, expected: &str) -> String {
    format!("\n  actual    {actual}\n  expected  {expected}")
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};

    use super::*;

    fn check(message: Option<String>, expected: Expect) {
        expected.assert_eq(&message.unwrap());
    }

    #[test]
    fn each_axis_beyond_the_tolerance_is_named() {
        check(
            joints(None, &[1.0, 2.5, 3.0, 4.0, 5.0, 6.0], &[1.0, 2.0, 3.0, 4.0, 5.0, 7.0], 0.1),
            expect![[r#"
                axis 2: 2.5 instead of 2 (0.5 degrees away, tolerance 0.1)
                axis 6: 6 instead of 7 (1 degree away, tolerance 0.1)
                  actual    {1,2.5,3,4,5,6}
                  expected  {1,2,3,4,5,7}"#]],
        );
        check(
            joints(Some(Arm::Scara), &[1.0, 2.0, 30.0, 4.0, 0.0, 0.0], &[1.0, 2.0, 30.5, 4.0, 0.0, 0.0], 0.1),
            expect![[r#"
                axis 3: 30 instead of 30.5 (0.5 mm away, tolerance 0.1)
                  actual    {1,2,30,4}
                  expected  {1,2,30.5,4}"#]],
        );
        assert_eq!(joints(None, &[0.0; 6], &[0.0; 6], 0.0), None);
    }

    #[test]
    fn poses_show_distance_rotation_and_both_sides() {
        check(
            poses(&[1.0, 2.0, 3.0, 0.0, 0.0, 0.0], &[1.0, 2.0, 4.0, 0.0, 0.0, 3.0], 0.5, 5.0),
            expect![[r#"
                1 mm and 3 degrees away, tolerances 0.5 mm and 5 degrees
                  actual    {1,2,3,0,0,0}
                  expected  {1,2,4,0,0,3}"#]],
        );
        check(
            poses(&[100.0, 0.0, 0.0, 90.0, 0.0, 0.0], &[100.000_01, 0.0, 0.0, 90.0, 0.0, 0.0], 0.0, 1.0),
            expect![[r#"
                0.00001 mm and 0 degrees away, tolerances 0 mm and 1 degree
                  actual    {100,0,0,90,0,0}
                  expected  {100.00001,0,0,90,0,0}"#]],
        );
    }
}
