//! Six-axis arms with a spherical wrist: forward and inverse kinematics in closed form.

use val3_geometry::{IsometryMatrix3, Rotation3, Vector3, degrees};

use crate::dh::Dh;
use crate::{Configuration, Elbow, Joints, Shoulder, Unreachable, Wrist};

/// Length below which a value is noise, in mm.
const NOISE: f64 = 1e-9;

/// Tolerance outside of the reach within which a position counts as on the boundary, in mm.
const BOUNDARY: f64 = 1e-10;

/// Sine of axis 5 below which axes 4 and 6 are in line.
const IN_LINE: f64 = 1e-10;

/// Lengths in mm, named as in the literature on this kind of arm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SixAxis {
    /// From axis 1 to axis 2, along x.
    pub(crate) a1: f64,
    /// From the plane of axis 1 to the plane of the wrist, along y.
    pub(crate) b: f64,
    /// From axis 2 to axis 3.
    pub(crate) c2: f64,
    /// From axis 3 to the centre of the wrist.
    pub(crate) c3: f64,
    /// From the centre of the wrist to the flange.
    pub(crate) c4: f64,
}

/// Axes 1 to 3, and the directions of the arm plane and of the forearm in this plane.
struct ForearmPlacement {
    joints: [f64; 3],
    plane: Direction,
    forearm: Direction,
}

/// A direction as sine and cosine.
#[derive(Clone, Copy)]
struct Direction {
    sin: f64,
    cos: f64,
}

impl Direction {
    fn of(degrees: f64) -> Self {
        let (sin, cos) = degrees::sin_cos(degrees);
        Self { sin, cos }
    }

    /// Returns the direction of a vector, with its angle in degrees; 0° for a vector without length.
    ///
    /// Sine and cosine are computed without the angle, which is faster than computing them from it.
    fn towards(y: f64, x: f64) -> (Self, f64) {
        let length = (x * x + y * y).sqrt();
        if length == 0.0 {
            return (Self { sin: 0.0, cos: 1.0 }, 0.0);
        }
        (Self { sin: y / length, cos: x / length }, degrees::atan2(y, x))
    }

    fn plus(self, other: Self) -> Self {
        Self { sin: self.sin * other.cos + self.cos * other.sin, cos: self.cos * other.cos - self.sin * other.sin }
    }
}

impl SixAxis {
    /// Computes the flange pose.
    pub(crate) fn forward(&self, &[j1, j2, j3, j4, j5, j6]: &Joints) -> IsometryMatrix3<f64> {
        let plane @ Direction { sin: s1, cos: c1 } = Direction::of(j1);
        let (s2, c2) = degrees::sin_cos(j2);
        let forearm @ Direction { sin: s23, cos: c23 } = Direction::of(j2 + j3);
        let rotation = turn(plane, forearm) * wrist(j4, j5, j6);
        let radial = self.a1 + self.c2 * s2 + self.c3 * s23;
        let centre = Vector3::new(radial * c1 - self.b * s1, radial * s1 + self.b * c1, self.c2 * c2 + self.c3 * c23);
        let z = rotation.matrix().column(2) * self.c4;
        IsometryMatrix3::from_parts((centre + z).into(), rotation)
    }

    /// Returns the configuration of a joint position (manual 9.7.4).
    pub(crate) fn configuration(&self, &[_, j2, j3, _, j5, _]: &Joints) -> Configuration {
        let radial = self.a1 + self.c2 * degrees::sin(j2) + self.c3 * degrees::sin(j2 + j3);
        Configuration {
            shoulder: if radial < -NOISE { Shoulder::Righty } else { Shoulder::Lefty },
            elbow: if j3 < 0.0 { Elbow::Negative } else { Elbow::Positive },
            wrist: if j5 < 0.0 { Wrist::Negative } else { Wrist::Positive },
        }
    }

    /// Computes the joints on one branch, with angles in any turn. At singular positions the undetermined axis keeps
    /// the value in `near`.
    pub(crate) fn inverse(
        &self,
        branch: Configuration,
        flange: &IsometryMatrix3<f64>,
        near: &Joints,
    ) -> Result<Joints, Unreachable> {
        let place = self.place(branch, flange, near)?;
        let wrist = turn(place.plane, place.forearm).inverse() * flange.rotation;
        let [j4, j5, j6] = wrist_angles(&wrist, branch.wrist, near);
        let [j1, j2, j3] = place.joints;
        Ok([j1, j2, j3, j4, j5, j6])
    }

    /// Computes axes 1 to 3, which determine the centre of the wrist.
    fn place(
        &self,
        branch: Configuration,
        flange: &IsometryMatrix3<f64>,
        near: &Joints,
    ) -> Result<ForearmPlacement, Unreachable> {
        let centre = flange.translation.vector - flange.rotation.matrix().column(2) * self.c4;
        let square = centre.x * centre.x + centre.y * centre.y;
        let distance = square.sqrt();
        let radius = self.b.abs();
        if distance < radius - BOUNDARY {
            return Err(Unreachable::InsideCylinder { distance, radius });
        }
        let length = ((distance - radius) * (distance + radius)).max(0.0).sqrt();
        let radial = match branch.shoulder {
            Shoulder::Lefty => length,
            Shoulder::Righty => -length,
        };
        let (plane, j1) = if distance < NOISE {
            (Direction::of(near[0]), near[0])
        } else {
            // The direction of the centre minus the direction of (radial, b).
            Direction::towards(centre.y * radial - centre.x * self.b, centre.x * radial + centre.y * self.b)
        };
        let (upper, j2, elbow, j3) = self.fold(branch.elbow, radial - self.a1, centre.z)?;
        Ok(ForearmPlacement { joints: [j1, j2, j3], plane, forearm: upper.plus(elbow) })
    }

    /// Computes axes 2 and 3 for a wrist centre at (`x`, `z`) relative to axis 2, in the arm plane.
    fn fold(&self, elbow: Elbow, x: f64, z: f64) -> Result<(Direction, f64, Direction, f64), Unreachable> {
        let square = x * x + z * z;
        let distance = square.sqrt();
        let (min, max) = ((self.c2 - self.c3).abs(), self.c2 + self.c3);
        if !(min - BOUNDARY..=max + BOUNDARY).contains(&distance) {
            return Err(Unreachable::OutOfReach { distance, min, max });
        }
        let cos = ((square - self.c2 * self.c2 - self.c3 * self.c3) / (2.0 * self.c2 * self.c3)).clamp(-1.0, 1.0);
        let sin = match elbow {
            Elbow::Positive => ((1.0 - cos) * (1.0 + cos)).sqrt(),
            Elbow::Negative => -((1.0 - cos) * (1.0 + cos)).sqrt(),
        };
        let (along, across) = (self.c2 + self.c3 * cos, self.c3 * sin);
        let (upper, j2) = Direction::towards(x * along - z * across, z * along + x * across);
        Ok((upper, j2, Direction { sin, cos }, degrees::atan2(sin, cos)))
    }

    /// Returns the nominal parameters, in the convention of the controller.
    pub(crate) fn dh(&self) -> Dh {
        Dh {
            theta: [0.0, -90.0, 90.0, 0.0, 0.0, 0.0],
            d: [0.0, 0.0, self.b, self.c3, 0.0, self.c4, 0.0],
            a: [self.a1, self.c2, 0.0, 0.0, 0.0, 0.0],
            b: [0.0; 6],
            alpha: [-90.0, 0.0, 90.0, -90.0, 90.0, 0.0],
            beta: [0.0; 6],
        }
    }
}

/// Returns Rz(1)·Ry(2+3).
fn turn(Direction { sin: s1, cos: c1 }: Direction, Direction { sin: s23, cos: c23 }: Direction) -> Rotation3<f64> {
    Rotation3::from_matrix_unchecked([[c1 * c23, s1 * c23, -s23], [-s1, c1, 0.0], [c1 * s23, s1 * s23, c23]].into())
}

/// Returns Rz(4)·Ry(5)·Rz(6).
fn wrist(j4: f64, j5: f64, j6: f64) -> Rotation3<f64> {
    let (s4, c4) = degrees::sin_cos(j4);
    let (s5, c5) = degrees::sin_cos(j5);
    let (s6, c6) = degrees::sin_cos(j6);
    Rotation3::from_matrix_unchecked(
        [
            [c4 * c5 * c6 - s4 * s6, s4 * c5 * c6 + c4 * s6, -s5 * c6],
            [-c4 * c5 * s6 - s4 * c6, -s4 * c5 * s6 + c4 * c6, s5 * s6],
            [c4 * s5, s4 * s5, c5],
        ]
        .into(),
    )
}

/// Returns the angles in Rz(4)·Ry(5)·Rz(6).
fn wrist_angles(rotation: &Rotation3<f64>, branch: Wrist, near: &Joints) -> [f64; 3] {
    let m = rotation.matrix();
    let sin = (m.m13 * m.m13 + m.m23 * m.m23).sqrt();
    if sin < IN_LINE {
        let j4 = near[3];
        return if m.m33 > 0.0 {
            [j4, 0.0, degrees::atan2(m.m21, m.m11) - j4]
        } else {
            [j4, 180.0, degrees::atan2(m.m21, -m.m11) + j4]
        };
    }
    let sign = match branch {
        Wrist::Positive => 1.0,
        Wrist::Negative => -1.0,
    };
    let j4 = degrees::atan2(sign * m.m23, sign * m.m13);
    [j4, degrees::atan2(sign * sin, m.m33), degrees::atan2(sign * m.m32, -sign * m.m31)]
}
