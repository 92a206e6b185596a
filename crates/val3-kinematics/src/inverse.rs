//! Inverse kinematics: branches, turns and limits.

use val3_geometry::{IsometryMatrix3, Trsf};

use crate::arm::Geometry;
use crate::{Arm, Configuration, Joints, RequestedConfiguration, Unreachable, calibration, turns};

/// Largest accepted tilt of a SCARA arm's flange, as a sine. It covers angles that are rounded to six decimals.
const NOMINAL_TILT: f64 = 1e-6;

/// Largest tilt that calibration can cause, as a sine.
const CALIBRATED_TILT: f64 = 0.2;

impl Arm {
    /// Computes the joint position nearest to `near` on one branch (instruction `pointToJoint` with an exact
    /// configuration).
    ///
    /// `flange` is the flange pose in world. At a singular position the undetermined axis keeps the value in `near`,
    /// and the branches that meet there have the same result.
    pub fn inverse_on(&self, branch: Configuration, flange: &Trsf, near: &Joints) -> Result<Joints, Unreachable> {
        self.inverse_isometry_on(branch, &flange.isometry(), near)
    }

    /// Like [`Arm::inverse_on`], without the conversion from angles.
    pub fn inverse_isometry_on(
        &self,
        branch: Configuration,
        flange: &IsometryMatrix3<f64>,
        near: &Joints,
    ) -> Result<Joints, Unreachable> {
        let joints = match &self.geometry {
            Geometry::SixAxis(geometry) => geometry.inverse(branch, flange, near),
            Geometry::Scara(geometry) => geometry.inverse(branch, self.tilt_tolerance(), flange, near),
        }?;
        let joints = if self.is_calibrated() { calibration::refine(self, flange, joints)? } else { joints };
        self.nearest_turns(joints, near)
    }

    /// Computes the joint position nearest to `near` on every branch that reaches `flange`, without duplicates.
    pub fn solutions(&self, flange: &IsometryMatrix3<f64>, near: &Joints) -> impl Iterator<Item = Joints> {
        self.branches().iter().filter_map(move |branch| {
            let joints = self.inverse_isometry_on(*branch, flange, near).ok()?;
            (self.configuration(&joints) == *branch).then_some(joints)
        })
    }

    /// Computes the joint position of a Cartesian target for an arm at `near` (instruction `pointToJoint`).
    ///
    /// Among several allowed branches, the fastest one is chosen: the branch on which the largest axis movement,
    /// relative to the nominal speed of that axis, is smallest.
    pub fn solve(
        &self,
        flange: &Trsf,
        near: &Joints,
        requested: RequestedConfiguration,
    ) -> Result<Joints, Unreachable> {
        let start = self.configuration(near);
        let flange = flange.isometry();
        let mut best: Option<(f64, Joints)> = None;
        let mut reason: Option<Unreachable> = None;
        for branch in self.branches().iter().filter(|branch| self.allows(&requested, **branch, start)) {
            match self.inverse_isometry_on(*branch, &flange, near) {
                Ok(joints) => {
                    let time = self.travel_time(near, &joints);
                    if best.is_none_or(|(least, _)| time < least) {
                        best = Some((time, joints));
                    }
                }
                Err(other) if reason.is_none_or(|reason| reason.progress() < other.progress()) => reason = Some(other),
                Err(_) => {}
            }
        }
        best.map(|(_, joints)| joints).ok_or_else(|| reason.unwrap_or(Unreachable::NotConverged))
    }

    /// Returns the branches of the inverse kinematics. Among equally good branches, the first one is preferred.
    #[must_use]
    pub fn branches(&self) -> &'static [Configuration] {
        match self.geometry {
            Geometry::SixAxis(_) => &Configuration::SIX_AXIS,
            Geometry::Scara(_) => &Configuration::SCARA,
        }
    }

    /// Returns the largest accepted tilt of a SCARA arm's flange, as a sine. Calibration may tilt the flange.
    const fn tilt_tolerance(&self) -> f64 {
        if self.is_calibrated() { CALIBRATED_TILT } else { NOMINAL_TILT }
    }

    fn allows(&self, requested: &RequestedConfiguration, end: Configuration, start: Configuration) -> bool {
        match self.geometry {
            Geometry::SixAxis(_) => requested.allows(end, start),
            Geometry::Scara(_) => {
                RequestedConfiguration { shoulder: requested.shoulder, ..Default::default() }.allows(end, start)
            }
        }
    }

    /// Shifts each axis to the turn nearest to `near` within its limits.
    fn nearest_turns(&self, joints: Joints, near: &Joints) -> Result<Joints, Unreachable> {
        let mut result = joints;
        for (index, ((joint, near), axis)) in result.iter_mut().zip(near).zip(self.limits()).enumerate() {
            let found = if self.is_stroke(index) {
                turns::clamped(*joint, axis)
            } else {
                turns::nearest_within(*joint, *near, axis)
            };
            *joint = found.ok_or_else(|| {
                let position = if self.is_stroke(index) { *joint } else { turns::nearest(*joint, *near) };
                Unreachable::Limit { axis: index + 1, position, min: axis.min, max: axis.max, unit: self.unit(index) }
            })?;
        }
        Ok(result)
    }

    /// Returns the time of the slowest axis at nominal speed, in s.
    fn travel_time(&self, from: &Joints, to: &Joints) -> f64 {
        let times =
            from.iter().zip(to).zip(self.limits()).map(|((from, to), axis)| (to - from).abs() / axis.nominal_speed);
        times.fold(0.0, f64::max)
    }
}
