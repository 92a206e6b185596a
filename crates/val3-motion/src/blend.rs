//! Blend curve between two segments: section (a) of the motion model, [ADR 18](../../../docs/adr/0018-blends.md).
//!
//! Each end of a blend continues its own segment. The rate at an end is twice the rate at which the blend would cover
//! the rest of the segment up to the corner, so the shape at one end does not depend on the distance at the other end.

use std::f64::consts::PI;
use std::sync::Arc;

use nalgebra::{Translation3, Vector3};
use val3_geometry::{IsometryMatrix3, Rotation3, degrees, rotation};
use val3_kinematics::Configuration;

use crate::biarc::{Biarc, BiarcEnd};
use crate::fault::Cause;
use crate::hull::Hull;
use crate::model::{Axes, Model};
use crate::quintic::{Jet, Quintic, bezier};
use crate::segment::{Course, IN_PLACE, Segment};

/// Change of orientation, in degrees, from which a Cartesian blend is ambiguous (manual 10.1.2.3).
const HALF_TURN: f64 = 180.0 - 0.01;

/// Turn, in degrees, up to which a Cartesian blend consists only of arcs.
const ROUND_TURN: f64 = 100.0;

/// Turn, in degrees, from which a Cartesian blend has no arcs.
const SHARP_TURN: f64 = 140.0;

/// Cosine of the greatest angle between the direction at an end of the arcs and the direction to the corner: 45°, as
/// for a quarter circle.
const LEAST_FORWARD: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// Length in u below which the turning part at an end of a joint blend has its own knots.
const SHORT_END: f64 = 0.3;

/// Tolerance within which an axis beyond its limit counts as at the limit, in degrees or mm.
const ROUNDING: f64 = 1e-6;

/// Number of points per segment at which the change of orientation is checked.
const ORIENTATIONS: u32 = 32;

/// Curve from a segment's leave point to the next segment's reach point, by u from 0 to 1.
#[derive(Clone, Debug)]
pub(crate) enum BlendCurve {
    Joint(Box<Quintic<6>>),
    Pose(Box<PoseBlend>),
    /// The nominal path on one side of the corner, if the other distance is 0. The arm stops at the corner.
    Nominal(Box<BlendEnd>),
}

/// Cartesian blend.
#[derive(Clone, Debug)]
pub(crate) struct PoseBlend {
    ends: [BlendEnd; 2],
    corner: IsometryMatrix3<f64>,
    /// Rates at both ends, relative to the rates of the segments up to the corner.
    rate: f64,
    arcs: Option<ArcPath>,
    branch: Configuration,
    /// Axes at both ends, bit-identical to the axes of the segments.
    axes: [Axes; 2],
}

/// Position along two arcs.
#[derive(Clone, Debug)]
struct ArcPath {
    arcs: Biarc,
    /// Share of the arcs in the position, see [`weight_of_arcs`].
    weight: f64,
    /// Arc length in mm, as Bézier control values over u.
    ways: [f64; 6],
}

/// Blend end, with the rest of the segment up to the corner.
#[derive(Clone, Debug)]
pub(crate) struct BlendEnd {
    pub(crate) segment: Arc<Segment>,
    pub(crate) sigma: f64,
    /// σ of the corner: 1 before the blend, 0 after it.
    pub(crate) corner: f64,
}

impl BlendEnd {
    /// Fraction of the segment between the end of the blend and the corner.
    fn share(&self) -> f64 {
        (self.corner - self.sigma).abs()
    }

    /// Whether the end is at the corner, so that the blend covers no part of the segment.
    pub(crate) fn is_corner(&self) -> bool {
        self.sigma == self.corner
    }

    /// Pose of the tool centre point on the segment. `left` is the fraction of the blend's part that remains to the
    /// corner: 1 at the end of the blend, 0 at the corner.
    fn pose_before_corner(&self, model: &Model<'_>, left: f64) -> IsometryMatrix3<f64> {
        self.segment.pose_at(model, self.sigma_at(left))
    }

    fn sigma_at(&self, left: f64) -> f64 {
        self.corner + (self.sigma - self.corner) * left
    }

    /// Value and derivatives of the axes at the end of the blend. The second derivatives continue the segment.
    ///
    /// The rate is twice the rest of the segment, reduced if a control point of the quintic would be outside of the
    /// hull of both nominal pieces: close to a singular position, axes are locally much faster than on average.
    fn jet(&self, model: &Model<'_>, hull: &Hull) -> Result<Jet<6>, Cause> {
        let [value, first, second] = self.segment.course(model, self.sigma)?.axes;
        let share = self.share();
        let towards_corner = first * (self.corner - self.sigma);
        let rate = 2.0 * share * hull.greatest_rate(&value, &towards_corner, &(second * share.powi(2)));
        Ok(Jet { value, first: first * rate, second: second * rate.powi(2) })
    }
}

impl BlendCurve {
    /// Returns the nominal path between the corner and the blend end.
    pub(crate) fn nominal(end: &BlendEnd) -> Self {
        Self::Nominal(Box::new(end.clone()))
    }

    /// Returns the curve for `blend = joint`: continuous in joint space up to the second derivative, and within the
    /// hull of the nominal pieces.
    pub(crate) fn joint(model: &Model<'_>, from: &BlendEnd, to: &BlendEnd) -> Result<Self, Cause> {
        let hull = Hull::of_pieces(model, [from, to].map(|end| (&*end.segment, [end.sigma, end.corner])));
        Ok(Self::Joint(Box::new(Quintic::between(&from.jet(model, &hull)?, &to.jet(model, &hull)?))))
    }

    /// Returns the curve for `blend = Cartesian`: arcs of the tool centre point.
    ///
    /// If the tool or the configuration changes, no such path exists, and the result is a joint blend.
    pub(crate) fn cartesian(model: &Model<'_>, from: &BlendEnd, to: &BlendEnd) -> Result<Self, Cause> {
        let courses = [from.segment.course(model, from.sigma)?, to.segment.course(model, to.sigma)?];
        let [branch, other] = courses.each_ref().map(|course| model.configuration(&course.axes[0]));
        if branch != other || from.segment.tool() != to.segment.tool() {
            return Self::joint(model, from, to);
        }
        let blend = PoseBlend::between(model, &courses, [from, to], branch)?;
        let [_, last] = blend.axes;
        let end = blend.inner_axes(model, 1.0, &last)?;
        if (end - last).amax() > 1e-6 {
            return Self::joint(model, from, to);
        }
        Ok(Self::Pose(Box::new(blend)))
    }

    /// Values of u that divide the blend into pieces of similar scale, both ends included: at jumps of the second
    /// derivative, and after a short end that turns within a small part of the curve.
    pub(crate) fn pieces(&self) -> Vec<f64> {
        match self {
            Self::Pose(blend) => match &blend.arcs {
                Some(arcs) => vec![0.0, arcs.junction(), 1.0],
                None => vec![0.0, 1.0],
            },
            Self::Joint(quintic) => {
                let [first, last] = quintic.turns().map(|turn| (3.0 * turn).min(0.5));
                [Some(0.0), is_short(first).then_some(first), is_short(last).then_some(1.0 - last), Some(1.0)]
                    .into_iter()
                    .flatten()
                    .collect()
            }
            Self::Nominal(_) => vec![0.0, 1.0],
        }
    }

    /// Axes at u, on the solution nearest to `near`.
    ///
    /// # Errors
    /// Returns the cause if a pose cannot be reached or if an axis would exceed its limits.
    pub(crate) fn axes(&self, model: &Model<'_>, u: f64, near: &Axes) -> Result<Axes, Cause> {
        match self {
            Self::Joint(quintic) => within_limits(model, quintic.at(u)),
            Self::Pose(blend) => blend.axes(model, u, near),
            Self::Nominal(end) => {
                let left = if end.corner == 1.0 { 1.0 - u } else { u };
                end.segment.axes(model, end.sigma_at(left))
            }
        }
    }
}

/// Whether the turning part at an end of a quintic requires its own knots.
fn is_short(end: f64) -> bool {
    end < SHORT_END
}

/// Clamps axes that rounding has moved beyond a limit, and rejects axes that exceed a limit by more.
fn within_limits(model: &Model<'_>, axes: Axes) -> Result<Axes, Cause> {
    let [least, most] = model.limits();
    let clamped = axes.sup(&least).inf(&most);
    if (axes - clamped).amax() < ROUNDING {
        return Ok(clamped);
    }
    model.beyond_limit(&axes).map_or(Ok(axes), Err)
}

impl PoseBlend {
    fn between(
        model: &Model<'_>,
        courses: &[Course; 2],
        ends: [&BlendEnd; 2],
        branch: Configuration,
    ) -> Result<Self, Cause> {
        let [from, _] = ends;
        check_orientations(model, ends)?;
        let corner = from.pose_before_corner(model, 0.0);
        let arcs = ArcPath::between(courses, ends, &corner.translation.vector);
        let (arcs, rate) = arcs.map_or((None, 1.0), |(arcs, rate)| (Some(arcs), rate));
        let axes = courses.each_ref().map(|course| course.axes[0]);
        Ok(Self { ends: ends.map(BlendEnd::clone), corner, rate, arcs, branch, axes })
    }

    /// Pose at u: the sum of both segments' differences from the corner. Neither the position nor the orientation
    /// therefore exceeds the range of the segments.
    fn pose(&self, model: &Model<'_>, u: f64) -> IsometryMatrix3<f64> {
        let [from, to] = &self.ends;
        let first = from.pose_before_corner(model, self.left(u));
        let second = to.pose_before_corner(model, self.left(1.0 - u));
        let sum = first.translation.vector + second.translation.vector - self.corner.translation.vector;
        let position = self.arcs.as_ref().map_or(sum, |arcs| sum.lerp(&arcs.at(u), arcs.weight));
        let rotation: Rotation3<f64> = first.rotation * self.corner.rotation.inverse() * second.rotation;
        IsometryMatrix3::from_parts(Translation3::from(position), rotation)
    }

    /// Fraction of the first segment's rest that remains to the corner at u.
    fn left(&self, u: f64) -> f64 {
        bezier([1.0, 1.0 - 0.4 * self.rate, 1.0 - 0.8 * self.rate, 0.0, 0.0, 0.0], u)
    }

    fn axes(&self, model: &Model<'_>, u: f64, near: &Axes) -> Result<Axes, Cause> {
        let [start, end] = self.axes;
        match u {
            0.0 => Ok(start),
            1.0 => Ok(end),
            _ => self.inner_axes(model, u, near),
        }
    }

    fn inner_axes(&self, model: &Model<'_>, u: f64, near: &Axes) -> Result<Axes, Cause> {
        let [from, _] = &self.ends;
        model.axes_near(self.branch, &(self.pose(model, u) * from.segment.tool().inverse()), near)
    }
}

impl ArcPath {
    /// Returns the arcs and the rate at both ends. For a blend that consists only of arcs, with equal distances, the
    /// rate is the rate of a constant speed.
    ///
    /// `None` if the tool centre point does not move on one side, turns back, or follows more than a quarter of a
    /// circle.
    fn between(courses: &[Course; 2], ends: [&BlendEnd; 2], corner: &Vector3<f64>) -> Option<(Self, f64)> {
        let [start, end] = [0, 1].map(|side| {
            let course = courses.get(side)?;
            let (way, sign) = (corner - course.position, if side == 0 { 1.0 } else { -1.0 });
            let direction = course.tangent.try_normalize(0.0)?;
            let distance = Some(way.norm()).filter(|distance| *distance > IN_PLACE)?;
            let is_forward = direction.dot(&way) * sign > LEAST_FORWARD * distance;
            is_forward.then_some(BiarcEnd { position: course.position, direction, distance })
        });
        let (start, end) = (start?, end?);
        let weight = weight_of_arcs(start.direction.dot(&end.direction));
        let arcs = Biarc::between(&start, &end).filter(|_| weight > 0.0)?;
        let [first, last] = [0, 1].map(|side| Some(courses.get(side)?.tangent.norm() * ends.get(side)?.share()));
        let (first, last) = (first?, last?);
        let length = arcs.length();
        let rate = 1.0 + ((length / (first + last)).min(1.0) - 1.0) * weight;
        let [first, last] = [0.4 * rate * first, 0.4 * rate * last];
        let ways = [0.0, first, (2.0 * first).min(length), (length - 2.0 * last).max(0.0), length - last, length];
        Some((Self { arcs, weight, ways }, rate))
    }

    fn at(&self, u: f64) -> Vector3<f64> {
        self.arcs.at(bezier(self.ways, u))
    }

    /// Value of u at the junction of the arcs.
    fn junction(&self) -> f64 {
        let (mut before, mut after) = (0.0, 1.0);
        for _ in 0..60 {
            let middle = (before + after) / 2.0;
            if bezier(self.ways, middle) < self.arcs.junction() { before = middle } else { after = middle }
        }
        after
    }
}

/// Weight of the arcs in a blend's position, from 0 to 1, by the cosine of the turn between the blend's ends.
///
/// The arm follows an arc at a constant speed, so an arc of more than about two radians is slower than a stop in the
/// corner. For sharper turns, the sum of both segments, which is slow only at the turn, has more weight.
fn weight_of_arcs(cosine: f64) -> f64 {
    let [round, sharp] = [ROUND_TURN, SHARP_TURN].map(degrees::cos);
    let share = ((cosine - sharp) / (round - sharp)).clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}

/// Checks that the orientation changes by less than half a turn from the leave point through the corner to the reach
/// point.
fn check_orientations(model: &Model<'_>, [from, to]: [&BlendEnd; 2]) -> Result<(), Cause> {
    let start = from.pose_before_corner(model, 1.0).rotation.inverse();
    let parts = || (0..=ORIENTATIONS).map(|part| f64::from(part) / f64::from(ORIENTATIONS));
    let there = parts().map(|part| from.pose_before_corner(model, 1.0 - part));
    let back = parts().map(|part| to.pose_before_corner(model, part));
    let turns: Vec<_> = there.chain(back).map(|pose| rotation::to_vector(&(start * pose.rotation))).collect();
    let turns_too_far = turns.iter().any(|turn| turn.norm().to_degrees() >= HALF_TURN);
    // Beyond half a turn, the shortest rotation has the opposite direction.
    let is_opposite = |pair: &[Vector3<f64>]| matches!(pair, [one, next] if (next - one).norm() > PI);
    if turns_too_far || turns.windows(2).any(is_opposite) { Err(Cause::Reorientation) } else { Ok(()) }
}
