//! Instruction `setFrame` (manual 9.4.4).

use std::error::Error;
use std::fmt;

use nalgebra::{Matrix3, Rotation3};

use crate::Trsf;

/// Smallest accepted distance, in mm. The manual specifies none; this is the precision of a position.
const TOO_CLOSE: f64 = 1e-3;

/// Reason why three points define no frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FrameError {
    /// The point on the x axis is too close to the origin: -1 in VAL 3.
    AxisPoint,
    /// The point in the plane is too close to the x axis: -2 in VAL 3.
    PlanePoint,
}

impl fmt::Display for FrameError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::AxisPoint => "the point on the x axis is too close to the origin",
            Self::PlanePoint => "the point in the plane is too close to the x axis",
        })
    }
}

impl Error for FrameError {}

/// Computes the frame with this origin, with `on_x` on the positive x axis and `on_plane` in the xy plane at positive
/// y.
///
/// The points and the result are relative to the same frame. Lengths are in mm, and the orientations of the points have
/// no effect.
///
/// # Errors
/// A point is less than 0.001 mm from the origin, or from the x axis.
pub fn set_frame(origin: &Trsf, on_x: &Trsf, on_plane: &Trsf) -> Result<Trsf, FrameError> {
    let origin = origin.translation();
    let along = on_x.translation() - origin;
    let in_plane = on_plane.translation() - origin;
    let x = along.try_normalize(TOO_CLOSE).ok_or(FrameError::AxisPoint)?;
    let beside = in_plane - x * in_plane.dot(&x);
    let y = beside.try_normalize(TOO_CLOSE).ok_or(FrameError::PlanePoint)?;
    let z = x.cross(&y).normalize();
    let axes = Matrix3::from_columns(&[x, z.cross(&x), z]);
    Ok(Trsf::from_parts(origin, &Rotation3::from_matrix_unchecked(axes)))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::testing::{any_trsf, assert_near};

    fn at(x: f64, y: f64, z: f64) -> Trsf {
        Trsf::new([x, y, z], [12.0, 34.0, 56.0])
    }

    #[test]
    fn three_points_make_a_frame() {
        let frame = set_frame(&at(100.0, 50.0, 10.0), &at(100.0, 80.0, 10.0), &at(60.0, 500.0, 10.0));
        assert_eq!(frame, Ok(Trsf::new([100.0, 50.0, 10.0], [0.0, 0.0, 90.0])));
        let upside_down = set_frame(&at(0.0, 0.0, 0.0), &at(1.0, 0.0, 0.0), &at(-5.0, -1.0, 0.0));
        assert_eq!(upside_down, Ok(Trsf::new([0.0; 3], [180.0, 0.0, 0.0])));
    }

    #[test]
    fn a_point_must_be_a_thousandth_of_a_millimetre_away() {
        let origin = at(100.0, 0.0, 0.0);
        let frame = |on_x: f64, beside: f64| set_frame(&origin, &at(100.0 + on_x, 0.0, 0.0), &at(400.0, beside, 0.0));
        assert_eq!(frame(0.0, 50.0), Err(FrameError::AxisPoint));
        assert_eq!(frame(0.0009, 50.0), Err(FrameError::AxisPoint));
        assert_eq!(frame(0.0011, 0.0009), Err(FrameError::PlanePoint));
        assert_eq!(frame(0.0011, 0.0), Err(FrameError::PlanePoint));
        assert_eq!(frame(0.0011, 0.0011), Ok(Trsf::new([100.0, 0.0, 0.0], [0.0; 3])));
    }

    proptest! {
        #[test]
        fn points_of_a_frame_give_the_frame_back(
            frame in any_trsf(),
            on_x in 0.1..500.0,
            on_plane in (-500.0..500.0, 0.1..500.0),
        ) {
            let point = |x, y| frame * at(x, y, 0.0);
            let found = set_frame(&frame, &point(on_x, 0.0), &point(on_plane.0, on_plane.1));
            let found = found.unwrap();
            prop_assert_eq!(found.translation(), frame.translation());
            let apart = found.isometry().rotation.matrix() - frame.isometry().rotation.matrix();
            prop_assert!(apart.amax() < 1e-8);
            let again = set_frame(&found, &(found * at(1000.0, 0.0, 0.0)), &(found * at(0.0, 1000.0, 0.0)));
            assert_near(&again.unwrap(), &found)?;
        }
    }
}
