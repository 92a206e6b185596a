//! Conversion between a rotation and its angles `rx`, `ry`, `rz` (manual 9.3.2).

use nalgebra::{Matrix3, Rotation3};

use crate::degrees;

/// Cosine of `ry` below which the z axis counts as rotated onto the x axis.
const POLE: f64 = 1e-12;

/// Distance to `rx` = 180° and `ry` = 0, in degrees, within which this form of the angles is kept.
///
/// Recorded positions limit it: 7e-15 keeps the form, 1.1e-5 does not.
const HALF_TURN: f64 = 1e-7;

/// Approximate error of computed angles, in degrees.
const NOISE: f64 = 1e-13;

/// Returns Rx(rx)·Ry(ry)·Rz(rz): about x, then about the new y, then about the new z.
pub(crate) fn to_rotation([rx, ry, rz]: [f64; 3]) -> Rotation3<f64> {
    let (sx, cx) = degrees::sin_cos(rx);
    let (sy, cy) = degrees::sin_cos(ry);
    let (sz, cz) = degrees::sin_cos(rz);
    Rotation3::from_matrix_unchecked(Matrix3::new(
        cy * cz,
        -cy * sz,
        sy,
        cx * sz + sx * sy * cz,
        cx * cz - sx * sy * sz,
        -sx * cy,
        sx * sz - cx * sy * cz,
        sx * cz + cx * sy * sz,
        cx * cy,
    ))
}

/// Returns the angles as the controller computes them, each in ]-180, 180].
///
/// At least two are in [-90, 90], unless `rx` is 180 and `ry` is 0; `rx` is 0 if `ry` is ±90.
pub(crate) fn from_rotation(rotation: &Rotation3<f64>) -> [f64; 3] {
    fold(standard(rotation))
}

/// Returns the angles with `ry` in [-90, 90].
///
/// `rz` is computed from the rotation that remains after `rx` is undone, so that both together are correct even near
/// `ry` = ±90, where noise dominates each of them.
fn standard(rotation: &Rotation3<f64>) -> [f64; 3] {
    let m = rotation.matrix();
    let (sin, cos) = (-m.m23, m.m33);
    let cos_ry = (sin * sin + cos * cos).sqrt();
    let at_pole = cos_ry < POLE;
    let (sin, cos) = if at_pole { (0.0, 1.0) } else { (sin / cos_ry, cos / cos_ry) };
    let ry = if at_pole { 90.0_f64.copysign(m.m13) } else { degrees::atan2(m.m13, cos_ry) };
    let rz = degrees::atan2(cos * m.m21 + sin * m.m31, cos * m.m22 + sin * m.m32);
    [degrees::atan2(sin, cos), ry, rz].map(denoise)
}

/// Returns the alternative angles of the same rotation if two of them are then in [-90, 90].
fn fold([rx, ry, rz]: [f64; 3]) -> [f64; 3] {
    let half_turn = 180.0 - rx.abs() < HALF_TURN && ry.abs() < HALF_TURN;
    if rx.abs() <= 90.0 || rz.abs() <= 90.0 || half_turn {
        return [rx, ry, rz];
    }
    [opposite(rx), opposite(-ry), opposite(rz)].map(denoise)
}

/// Returns the angle half a turn further.
fn opposite(angle: f64) -> f64 {
    if angle > 0.0 { angle - 180.0 } else { angle + 180.0 }
}

/// Rounds an angle to six decimals if it differs from the rounded value only by noise. The result is never -0 or -180.
///
/// Data files contain six decimals, so `{0,0,0,30,0,0} * {0,0,0,12.5,0,0}` contains 42.5.
fn denoise(angle: f64) -> f64 {
    let decimal = (angle * 1e6).round() / 1e6;
    let angle = if (angle - decimal).abs() < NOISE { decimal + 0.0 } else { angle };
    if angle == -180.0 { 180.0 } else { angle }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn canonical(angles: [f64; 3]) -> [f64; 3] {
        from_rotation(&to_rotation(angles))
    }

    /// Angles that controllers have written to public data files.
    #[test]
    fn recorded_angles_stay_to_the_bit() {
        for recorded in [
            [180.0, 0.0, 179.271431],
            [0.000023, 179.999989, -0.72807],
            [-4.959689, 154.036634, -5.509255],
            [179.996232, -0.000856, -80.194499],
        ] {
            assert_eq!(canonical(recorded), recorded);
        }
    }

    #[test]
    fn the_form_is_kept_at_a_half_turn_about_x_alone() {
        assert_eq!(canonical([180.0, 7e-15, 179.271431]), [180.0, 0.0, 179.271431]);
        assert_eq!(canonical([180.0, 1.1e-5, 179.271431]), [0.0, 179.999989, -0.728569]);
        assert_eq!(canonical([-180.0, 0.0, -180.0]), [180.0, 0.0, 180.0]);
    }

    #[test]
    fn two_angles_are_within_a_quarter_turn() {
        assert_eq!(canonical([120.0, 10.0, 135.0]), [-60.0, 170.0, -45.0]);
        assert_eq!(canonical([-120.0, -10.0, 135.0]), [60.0, -170.0, -45.0]);
        assert_eq!(canonical([120.0, 10.0, 90.0]), [120.0, 10.0, 90.0]);
        assert_eq!(canonical([0.0, 180.0, 30.0]), [180.0, 0.0, -150.0]);
        assert_eq!(canonical([1.0, 180.0, 30.0]), [1.0, 180.0, 30.0]);
    }

    #[test]
    fn with_z_on_x_all_of_the_turn_is_rz() {
        assert_eq!(canonical([20.0, 90.0, 30.0]), [0.0, 90.0, 50.0]);
        assert_eq!(canonical([20.0, -90.0, 30.0]), [0.0, -90.0, 10.0]);
        assert_eq!(canonical([170.0, 90.0, 30.0]), [0.0, 90.0, -160.0]);
    }

    #[test]
    fn angles_count_modulo_360() {
        assert_eq!(canonical([380.0, -350.0, 750.0]), [20.0, 10.0, 30.0]);
        assert_eq!(canonical([-0.0, -0.0, -360.0]).map(f64::to_bits), [0; 3]);
    }

    fn angle() -> impl Strategy<Value = f64> {
        let quarter = (-4..=4).prop_map(|quarters| f64::from(quarters) * 90.0);
        let near_quarter = (quarter.clone(), -15..-3).prop_map(|(angle, tenth)| angle + 10.0_f64.powi(tenth));
        prop_oneof![quarter, near_quarter, -400.0..400.0]
    }

    proptest! {
        #[test]
        fn the_rotation_is_kept(angles in [angle(), angle(), angle()]) {
            let rotation = to_rotation(angles);
            let again = to_rotation(from_rotation(&rotation));
            prop_assert!((rotation.matrix() - again.matrix()).amax() < 5e-12);
        }

        #[test]
        fn the_form_is_the_manuals(angles in [angle(), angle(), angle()]) {
            let [rx, ry, rz] = canonical(angles);
            prop_assert!([rx, ry, rz].iter().all(|angle| -180.0 < *angle && *angle <= 180.0));
            let small = [rx, ry, rz].iter().filter(|angle| angle.abs() <= 90.0).count();
            let half_turn = 180.0 - rx.abs() < HALF_TURN && ry.abs() < HALF_TURN;
            prop_assert!(small >= 2 || half_turn);
            prop_assert!(ry.abs() != 90.0 || rx == 0.0);
        }

        #[test]
        fn the_form_of_the_form_is_itself(rx in -90_000_000..=90_000_000_i32, ry in -80_000_000..=80_000_000_i32, rz in -180_000_000..=180_000_000_i32) {
            let angles = [rx, ry, rz].map(|millionths| denoise(f64::from(millionths) / 1e6));
            prop_assert_eq!(canonical(angles), angles);
        }
    }
}
