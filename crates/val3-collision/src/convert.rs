//! Conversion of poses and vectors between `nalgebra` and `parry3d`.

use parry3d_f64::math::{Mat3, Pose, Rotation, Vector};
use val3_geometry::{IsometryMatrix3, Vector3};

pub(crate) fn vector(of: &Vector3<f64>) -> Vector {
    Vector::new(of.x, of.y, of.z)
}

pub(crate) fn back(of: Vector) -> Vector3<f64> {
    Vector3::new(of.x, of.y, of.z)
}

pub(crate) fn pose(of: &IsometryMatrix3<f64>) -> Pose {
    let [x, y, z] = [0, 1, 2].map(|column| vector(&of.rotation.matrix().column(column).into_owned()));
    Pose::from_parts(vector(&of.translation.vector), Rotation::from_mat3(&Mat3::from_cols(x, y, z)))
}
