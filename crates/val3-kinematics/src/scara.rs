//! SCARA arms: forward and inverse kinematics in closed form.

use val3_geometry::{IsometryMatrix3, Rotation3, Vector3, degrees};

use crate::dh::Dh;
use crate::{Configuration, Joints, Shoulder, Unreachable};

/// Tolerance outside of the reach within which a position counts as on the boundary, in mm.
const BOUNDARY: f64 = 1e-10;

/// Length below which a value is noise, in mm.
const NOISE: f64 = 1e-9;

/// Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Scara {
    /// From axis 1 to axis 2.
    pub(crate) l1: f64,
    /// From axis 2 to the stroke.
    pub(crate) l2: f64,
    /// Height of the flange at stroke 0.
    pub(crate) z0: f64,
}

impl Scara {
    /// Computes the flange pose.
    pub(crate) fn forward(&self, &[j1, j2, j3, j4, ..]: &Joints) -> IsometryMatrix3<f64> {
        let (s1, c1) = degrees::sin_cos(j1);
        let (s12, c12) = degrees::sin_cos(j1 + j2);
        let (s, c) = degrees::sin_cos(j1 + j2 - j4);
        let translation = Vector3::new(self.l1 * c1 + self.l2 * c12, self.l1 * s1 + self.l2 * s12, self.z0 + j3);
        let rotation = Rotation3::from_matrix_unchecked([[c, s, 0.0], [s, -c, 0.0], [0.0, 0.0, -1.0]].into());
        IsometryMatrix3::from_parts(translation.into(), rotation)
    }

    /// Returns the configuration of a joint position (manual 9.7.5).
    pub(crate) fn configuration(joints: &Joints) -> Configuration {
        let righty = degrees::sin(joints[1]) > 0.0;
        Configuration::scara(if righty { Shoulder::Righty } else { Shoulder::Lefty })
    }

    /// Computes the joints on one branch, with angles in any turn. `tilt` is the largest sine of the angle between the
    /// flange's z axis and the vertical.
    pub(crate) fn inverse(
        &self,
        branch: Configuration,
        tilt: f64,
        flange: &IsometryMatrix3<f64>,
        near: &Joints,
    ) -> Result<Joints, Unreachable> {
        let m = flange.rotation.matrix();
        let horizontal = (m.m13 * m.m13 + m.m23 * m.m23).sqrt();
        if !(horizontal < tilt && m.m33 < 0.0) {
            return Err(Unreachable::Tilted { angle: degrees::atan2(horizontal, -m.m33) });
        }
        let place = flange.translation.vector;
        let square = place.x * place.x + place.y * place.y;
        let distance = square.sqrt();
        let (min, max) = ((self.l1 - self.l2).abs(), self.l1 + self.l2);
        if !(min - BOUNDARY..=max + BOUNDARY).contains(&distance) {
            return Err(Unreachable::OutOfReach { distance, min, max });
        }
        let cos = ((square - self.l1 * self.l1 - self.l2 * self.l2) / (2.0 * self.l1 * self.l2)).clamp(-1.0, 1.0);
        let sin = match branch.shoulder {
            Shoulder::Righty => ((1.0 - cos) * (1.0 + cos)).sqrt(),
            Shoulder::Lefty => -((1.0 - cos) * (1.0 + cos)).sqrt(),
        };
        let j2 = degrees::atan2(sin, cos);
        let j1 = if distance < NOISE {
            near[0]
        } else {
            degrees::atan2(place.y, place.x) - degrees::atan2(self.l2 * sin, self.l1 + self.l2 * cos)
        };
        let j4 = j1 + j2 - degrees::atan2(m.m21, m.m11);
        Ok([j1, j2, place.z - self.z0, j4, 0.0, 0.0])
    }

    /// Returns the nominal parameters.
    pub(crate) const fn dh(&self) -> Dh {
        Dh {
            theta: [0.0; 6],
            d: [0.0, 0.0, self.z0, 0.0, 0.0, 0.0, 0.0],
            a: [self.l1, self.l2, 0.0, 0.0, 0.0, 0.0],
            b: [0.0; 6],
            alpha: [0.0, 0.0, 180.0, 0.0, 0.0, 0.0],
            beta: [0.0; 6],
        }
    }
}
