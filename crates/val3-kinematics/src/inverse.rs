//! Joint positions of a pose: branches, turns and limits.

use val3_geometry::{IsometryMatrix3, Trsf};

use crate::arm::Geometry;
use crate::{Arm, Configuration, Joints, RequestedConfiguration, Unreachable, calibration, turns};

/// Sine of the tilt that a SCARA arm accepts: what angles with six decimals leave.
const NOMINAL_TILT: f64 = 1e-6;

/// Sine of the tilt that calibration can cause.
const CALIBRATED_TILT: f64 = 0.2;

impl Arm {
    /// The joint position nearest to `near` on one branch (instruction `pointToJoint` with an exact configuration).
    ///
    /// `flange` is the pose of the flange in world. At a singular position the undetermined axis keeps the value of
    /// `near`, and the branches that meet there give the same result.
    pub fn inverse_on(&self, branch: Configuration, flange: &Trsf, near: &Joints) -> Result<Joints, Unreachable> {
        self.inverse_isometry_on(branch, &flange.isometry(), near)
    }

    /// [`Arm::inverse_on`] without the conversion from angles.
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

    /// The joint position nearest to `near` on every branch that reaches `flange`, each branch once.
    pub fn solutions(&self, flange: &IsometryMatrix3<f64>, near: &Joints) -> impl Iterator<Item = Joints> {
        self.branches().iter().filter_map(move |branch| {
            let joints = self.inverse_isometry_on(*branch, flange, near).ok()?;
            (self.configuration(&joints) == *branch).then_some(joints)
        })
    }

    /// The joint position of a Cartesian target for an arm that is at `near` (instruction `pointToJoint`).
    ///
    /// Of several allowed branches the fastest to reach wins: the one with the smallest greatest movement of an axis,
    /// in relation to the axis' nominal speed.
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

    /// The branches of the inverse kinematics, in the order in which equally good ones are preferred.
    #[must_use]
    pub fn branches(&self) -> &'static [Configuration] {
        match self.geometry {
            Geometry::SixAxis(_) => &Configuration::SIX_AXIS,
            Geometry::Scara(_) => &Configuration::SCARA,
        }
    }

    /// The tilt of a SCARA arm's flange that is accepted, as a sine. Calibration may tilt the flange.
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

    /// Each axis in the turn nearest to `near` within its limits.
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
                Unreachable::Limit { axis: index + 1, position, min: axis.min, max: axis.max }
            })?;
        }
        Ok(result)
    }

    /// The seconds that the slowest axis needs at its nominal speed.
    fn travel_time(&self, from: &Joints, to: &Joints) -> f64 {
        let times =
            from.iter().zip(to).zip(self.limits()).map(|((from, to), axis)| (to - from).abs() / axis.nominal_speed);
        times.fold(0.0, f64::max)
    }
}
