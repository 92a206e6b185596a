//! Arm model for the planner: axes as one vector, and inverse kinematics along a path.

use nalgebra::SVector;
use val3_geometry::IsometryMatrix3;
use val3_kinematics::{Arm, Configuration, Joints, RequestedConfiguration, Unreachable, Violation};

use crate::fault::Cause;

/// Joint positions in degrees (linear axes: mm); 0 for axes that the arm does not have.
pub(crate) type Axes = SVector<f64, 6>;

/// Full turns by which the axes differ between two positions, in degrees.
pub(crate) fn full_turns(before: &Axes, after: &Axes) -> Axes {
    (after - before).map(|way| (way / 360.0).round() * 360.0)
}

/// Arm model.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Model<'a>(pub(crate) &'a Arm);

impl Model<'_> {
    /// Pose of the flange in `world`.
    pub(crate) fn flange(&self, axes: &Axes) -> IsometryMatrix3<f64> {
        self.0.flange(&(*axes).into())
    }

    pub(crate) fn configuration(&self, axes: &Axes) -> Configuration {
        self.0.configuration(&(*axes).into())
    }

    /// Axes for a flange pose on one branch, each with the turn nearest to `near`.
    pub(crate) fn axes_near(
        &self,
        branch: Configuration,
        flange: &IsometryMatrix3<f64>,
        near: &Axes,
    ) -> Result<Axes, Cause> {
        Ok(self.0.inverse_isometry_on(branch, flange, &(*near).into())?.into())
    }

    /// Minimum and maximum axis positions.
    pub(crate) fn limits(&self) -> [Axes; 2] {
        let mut limits = [Axes::repeat(f64::NEG_INFINITY), Axes::repeat(f64::INFINITY)];
        let [least, most] = &mut limits;
        for ((least, most), axis) in least.iter_mut().zip(most.iter_mut()).zip(self.0.limits()) {
            (*least, *most) = (axis.min, axis.max);
        }
        limits
    }

    /// First axis beyond its limit at a position; `None` if all axes are within their limits.
    pub(crate) fn beyond_limit(&self, axes: &Axes) -> Option<Cause> {
        let Violation { axis, position, min, max, unit } = self.0.violations(&(*axes).into()).next()?;
        Some(Cause::Unreachable(Unreachable::Limit { axis, position, min, max, unit }))
    }

    /// First axis that would exceed its limit without its full turn between two neighbouring path positions; `None`
    /// without such an axis.
    pub(crate) fn limit_behind_turn(&self, before: &Axes, after: &Axes) -> Option<Cause> {
        let turns = full_turns(before, after);
        if turns.amax() > 0.0 { self.beyond_limit(&(after - turns)) } else { None }
    }

    /// Checks that the arm can reach the intermediate point of a circle in any configuration (manual 10.1.4.2). The
    /// cause in an error refers to the configuration at `near`, which the circle keeps.
    pub(crate) fn check_intermediate(&self, flange: &IsometryMatrix3<f64>, near: &Axes) -> Result<(), Cause> {
        let joints: Joints = (*near).into();
        let Err(any) = self.0.solve(&(*flange).into(), &joints, RequestedConfiguration::FREE) else { return Ok(()) };
        let kept = self.0.inverse_isometry_on(self.configuration(near), flange, &joints).err();
        Err(Cause::Intermediate(kept.unwrap_or(any)))
    }

    /// Converts a joint position to axes, and rejects positions outside of the arm's limits.
    pub(crate) fn in_range(&self, joints: &Joints) -> Result<Axes, Cause> {
        match self.0.violations(joints).next() {
            Some(violation) => Err(Cause::OutOfRange(violation)),
            None => Ok((*joints).into()),
        }
    }
}
