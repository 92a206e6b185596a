//! The path between two segments: section (a) of the motion model.

use std::f64::consts::PI;

use nalgebra::{Translation3, Vector3};
use val3_geometry::{IsometryMatrix3, Rotation3, rotation};
use val3_kinematics::Configuration;

use crate::biarc::Biarc;
use crate::fault::Cause;
use crate::model::{Axes, Model};
use crate::quintic::{Jet, Quintic};
use crate::segment::{Course, Segment};

/// From this change of orientation on, in degrees, a Cartesian blend does not know which way to turn.
const HALF_TURN: f64 = 180.0 - 0.01;

/// Parts of a Cartesian blend at whose ends its change of orientation is checked.
const ORIENTATIONS: u32 = 64;

/// A curve from the leave point of one segment to the reach point of the next, by u from 0 to 1.
#[derive(Clone, Debug)]
pub(crate) enum BlendCurve {
    Joint(Box<Quintic<6>>),
    Pose(Box<PoseBlend>),
}

/// The Cartesian blend.
#[derive(Clone, Debug)]
pub(crate) struct PoseBlend {
    position: Position,
    /// Orientation at u = 0 and its rate, extrapolated over the blend.
    leaving: (Rotation3<f64>, Vector3<f64>),
    /// Orientation at u = 1 and its rate.
    reaching: (Rotation3<f64>, Vector3<f64>),
    tool: IsometryMatrix3<f64>,
    branch: Configuration,
}

#[derive(Clone, Debug)]
enum Position {
    Arcs(Biarc),
    Smooth(Quintic<3>),
}

/// One end of a blend.
pub(crate) struct BlendEnd<'a> {
    pub(crate) segment: &'a Segment,
    pub(crate) sigma: f64,
    /// σ of the corner: 1 before the blend, 0 after it.
    pub(crate) corner: f64,
    /// Effective distance to the corner in mm; none for a pure rotation.
    pub(crate) distance: Option<f64>,
}

impl BlendCurve {
    /// `blend = joint`: smooth in joint space up to the second derivative.
    pub(crate) fn joint(model: &Model<'_>, from: &BlendEnd<'_>, to: &BlendEnd<'_>) -> Result<Self, Cause> {
        let span = joint_distance(from, to);
        let jet = |end: &BlendEnd<'_>| {
            let course = end.segment.course(model, end.sigma)?;
            Ok::<_, Cause>(axes_jet(&course, scale(end, &course, span)))
        };
        Ok(Self::Joint(Box::new(Quintic::between(&jet(from)?, &jet(to)?))))
    }

    /// `blend = Cartesian`: arcs of the tool centre point.
    ///
    /// A joint blend where the tool or the configuration changes, for which no such path exists.
    pub(crate) fn cartesian(model: &Model<'_>, from: &BlendEnd<'_>, to: &BlendEnd<'_>) -> Result<Self, Cause> {
        let courses = [from.segment.course(model, from.sigma)?, to.segment.course(model, to.sigma)?];
        let [branch, other] = [0, 1].map(|end| courses.get(end).map(|course| model.configuration(&course.axes[0])));
        let (Some(branch), true) = (branch, branch == other && from.segment.tool() == to.segment.tool()) else {
            return Self::joint(model, from, to);
        };
        let blend = PoseBlend::between(&courses, [from, to], branch)?;
        let end = blend.axes(model, 1.0, &courses[1].axes[0])?;
        if (end - courses[1].axes[0]).amax() > 1e-6 {
            return Self::joint(model, from, to);
        }
        Ok(Self::Pose(Box::new(blend)))
    }

    /// Values of u at which the second derivative jumps, with both ends.
    pub(crate) fn pieces(&self) -> Vec<f64> {
        match self {
            Self::Pose(blend) => match &blend.position {
                Position::Arcs(arcs) => vec![0.0, arcs.junction(), 1.0],
                Position::Smooth(_) => vec![0.0, 1.0],
            },
            Self::Joint(_) => vec![0.0, 1.0],
        }
    }

    /// The axes at u, which are near to `near`.
    pub(crate) fn axes(&self, model: &Model<'_>, u: f64, near: &Axes) -> Result<Axes, Cause> {
        match self {
            Self::Joint(quintic) => Ok(quintic.at(u)),
            Self::Pose(blend) => blend.axes(model, u, near),
        }
    }
}

impl PoseBlend {
    fn between(
        [first, last]: &[Course; 2],
        [from, to]: [&BlendEnd<'_>; 2],
        branch: Configuration,
    ) -> Result<Self, Cause> {
        let [start, end] = [first, last].map(|course| course.pose.translation.vector);
        let arcs = match (first.tangent.try_normalize(0.0), last.tangent.try_normalize(0.0)) {
            (Some(leaving), Some(reaching)) if from.distance.is_some() && to.distance.is_some() => {
                Biarc::between(&start, &leaving, &end, &reaching)
            }
            _ => None,
        };
        let span = arcs.as_ref().map_or_else(|| joint_distance(from, to), |arcs| Some(arcs.length()));
        let [leave, reach] = [scale(from, first, span).rate, scale(to, last, span).rate];
        let position = arcs.map_or_else(
            || Position::Smooth(Quintic::between(&position_jet(first, leave), &position_jet(last, reach))),
            Position::Arcs,
        );
        let blend = Self {
            position,
            leaving: (first.pose.rotation, first.turn * leave),
            reaching: (last.pose.rotation, last.turn * reach),
            tool: *from.segment.tool(),
            branch,
        };
        let at = |part: u32| f64::from(part) / f64::from(ORIENTATIONS);
        let differences: Vec<_> = (0..=ORIENTATIONS).map(|part| blend.difference(at(part))).collect();
        let turns_too_far = differences.iter().any(|difference| difference.norm().to_degrees() >= HALF_TURN);
        // Beyond half a turn the shortest rotation is the opposite one.
        let is_opposite = |pair: &[Vector3<f64>]| matches!(pair, [one, next] if (next - one).norm() > PI);
        if turns_too_far || differences.windows(2).any(is_opposite) { Err(Cause::Reorientation) } else { Ok(blend) }
    }

    /// The rotation from the one extrapolated orientation to the other.
    fn difference(&self, u: f64) -> Vector3<f64> {
        let [first, second] = self.extrapolated(u);
        rotation::to_vector(&(first.inverse() * second))
    }

    fn extrapolated(&self, u: f64) -> [Rotation3<f64>; 2] {
        let (leaving, rate) = &self.leaving;
        let (reaching, back) = &self.reaching;
        [leaving * rotation::from_vector(&(rate * u)), reaching * rotation::from_vector(&(back * (u - 1.0)))]
    }

    fn pose(&self, u: f64) -> IsometryMatrix3<f64> {
        let [first, second] = self.extrapolated(u);
        let part = u * u * u * (10.0 + u * (-15.0 + u * 6.0));
        let between = rotation::to_vector(&(first.inverse() * second));
        let position = match &self.position {
            Position::Arcs(arcs) => arcs.at(u),
            Position::Smooth(quintic) => quintic.at(u),
        };
        IsometryMatrix3::from_parts(Translation3::from(position), first * rotation::from_vector(&(between * part)))
    }

    fn axes(&self, model: &Model<'_>, u: f64, near: &Axes) -> Result<Axes, Cause> {
        model.axes_near(self.branch, &(self.pose(u) * self.tool.inverse()), near)
    }
}

/// How σ of a segment runs on with u at one end of a blend.
#[derive(Clone, Copy)]
struct Scale {
    /// dσ/du.
    rate: f64,
    /// d²σ/du².
    change: f64,
}

/// The sum of both effective distances in mm; a pure rotation counts as much as the other side.
fn joint_distance(from: &BlendEnd<'_>, to: &BlendEnd<'_>) -> Option<f64> {
    match (from.distance, to.distance) {
        (Some(leave), Some(reach)) => Some(leave + reach),
        (one, other) => one.or(other).map(|distance| 2.0 * distance),
    }
}

/// The blend runs on by `span` mm of the segment for each unit of u. A pure rotation runs on by its half.
///
/// Where the tool centre point of a joint move nearly stops, its average rate counts instead: the path by length has
/// no derivative there.
fn scale(end: &BlendEnd<'_>, course: &Course, span: Option<f64>) -> Scale {
    let (Some(span), Some(distance)) = (span, end.distance) else { return Scale { rate: 1.0, change: 0.0 } };
    let to_corner = (end.corner - end.sigma).abs();
    let rate = course.tangent.norm();
    let average = if to_corner > 0.0 { distance / to_corner } else { rate };
    if rate < 0.1 * average {
        return Scale { rate: span / average, change: 0.0 };
    }
    let growth = course.tangent.dot(&course.curvature) / rate;
    Scale { rate: span / rate, change: -growth * span * span / (rate * rate * rate) }
}

fn axes_jet(course: &Course, scale: Scale) -> Jet<6> {
    let [value, first, second] = course.axes;
    Jet { value, first: first * scale.rate, second: second * scale.rate.powi(2) + first * scale.change }
}

fn position_jet(course: &Course, rate: f64) -> Jet<3> {
    Jet { value: course.pose.translation.vector, first: course.tangent * rate, second: course.curvature * rate.powi(2) }
}
