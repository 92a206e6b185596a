//! Path of the recorded moves. Only the moves determine the path, and a span is created when its moves determine it.

use std::sync::Arc;

use val3_geometry::{IsometryMatrix3, LinePath, Vector3};
use val3_kinematics::{Joints, RequestedConfiguration};
use val3_moves::{Blend, Manner, Millimetres, MovePath, MoveTarget};

use crate::alteration::Alteration;
use crate::blend::{BlendCurve, BlendEnd};
use crate::fault::Cause;
use crate::model::{Axes, Model};
use crate::queue::{BlendCorner, Shortening};
use crate::request::{Move, SpeedLimits};
use crate::segment::{Corners, PoseCurve, Segment};
use crate::span::{BlendPart, Curve, Pieces, Span, SpanLimits, SpanPart, SpanRequest};

/// Difference from which a blend distance counts as shorter than requested, in mm.
const SHORTER: f64 = 0.1;

/// Difference below which a measured distance equals the requested distance, in mm.
const ROUNDING: f64 = 1e-6;

/// End of the recorded path.
#[derive(Clone, Debug)]
pub(crate) struct PathEnd {
    /// Destination of the last recorded move.
    destination: Axes,
    /// Last recorded move, while the path ends at its leave point.
    open: Option<OpenCorner>,
}

/// Move whose blend depends on the next move.
#[derive(Clone, Debug)]
struct OpenCorner {
    segment: Arc<Segment>,
    serial: u64,
    id: f64,
    limits: SpeedLimits,
    blend: Blend,
    manner: Manner,
    /// σ of the leave point.
    leave: f64,
    /// Whether the arm starts from rest at the leave point, because no span precedes it.
    at_rest: bool,
}

/// Part of the path that a recorded move has determined.
#[derive(Debug, Default)]
pub(crate) struct Determined {
    /// Spans, each with whether the arm rests before it.
    pub(crate) spans: Vec<(Arc<Span>, bool)>,
    /// Cause for which the path cannot be followed beyond the spans.
    pub(crate) fault: Option<Cause>,
    /// Serial number of the move whose blend is among the spans.
    pub(crate) blended: Option<u64>,
    /// Whether `fault` is in the blend.
    pub(crate) has_blend_fault: bool,
    /// End of the previous move's blend, then start of this move's blend.
    pub(crate) reach: Option<BlendCorner>,
    pub(crate) leave: Option<BlendCorner>,
}

impl Determined {
    /// Adds the spans of a path. Returns whether the arm can follow the path to its end.
    fn add(&mut self, model: &Model<'_>, request: SpanRequest, from_rest: bool) -> bool {
        let Pieces { spans, fault } = Pieces::of(model, request);
        let spans = spans.into_iter().enumerate();
        self.spans.extend(spans.map(|(number, span)| (Arc::new(span), from_rest && number == 0)));
        self.fault = fault;
        self.fault.is_none()
    }
}

/// Distances of a blend corner to the destination, in mm.
struct CornerDistances {
    requested: f64,
    effective: f64,
    /// Requested distance at the other end of the blend.
    opposite: f64,
}

impl CornerDistances {
    /// Blend corner at a position. `short` is the reason for a distance that is shorter than requested.
    fn corner(self, position: Vector3<f64>, short: Shortening) -> BlendCorner {
        let Self { requested, effective, opposite } = self;
        let shortening = if requested > 0.0 && opposite == 0.0 {
            Some(Shortening::StopAtCorner)
        } else {
            (effective < requested - SHORTER).then_some(short)
        };
        let distance = if (effective - requested).abs() < ROUNDING { requested } else { effective };
        BlendCorner { requested: Millimetres(requested), distance: Millimetres(distance), shortening, position }
    }
}

impl PathEnd {
    /// Creates a path that starts at these axes.
    pub(crate) fn starting_at(start: Axes) -> Self {
        Self { destination: start, open: None }
    }

    /// Axes at the end of the last recorded move.
    pub(crate) fn destination(&self) -> Axes {
        self.destination
    }

    /// Whether the path ends at a leave point, because the blend requires the next move.
    pub(crate) fn is_open(&self) -> bool {
        self.open.is_some()
    }

    /// Serial number of the move at whose leave point the path ends.
    pub(crate) fn open_serial(&self) -> Option<u64> {
        self.open.as_ref().map(|open| open.serial)
    }

    /// Requested leave and reach for the blend of the move in `open_serial`.
    pub(crate) fn open_distances(&self) -> Option<[Millimetres; 2]> {
        let (leave, reach) = self.open.as_ref()?.blend.distances()?;
        Some([leave, reach].map(Millimetres))
    }

    /// σ of a move's leave point, while the path ends there.
    pub(crate) fn leave_of(&self, serial: u64) -> Option<f64> {
        self.open.as_ref().filter(|open| open.serial == serial).map(|open| open.leave)
    }

    /// Rest of the nominal path after the last span, while the path ends at a leave point: segment, and σ of the leave
    /// point.
    pub(crate) fn open_end(&self) -> Option<(&Segment, f64)> {
        self.open.as_ref().filter(|open| open.leave < 1.0).map(|open| (&*open.segment, open.leave))
    }

    /// Records a move under a serial number.
    ///
    /// # Errors
    /// Returns the cause if the destination cannot be reached, or not in this configuration. The path is then
    /// unchanged.
    pub(crate) fn record(&mut self, model: &Model<'_>, request: &Move, serial: u64) -> Result<Determined, Cause> {
        let (segment, fault) = self.segment(model, request)?;
        let mut determined = Determined::default();
        if segment.is_null() {
            return Ok(determined);
        }
        let segment = Arc::new(segment);
        let open = self.open.take();
        let (leave_before, reach) = open.as_ref().and_then(|open| open.blend.distances()).unwrap_or_default();
        let stops_at_corner = open.is_some() && reach == 0.0;
        let (leave, reach_after) = request.corner().distances().unwrap_or_default();
        let corners = segment.corners(model, reach, leave);
        self.destination = segment.end();
        let [before, after] = corners.distances;
        determined.reach = open.as_ref().map(|_| {
            let distances = CornerDistances { requested: reach, effective: before, opposite: leave_before };
            let short = if leave > 0.0 { Shortening::SharedWithNext(serial) } else { Shortening::ShortMove(serial) };
            distances.corner(segment.position(model, corners.reach), short)
        });
        determined.leave = request.corner().distances().map(|_| {
            let distances = CornerDistances { requested: leave, effective: after, opposite: reach_after };
            let short = match &open {
                Some(open) if reach > 0.0 => Shortening::SharedWithPrevious(open.serial),
                _ => Shortening::ShortMove(serial),
            };
            distances.corner(segment.position(model, corners.leave), short)
        });
        let part = SpanPart::Nominal { serial, id: request.id };
        let to = BlendPart { serial, id: request.id, sigma: corners.reach };
        determined.blended = open.as_ref().map(|open| open.serial);
        let can_follow = open.is_none_or(|open| blend(model, &open, &segment, to, corners, request, &mut determined));
        if can_follow && corners.leave > corners.reach {
            let from_rest = stops_at_corner || determined.spans.is_empty();
            match nominal(model, request, &segment, part, [corners.reach, corners.leave]) {
                Ok(nominal) => drop(determined.add(model, nominal, from_rest)),
                Err(cause) => determined.fault = Some(cause),
            }
        }
        determined.has_blend_fault = !can_follow;
        determined.fault = determined.fault.take().or(fault);
        self.open = request.corner().distances().map(|_| OpenCorner {
            segment,
            serial,
            id: request.id,
            limits: request.limits,
            blend: request.blend,
            manner: request.manner,
            leave: corners.leave,
            at_rest: determined.spans.is_empty() || stops_at_corner && corners.leave <= corners.reach,
        });
        Ok(determined)
    }

    /// Returns the cause for which the arm cannot follow the blend between two moves; `None` if it can, or without a
    /// blend. The first move begins at the end of this path, and the previous blend covers `reach` of its path.
    ///
    /// # Errors
    /// Returns the cause if the arm cannot follow one of the two moves.
    pub(crate) fn blend_fault(
        &self,
        model: &Model<'_>,
        [first, second]: [&Move; 2],
        reach: Millimetres,
    ) -> Result<Option<Cause>, Cause> {
        let (segment, fault) = self.segment(model, first)?;
        let Some((leave, _)) = first.corner().distances().filter(|_| !segment.is_null()) else { return Ok(None) };
        if let Some(fault) = fault {
            return Err(fault);
        }
        let open = OpenCorner {
            leave: segment.corners(model, reach.0, leave).leave,
            serial: 0,
            id: first.id,
            limits: first.limits,
            blend: first.blend,
            manner: first.manner,
            at_rest: false,
            segment: Arc::new(segment),
        };
        let mut path = Self { destination: open.segment.end(), open: Some(open) };
        let determined = path.record(model, second, 1)?;
        Ok(determined.fault.filter(|_| determined.has_blend_fault))
    }

    /// Ends the last recorded move at its destination, without a blend (`waitEndMove`).
    pub(crate) fn close(&mut self, model: &Model<'_>) -> Determined {
        let mut determined = Determined::default();
        if let Some(open) = self.open.take()
            && open.leave < 1.0
        {
            match open.segment.axes(model, open.leave) {
                Ok(start) => {
                    let tail = SpanRequest {
                        part: SpanPart::Nominal { serial: open.serial, id: open.id },
                        manner: open.manner,
                        tool: *open.segment.tool(),
                        limits: SpanLimits([open.limits; 2]),
                        range: [open.leave, 1.0],
                        start,
                        curve: Curve::Nominal(open.segment),
                    };
                    determined.add(model, tail, open.at_rest);
                }
                Err(cause) => determined.fault = Some(cause),
            }
        }
        determined
    }

    /// Applies a deviation to the rest of the path. `near` are the axes at the end of the spans.
    ///
    /// Returns |dq/dσ| at the leave point if the path ends at one.
    pub(crate) fn deviate(
        &mut self,
        model: &Model<'_>,
        alteration: &Alteration,
        near: Axes,
    ) -> Result<Option<f64>, Cause> {
        let Some(open) = &mut self.open else {
            self.destination = near;
            return Ok(None);
        };
        if open.segment.is_deviated() {
            return Ok(None);
        }
        let segment = Segment::deviated(model, &open.segment, alteration, near)?;
        let [_, tangent, _] = segment.course(model, open.leave)?.axes;
        self.destination = segment.end();
        open.segment = Arc::new(segment);
        Ok(Some(tangent.norm()))
    }

    /// Nominal path of a move, and the cause for which the arm cannot follow it to the end.
    pub(crate) fn segment(&self, model: &Model<'_>, request: &Move) -> Result<(Segment, Option<Cause>), Cause> {
        let start = self.destination;
        match &request.path {
            MovePath::Joint(joints) => Ok((self.joint(model, request, joints)?, None)),
            MovePath::JointToPoint(target) => {
                let joints = self.joints_at(model, target, &request.tool)?;
                Ok((self.joint(model, request, &joints)?, None))
            }
            MovePath::Line(destination) => {
                let line = LinePath::between(&(model.flange(&start) * request.tool), &destination.pose);
                self.cartesian(model, request, PoseCurve::Line(line), destination)
            }
            MovePath::Circle(intermediate, destination) => {
                let from = model.flange(&start) * request.tool;
                model.check_intermediate(&(intermediate * request.tool.inverse()), &start)?;
                let arc = val3_geometry::Arc::through(&from, intermediate, &destination.pose)?;
                self.cartesian(model, request, PoseCurve::Arc(arc), destination)
            }
        }
    }

    /// Joint position at which a joint move from the end of the path reaches a point.
    ///
    /// # Errors
    /// Returns the cause if the point cannot be reached in a requested configuration.
    pub(crate) fn joints_at(
        &self,
        model: &Model<'_>,
        target: &MoveTarget,
        tool: &IsometryMatrix3<f64>,
    ) -> Result<Joints, Cause> {
        let flange = target.pose * tool.inverse();
        Ok(model.0.solve(&flange.into(), &self.destination.into(), target.configuration)?)
    }

    /// Nominal path of a joint move.
    fn joint(&self, model: &Model<'_>, request: &Move, joints: &Joints) -> Result<Segment, Cause> {
        let (start, end) = (self.destination, model.in_range(joints)?);
        if request.manner == Manner::Alterable && model.configuration(&end) != model.configuration(&start) {
            return Err(Cause::Configuration);
        }
        Ok(Segment::joint(model, start, end, request.tool))
    }

    /// Nominal path of a Cartesian move, whose destination must be reachable.
    fn cartesian(
        &self,
        model: &Model<'_>,
        request: &Move,
        curve: PoseCurve,
        destination: &MoveTarget,
    ) -> Result<(Segment, Option<Cause>), Cause> {
        let start = self.destination;
        let branch = model.configuration(&start);
        if !destination.configuration.allows(branch, branch) {
            return Err(Cause::Configuration);
        }
        // A deviation from an alterable path does not change the configuration.
        let is_alterable = request.manner == Manner::Alterable;
        let configuration = if is_alterable { RequestedConfiguration::SAME } else { destination.configuration };
        let (segment, fault) = Segment::pose(model, start, curve, request.tool, &configuration);
        if fault.is_some() {
            model.axes_near(branch, &(destination.pose * request.tool.inverse()), &start)?;
        }
        Ok((segment, fault))
    }
}

/// Nominal path of a move between two values of σ.
fn nominal(
    model: &Model<'_>,
    request: &Move,
    segment: &Arc<Segment>,
    part: SpanPart,
    range: [f64; 2],
) -> Result<SpanRequest, Cause> {
    let [from, _] = range;
    Ok(SpanRequest {
        curve: Curve::Nominal(Arc::clone(segment)),
        part,
        manner: request.manner,
        tool: request.tool,
        limits: SpanLimits([request.limits; 2]),
        range,
        start: segment.axes(model, from)?,
    })
}

/// Adds the blend from an open corner to the next segment. Returns whether the arm can follow the blend.
fn blend(
    model: &Model<'_>,
    open: &OpenCorner,
    segment: &Arc<Segment>,
    to: BlendPart,
    corners: Corners,
    request: &Move,
    determined: &mut Determined,
) -> bool {
    let from = BlendEnd { segment: Arc::clone(&open.segment), sigma: open.leave, corner: 1.0 };
    let join = BlendEnd { segment: Arc::clone(segment), sigma: corners.reach, corner: 0.0 };
    let curve = match open.blend {
        // The directions of the paths differ at the corner, so the arm stops there.
        _ if from.is_corner() => Ok(BlendCurve::nominal(&join)),
        _ if join.is_corner() => Ok(BlendCurve::nominal(&from)),
        Blend::Cartesian { .. } => BlendCurve::cartesian(model, &from, &join),
        _ => BlendCurve::joint(model, &from, &join),
    };
    let (curve, start) = match curve.and_then(|curve| Ok((curve, open.segment.axes(model, open.leave)?))) {
        Ok(found) => found,
        Err(cause) => {
            determined.fault = Some(cause);
            return false;
        }
    };
    let part = SpanPart::Blend { from: BlendPart { serial: open.serial, id: open.id, sigma: open.leave }, to };
    let limits = SpanLimits::of_blend(&open.limits, &request.limits);
    let manner = if open.manner == request.manner { request.manner } else { Manner::Rigid };
    let pieces = curve.pieces();
    let mut start = start;
    let mut from_rest = open.at_rest || from.is_corner();
    for range in pieces.windows(2) {
        let &[from, to] = range else { continue };
        let piece = SpanRequest {
            curve: Curve::Blend(curve.clone()),
            part,
            manner,
            tool: request.tool,
            limits,
            range: [from, to],
            start,
        };
        if !determined.add(model, piece, from_rest) {
            return false;
        }
        from_rest = false;
        start = determined.spans.last().map_or(start, |(span, _)| span.end());
    }
    true
}
