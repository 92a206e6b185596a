//! Tool centre point from positions of the flange in which the tip of the tool touches the same place.

use std::error::Error;
use std::fmt;

use nalgebra::{IsometryMatrix3, Matrix3, Vector3};

/// Smallest number of positions.
const POSITIONS: usize = 4;

/// Difference between the rotation matrices (Frobenius norm) of orientations that are 5 degrees apart.
const SAME_ORIENTATION: f64 = 0.123_37;

/// Largest factor by which errors of the positions may be enlarged in the tool centre point.
const LARGEST_FACTOR: f64 = 10.0;

/// Tool centre point, as computed from positions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolCentre {
    /// Tool centre point relative to the flange, in mm.
    pub centre: Vector3<f64>,
    /// Largest distance of the tip from the touched place, in mm.
    pub residual: f64,
}

/// Reason why positions define no tool centre point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ToolCentreError {
    /// There are fewer than four positions.
    TooFew,
    /// Two positions (from 1) have orientations less than 5 degrees apart.
    SameOrientation(usize, usize),
    /// The orientations determine the point in some direction only.
    OneAxis,
}

impl fmt::Display for ToolCentreError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFew => f.write_str("a tool needs at least four positions"),
            Self::SameOrientation(first, second) => {
                write!(f, "the orientations of positions {first} and {second} are less than 5 degrees apart")
            }
            Self::OneAxis => f.write_str("the positions must turn the flange about at least two axes, and farther"),
        }
    }
}

impl Error for ToolCentreError {}

/// Computes the tool centre point by least squares from poses of the flange in which the tip touches the same place.
///
/// # Errors
/// There are fewer than four poses, or their orientations are too similar.
pub fn tool_centre(flanges: &[IsometryMatrix3<f64>]) -> Result<ToolCentre, ToolCentreError> {
    if flanges.len() < POSITIONS {
        return Err(ToolCentreError::TooFew);
    }
    check_orientations(flanges)?;
    #[expect(clippy::cast_precision_loss, reason = "few positions")]
    let share = 1.0 / flanges.len() as f64;
    let rotation = flanges.iter().map(rotation_of).sum::<Matrix3<f64>>() * share;
    let position = flanges.iter().map(position_of).sum::<Vector3<f64>>() * share;
    // The touched place is the mean of all tips, so that only the tool centre point is unknown.
    let mut normal = Matrix3::zeros();
    let mut right = Vector3::zeros();
    for flange in flanges {
        let turned = rotation_of(flange) - rotation;
        normal += turned.transpose() * turned;
        right -= turned.transpose() * (position_of(flange) - position);
    }
    if normal.symmetric_eigenvalues().min() < 1.0 / (LARGEST_FACTOR * LARGEST_FACTOR) {
        return Err(ToolCentreError::OneAxis);
    }
    let inverse = normal.try_inverse().ok_or(ToolCentreError::OneAxis)?;
    let centre = inverse * right;
    let place = rotation * centre + position;
    let distances = flanges.iter().map(|flange| (rotation_of(flange) * centre + position_of(flange) - place).norm());
    Ok(ToolCentre { centre, residual: distances.fold(0.0, f64::max) })
}

fn check_orientations(flanges: &[IsometryMatrix3<f64>]) -> Result<(), ToolCentreError> {
    for (second, flange) in flanges.iter().enumerate() {
        let is_same = |other| (rotation_of(flange) - rotation_of(other)).norm() < SAME_ORIENTATION;
        if let Some(first) = flanges.iter().take(second).position(is_same) {
            return Err(ToolCentreError::SameOrientation(first + 1, second + 1));
        }
    }
    Ok(())
}

fn rotation_of(flange: &IsometryMatrix3<f64>) -> Matrix3<f64> {
    *flange.rotation.matrix()
}

fn position_of(flange: &IsometryMatrix3<f64>) -> Vector3<f64> {
    flange.translation.vector
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::Trsf;

    /// Flange poses in which a tip touches a place.
    fn touching(tip: Vector3<f64>, angles: &[[f64; 3]]) -> Vec<IsometryMatrix3<f64>> {
        let place = Vector3::new(500.0, -100.0, 300.0);
        let pose = |angles: &[f64; 3]| {
            let mut flange = Trsf::new([0.0; 3], *angles).isometry();
            flange.translation.vector = place - flange.rotation * tip;
            flange
        };
        angles.iter().map(pose).collect()
    }

    #[test]
    fn positions_need_different_orientations_about_two_axes() {
        let tip = Vector3::new(10.0, 20.0, 150.0);
        let found = |angles: &[[f64; 3]]| tool_centre(&touching(tip, angles));
        let tilted = [[0.0; 3], [20.0, 0.0, 0.0], [-20.0, 0.0, 0.0], [0.0, 20.0, 0.0]];
        assert_eq!(found(&tilted[..3]), Err(ToolCentreError::TooFew));
        assert!((found(&tilted).unwrap().centre - tip).norm() < 1e-9);
        let near = [tilted[0], tilted[1], [0.0, 4.9, 0.0], tilted[3]];
        assert_eq!(found(&near), Err(ToolCentreError::SameOrientation(1, 3)));
        let about_x = [tilted[0], tilted[1], tilted[2], [60.0, 0.0, 0.0]];
        assert_eq!(found(&about_x), Err(ToolCentreError::OneAxis));
    }

    #[test]
    fn the_residual_is_the_largest_distance_of_the_tip() {
        let angles = [[30.0, 0.0, 0.0], [-30.0, 0.0, 0.0], [0.0, 30.0, 0.0], [0.0, -30.0, 0.0]];
        let mut flanges = touching(Vector3::new(0.0, 0.0, 100.0), &angles);
        assert!(tool_centre(&flanges).unwrap().residual < 1e-9);
        flanges[0].translation.vector.x += 1.0;
        let residual = tool_centre(&flanges).unwrap().residual;
        assert!((0.2..1.0).contains(&residual), "{residual}");
    }

    proptest! {
        #[test]
        fn touching_positions_give_the_tip_back(
            tip in prop::array::uniform3(-300.0..300.0_f64),
            angles in prop::collection::vec(prop::array::uniform3(-170.0..170.0_f64), 4..8),
        ) {
            let tip = Vector3::from(tip);
            if let Ok(ToolCentre { centre, residual }) = tool_centre(&touching(tip, &angles)) {
                prop_assert!((centre - tip).norm() < 1e-8 && residual < 1e-8, "{} {}", centre, residual);
            }
        }
    }
}
