//! Segment: a move's nominal path from the previous destination to its own destination, corners included.

use std::sync::Arc as Shared;

use nalgebra::Vector3;
use val3_geometry::{Arc, IsometryMatrix3, LinePath, rotation};
use val3_kinematics::RequestedConfiguration;

use crate::alteration::Alteration;
use crate::branches::{Branches, ConfigurationPart};
use crate::derivatives;
use crate::fault::Cause;
use crate::model::{Axes, Model};

/// Distance below which the tool centre point counts as not moving, in mm.
pub(crate) const IN_PLACE: f64 = 1e-3;

/// Distance between the points from which derivatives are computed, as a fraction of the segment.
const STENCIL: f64 = 1e-3;

/// Number of segment parts for the computation of length and corners.
const PARTS: usize = 64;

/// Number of parts into which a Cartesian segment is divided to compute its axes from the start on.
const WAYPOINTS: usize = 32;

/// Number of parts into which the path to a waypoint is divided if an axis seems to jump there.
const FINER: usize = 16;

/// The first waypoint is compared with a point whose distance to the start is smaller by this factor.
const AHEAD: f64 = 8.0;

/// Nominal path of a move. The parameter σ runs from 0 at the start to 1 at the destination.
#[derive(Clone, Debug)]
pub(crate) struct Segment {
    route: Route,
    start: Axes,
    end: Axes,
    tool: IsometryMatrix3<f64>,
    /// Path length of the tool centre point, in mm.
    length: f64,
}

#[derive(Clone, Debug)]
enum Route {
    Joint,
    Pose(Box<PoseRoute>),
    Deviated(Box<DeviatedRoute>),
}

/// Path with a deviation that no longer changes.
#[derive(Clone, Debug)]
struct DeviatedRoute {
    nominal: Shared<Segment>,
    alteration: Alteration,
    near: Axes,
}

#[derive(Clone, Debug)]
struct PoseRoute {
    curve: PoseCurve,
    branches: Branches,
    /// Axes at the start and after each part, as far as the arm can follow the path.
    waypoints: Vec<Axes>,
}

/// Path of the tool centre point in a Cartesian move.
#[derive(Clone, Debug)]
pub(crate) enum PoseCurve {
    Line(LinePath),
    Arc(Arc),
}

impl PoseCurve {
    pub(crate) fn at(&self, sigma: f64) -> IsometryMatrix3<f64> {
        match self {
            Self::Line(line) => line.at(sigma),
            Self::Arc(arc) => arc.at(sigma),
        }
    }

    fn length(&self) -> f64 {
        match self {
            Self::Line(line) => line.length(),
            Self::Arc(arc) => arc.length(),
        }
    }
}

/// Reach point of the previous blend and leave point of the next blend on a segment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Corners {
    /// σ at which the blend from the previous move ends; 0 without a blend.
    pub(crate) reach: f64,
    /// σ at which the blend to the next move begins; 1 without a blend.
    pub(crate) leave: f64,
    /// Effective distances in mm of the reach point to the start and of the leave point to the destination; 0 without a
    /// blend.
    pub(crate) distances: [f64; 2],
}

/// State of the path at one point, with derivatives by σ.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Course {
    /// Axes, and their first and second derivatives.
    pub(crate) axes: [Axes; 3],
    /// Position of the tool centre point in mm.
    pub(crate) position: Vector3<f64>,
    /// First derivative of the position.
    pub(crate) tangent: Vector3<f64>,
}

impl Segment {
    /// Creates a straight line in joint space.
    pub(crate) fn joint(model: &Model<'_>, start: Axes, end: Axes, tool: IsometryMatrix3<f64>) -> Self {
        let mut segment = Self { route: Route::Joint, start, end, tool, length: 0.0 };
        segment.length = segment.measure(model);
        segment
    }

    /// Creates a Cartesian path from `start`. Parts of the configuration that are free may change at points where the
    /// path passes exactly through a singular position.
    ///
    /// If the arm cannot follow the path to its end, the second value is the cause, and the path ends at the last
    /// waypoint that the arm can reach.
    pub(crate) fn pose(
        model: &Model<'_>,
        start: Axes,
        curve: PoseCurve,
        tool: IsometryMatrix3<f64>,
        configuration: &RequestedConfiguration,
    ) -> (Self, Option<Cause>) {
        let mut branches = Branches::starting_on(model.configuration(&start));
        let to_flange = tool.inverse();
        let solve = |branch, sigma, near: &Axes| model.axes_near(branch, &(curve.at(sigma) * to_flange), near);
        let mut waypoints = vec![start];
        let mut fault = None;
        let ahead = solve(model.configuration(&start), share(1, WAYPOINTS) / AHEAD, &start);
        let before_start = ahead.ok().map(|ahead| start + (start - ahead) * AHEAD);
        for waypoint in 1..=WAYPOINTS {
            let near = waypoints.last().copied().unwrap_or(start);
            let before = waypoint.checked_sub(2).map_or(before_start.as_ref(), |before| waypoints.get(before));
            let range = [share(waypoint - 1, WAYPOINTS), share((waypoint + 1).min(WAYPOINTS), WAYPOINTS)];
            for part in ConfigurationPart::free(configuration).filter(|part| part.may_change(model.0, before, &near)) {
                branches.look_for(part, model.0, solve, range, &near);
            }
            let axes = branches.axes(solve, share(waypoint, WAYPOINTS), &near).and_then(|axes| {
                let at_share = |sigma, near: &Axes| branches.axes(solve, sigma, near);
                match model.limit_behind_turn(&near, &axes) {
                    Some(_) => limit_between(model, at_share, waypoint, &near).map_or(Ok(axes), Err),
                    None => Ok(axes),
                }
            });
            match axes {
                Ok(axes) => waypoints.push(axes),
                Err(cause) => {
                    fault = Some(cause);
                    break;
                }
            }
        }
        let end = waypoints.last().copied().unwrap_or(start);
        let length = curve.length();
        let route = Route::Pose(Box::new(PoseRoute { curve, branches, waypoints }));
        (Self { route, start, end, tool, length }, fault)
    }

    /// Creates a path with the current deviation, with axes near to `near`.
    pub(crate) fn deviated(
        model: &Model<'_>,
        nominal: &Shared<Self>,
        alteration: &Alteration,
        near: Axes,
    ) -> Result<Self, Cause> {
        let [start, end] = [nominal.start, nominal.end].map(|axes| alteration.applied_to(model, &axes, &near));
        let route = DeviatedRoute { nominal: Shared::clone(nominal), alteration: alteration.clone(), near };
        let (tool, length) = (nominal.tool, nominal.length);
        Ok(Self { route: Route::Deviated(Box::new(route)), start: start?, end: end?, tool, length })
    }

    pub(crate) fn is_deviated(&self) -> bool {
        matches!(self.route, Route::Deviated(_))
    }

    pub(crate) fn end(&self) -> Axes {
        self.end
    }

    pub(crate) fn tool(&self) -> &IsometryMatrix3<f64> {
        &self.tool
    }

    /// Axes at σ.
    pub(crate) fn axes(&self, model: &Model<'_>, sigma: f64) -> Result<Axes, Cause> {
        match &self.route {
            _ if sigma == 0.0 => Ok(self.start),
            Route::Joint if sigma == 1.0 => Ok(self.end),
            Route::Joint => Ok(self.start + (self.end - self.start) * sigma),
            Route::Pose(route) => {
                let PoseRoute { curve, branches, waypoints } = route.as_ref();
                let to_flange = self.tool.inverse();
                let solve = |branch, sigma, near: &Axes| model.axes_near(branch, &(curve.at(sigma) * to_flange), near);
                branches.axes(solve, sigma, &nearest(waypoints, sigma))
            }
            Route::Deviated(route) => {
                let nominal = route.nominal.axes(model, sigma)?;
                route.alteration.applied_to(model, &nominal, &route.near)
            }
        }
    }

    /// Tool centre point at σ, in `world`.
    pub(crate) fn pose_at(&self, model: &Model<'_>, sigma: f64) -> IsometryMatrix3<f64> {
        match &self.route {
            Route::Joint => model.flange(&(self.start + (self.end - self.start) * sigma)) * self.tool,
            Route::Pose(route) => route.curve.at(sigma),
            Route::Deviated(route) => {
                let flange = route.nominal.pose_at(model, sigma) * self.tool.inverse();
                route.alteration.applied_to_flange(&flange) * self.tool
            }
        }
    }

    /// Whether the tool centre point does not move.
    pub(crate) fn is_rotation(&self) -> bool {
        self.length < IN_PLACE
    }

    /// Whether the tool centre point moves on a circle.
    pub(crate) fn is_arc(&self) -> bool {
        matches!(&self.route, Route::Pose(_)) && !self.is_line()
    }

    /// Whether the axes are linear in σ.
    pub(crate) fn is_straight_in_joints(&self) -> bool {
        matches!(self.route, Route::Joint)
    }

    fn is_line(&self) -> bool {
        matches!(&self.route, Route::Pose(route) if matches!(route.curve, PoseCurve::Line(_)))
    }

    /// Whether the move ends at its start, within the precision of the arm.
    pub(crate) fn is_null(&self) -> bool {
        match &self.route {
            Route::Joint => (self.end - self.start).amax() < 1e-9,
            Route::Pose(route) => {
                let [from, to] = [0.0, 1.0].map(|sigma| route.curve.at(sigma));
                let turn = rotation::angle_between(&from.rotation, &to.rotation);
                self.is_rotation() && turn.to_degrees() < 1e-4
            }
            Route::Deviated(route) => route.nominal.is_null(),
        }
    }

    /// Computes the corners of the segment from the previous move's `reach` and this move's `leave`, in mm; 0 without a
    /// blend.
    ///
    /// Overlapping distances are reduced in proportion (section (a) of the motion model): both corners meet at the
    /// point that divides the path of the tool centre point in the ratio of the distances. For a rotation in place, the
    /// limit of ever shorter moves, the point divides the angle of rotation instead.
    pub(crate) fn corners(&self, model: &Model<'_>, reach: f64, leave: f64) -> Corners {
        let scale = (self.length / (reach + leave)).min(1.0);
        let [first, last] = [reach, leave].map(|distance| if distance > 0.0 { distance * scale } else { 0.0 });
        let share = reach / (reach + leave);
        // Two searches would return two points that differ by rounding.
        let (reach, leave) = if scale < 1.0 {
            self.shared_corner(model, share, [0.0, 1.0])
        } else {
            let reach = if first > 0.0 { self.first_at_distance(model, first) } else { Some(0.0) };
            let leave = if last > 0.0 { self.last_at_distance(model, last) } else { Some(1.0) };
            let have_corner = first > 0.0 || last > 0.0;
            match (reach, leave) {
                (Some(reach), Some(leave)) if have_corner && ((leave - reach) * self.length).abs() < IN_PLACE => {
                    let meeting = if last > 0.0 { reach } else { leave };
                    (meeting, meeting)
                }
                (Some(reach), Some(leave)) if reach < leave => (reach, leave),
                // On a bent path, the distances can overlap although the path is longer than their sum. Neither
                // distance may exceed the requested value.
                (reach, leave) => self.shared_corner(model, share, [leave.unwrap_or(0.0), reach.unwrap_or(1.0)]),
            }
        };
        let way = |from: f64, to: f64| (self.position(model, from) - self.position(model, to)).norm();
        let distances = [(first, way(0.0, reach)), (last, way(leave, 1.0))]
            .map(|(distance, way)| if distance > 0.0 { way } else { 0.0 });
        Corners { reach, leave, distances }
    }

    /// σ of both corners if they meet at a fraction of the path length, within a range of σ.
    fn shared_corner(&self, model: &Model<'_>, share: f64, [from, to]: [f64; 2]) -> (f64, f64) {
        let meeting = self.at_part_of_way(model, share).clamp(from, to);
        (meeting, meeting)
    }

    /// First σ at which the tool centre point is `distance` away from the start.
    fn first_at_distance(&self, model: &Model<'_>, distance: f64) -> Option<f64> {
        let start = self.position(model, 0.0);
        let is_away = |sigma: f64| (self.position(model, sigma) - start).norm() >= distance;
        let part = (1..=PARTS).find(|part| is_away(share(*part, PARTS)))?;
        Some(boundary(share(part - 1, PARTS), share(part, PARTS), is_away))
    }

    /// Last σ at which the tool centre point is `distance` away from the destination.
    fn last_at_distance(&self, model: &Model<'_>, distance: f64) -> Option<f64> {
        let end = self.position(model, 1.0);
        let is_away = |sigma: f64| (self.position(model, sigma) - end).norm() >= distance;
        let part = (0..PARTS).rev().find(|part| is_away(share(*part, PARTS)))?;
        Some(boundary(share(part + 1, PARTS), share(part, PARTS), is_away))
    }

    /// Tool centre point at σ in `world`, in mm.
    pub(crate) fn position(&self, model: &Model<'_>, sigma: f64) -> Vector3<f64> {
        self.pose_at(model, sigma).translation.vector
    }

    /// σ at which the tool centre point has covered the fraction `part` (0 to 1) of the path length.
    fn at_part_of_way(&self, model: &Model<'_>, part: f64) -> f64 {
        if self.is_line() || self.is_arc() || self.is_rotation() || part == 1.0 {
            return part;
        }
        let chords = chords(&self.points(model));
        let mut left = part * chords.iter().sum::<f64>();
        for (number, chord) in chords.into_iter().enumerate() {
            if left <= chord {
                return (share(number, PARTS) + left / chord.max(f64::MIN_POSITIVE) / PARTS as f64).min(1.0);
            }
            left -= chord;
        }
        1.0
    }

    /// Path length of the tool centre point in mm, extrapolated from coarse and fine chords.
    fn measure(&self, model: &Model<'_>) -> f64 {
        let points = self.points(model);
        let thinned: Vec<_> = points.iter().copied().step_by(2).collect();
        let way = |points: &[Vector3<f64>]| -> f64 { chords(points).into_iter().sum() };
        (4.0 * way(&points) - way(&thinned)) / 3.0
    }

    /// Positions of the tool centre point at equal steps of σ.
    fn points(&self, model: &Model<'_>) -> Vec<Vector3<f64>> {
        (0..=PARTS).map(|part| self.position(model, share(part, PARTS))).collect()
    }

    /// State of the path at σ, with derivatives.
    pub(crate) fn course(&self, model: &Model<'_>, sigma: f64) -> Result<Course, Cause> {
        let first = (sigma - 2.0 * STENCIL).clamp(0.0, 1.0 - 4.0 * STENCIL);
        let index = ((sigma - first) / STENCIL).round();
        let at = |k: usize| sigma + (k as f64 - index) * STENCIL;
        let axes = (0..5).map(|k| self.axes(model, at(k))).collect::<Result<Vec<_>, _>>()?;
        let positions: Vec<_> = (0..5).map(|k| self.position(model, at(k))).collect();
        let index = index as usize;
        let [first, second] = derivatives::at(&axes, index, STENCIL);
        let [tangent, _] = derivatives::at(&positions, index, STENCIL);
        Ok(Course { axes: [self.axes(model, sigma)?, first, second], position: self.position(model, sigma), tangent })
    }
}

/// Axis limit because of which an axis jumps by a full turn before a waypoint; `None` if the axis only moves far, as
/// next to a singular position.
fn limit_between(
    model: &Model<'_>,
    axes: impl Fn(f64, &Axes) -> Result<Axes, Cause>,
    waypoint: usize,
    before: &Axes,
) -> Option<Cause> {
    let mut near = *before;
    (1..=FINER).find_map(|part| {
        let sigma = share((waypoint - 1) * FINER + part, WAYPOINTS * FINER);
        let axes = axes(sigma, &near).ok()?;
        let limit = model.limit_behind_turn(&near, &axes);
        near = axes;
        limit
    })
}

/// Axes of the waypoint nearest to σ.
fn nearest(waypoints: &[Axes], sigma: f64) -> Axes {
    let index = (sigma.clamp(0.0, 1.0) * WAYPOINTS as f64).round() as usize;
    waypoints.get(index).or(waypoints.last()).copied().unwrap_or_default()
}

/// Distances between consecutive points, in mm.
fn chords(points: &[Vector3<f64>]) -> Vec<f64> {
    points.windows(2).map(|pair| if let [from, to] = pair { (to - from).norm() } else { 0.0 }).collect()
}

fn share(part: usize, parts: usize) -> f64 {
    part as f64 / parts as f64
}

/// Boundary between `outside`, where `is_away` is false, and `inside`, where it is true, by bisection.
fn boundary(mut outside: f64, mut inside: f64, is_away: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..60 {
        let middle = (outside + inside) / 2.0;
        if is_away(middle) { inside = middle } else { outside = middle }
    }
    inside
}
