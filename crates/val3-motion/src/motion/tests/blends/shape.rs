//! Region within which a blend stays.

use val3_geometry::degrees;

use super::*;
use crate::blend::BlendCurve;
use crate::hull::MARGIN;
use crate::segment::Segment;
use crate::span::{BlendPart, Curve, Span, SpanPart};

/// Number of positions per curve at which a property is checked.
const SAMPLES: usize = 200;

/// Blend with the nominal segments that it joins.
struct Corner<'a> {
    arm: &'a Arm,
    /// First span with the curve.
    span: &'a Span,
    parts: [BlendPart; 2],
    segments: [Arc<Segment>; 2],
    /// Moves before and after the corner.
    requests: [&'a Move; 2],
}

/// Nominal segments of a program, by move number.
fn segments(program: &Program, requests: &[Move]) -> Vec<Arc<Segment>> {
    let mut motion = Motion::new(Arc::new(program.arm()), program.start());
    let arm = Arc::clone(&motion.arm);
    let segments = requests.iter().map(|request| {
        let segment = motion.path.segment(&Model(&arm), request).unwrap().0;
        if !segment.is_null() {
            motion.path = PathEnd::starting_at(segment.end());
        }
        Arc::new(segment)
    });
    segments.collect()
}

fn corners<'a>(motion: &'a Motion, requests: &'a [Move], segments: &[Arc<Segment>]) -> Vec<Corner<'a>> {
    let spans = motion.timeline.spans.iter().map(|timed| &*timed.span);
    let corners = spans.filter_map(|span| match span.part {
        SpanPart::Blend { from, to } if span.range()[0] == 0.0 => {
            let [first, second] = [from.serial as usize, to.serial as usize];
            Some(Corner {
                arm: &motion.arm,
                span,
                parts: [from, to],
                segments: [first, second].map(|number| Arc::clone(&segments[number])),
                requests: [&requests[first], &requests[second]],
            })
        }
        _ => None,
    });
    corners.collect()
}

impl Corner<'_> {
    /// Equidistant axes on the blend, as far as the arm can follow it.
    fn axes(&self) -> Vec<Axes> {
        let Curve::Blend(curve) = &self.span.curve else { unreachable!("the span of a blend") };
        let mut near = self.span.axes(&Model(self.arm), 0.0);
        let mut axes = Vec::new();
        for part in 0..=SAMPLES {
            match curve.axes(&Model(self.arm), part as f64 / SAMPLES as f64, &near) {
                Ok(next) => near = next,
                Err(_) => break,
            }
            axes.push(near);
        }
        axes
    }

    fn curve(&self) -> &BlendCurve {
        let Curve::Blend(curve) = &self.span.curve else { unreachable!("the span of a blend") };
        curve
    }

    fn tips(&self) -> Vec<IsometryMatrix3<f64>> {
        let tool = self.requests[1].tool;
        self.axes().iter().map(|axes| Model(self.arm).flange(axes) * tool).collect()
    }

    /// Ranges of σ of both nominal pieces: from the leave point to the corner, and from the corner to the reach point.
    fn pieces(&self) -> [(usize, f64, f64); 2] {
        [(0, self.parts[0].sigma, 1.0), (1, 0.0, self.parts[1].sigma)]
    }

    /// Values at points of both nominal pieces.
    fn on_pieces<T>(&self, value: impl Fn(&Segment, f64) -> Option<T>) -> Vec<T> {
        let mut values = Vec::new();
        for (side, from, to) in self.pieces() {
            let sigmas = (0..=SAMPLES).map(|part| from + (to - from) * part as f64 / SAMPLES as f64);
            values.extend(sigmas.filter_map(|sigma| value(&self.segments[side], sigma)));
        }
        values
    }

    /// Distance by which the axes leave the hull of the nominal pieces, relative to the longest side of the hull, and
    /// in degrees or mm.
    fn excess_of_axes(&self) -> (f64, f64) {
        let nominal = self.on_pieces(|segment, sigma| segment.axes(&Model(self.arm), sigma).ok());
        let [least, most] =
            nominal.iter().fold([nominal[0]; 2], |[least, most], axes| [least.inf(axes), most.sup(axes)]);
        let excess = self.axes().iter().map(|axes| (axes - most).sup(&(least - axes)).max()).fold(0.0, f64::max);
        (excess / (most - least).amax().max(1e-9), excess)
    }

    /// Distance in mm by which the tool centre point leaves the hull of the leave point, the corner and the reach
    /// point. For a circle, the hull includes the intersection of the tangents. The hull is evaluated in the directions
    /// from `directions`.
    fn excess_of_tip(&self) -> (f64, f64) {
        let hull: Vec<_> =
            self.pieces().into_iter().flat_map(|(side, from, to)| self.control_polygon(side, from, to)).collect();
        let tips = self.tips();
        let mut excess = 0.0_f64;
        for direction in directions() {
            let most = hull.iter().map(|point| point.dot(&direction)).fold(f64::NEG_INFINITY, f64::max);
            let outside = tips.iter().map(|tip| tip.translation.vector.dot(&direction) - most);
            excess = outside.fold(excess, f64::max);
        }
        let size = hull.iter().map(|point| (point - hull[0]).norm()).fold(0.0, f64::max);
        (excess, size)
    }

    fn control_polygon(&self, side: usize, from: f64, to: f64) -> Vec<Vector3<f64>> {
        let model = Model(self.arm);
        let segment = &self.segments[side];
        let at = |sigma: f64| segment.pose_at(&model, sigma).translation.vector;
        let [start, end] = [at(from), at(to)];
        if !segment.is_arc() {
            return vec![start, end];
        }
        // An arc of more than a third of a turn is divided, because its tangents intersect far away or not.
        let middle = at((from + to) / 2.0);
        let chord = (start + end) / 2.0;
        let [tall, half] = [(middle - chord).norm(), (end - start).norm() / 2.0];
        let half_turn = 2.0 * degrees::atan2(tall, half);
        if half_turn > 57.0 {
            let between = (from + to) / 2.0;
            let parts = [self.control_polygon(side, from, between), self.control_polygon(side, between, to)];
            return parts.concat();
        }
        let outward = (middle - chord).try_normalize(1e-12).unwrap_or_default();
        vec![start, chord + outward * half * degrees::tan(half_turn), end]
    }

    /// Whether a piece covers more than a quarter of a circle.
    fn has_wide_arc(&self) -> bool {
        self.pieces().into_iter().any(|(side, from, to)| {
            let at = |sigma: f64| self.segments[side].position(&Model(self.arm), sigma);
            let chord = at(to) - at(from);
            let middle = at((from + to) / 2.0) - at(from);
            self.segments[side].is_arc() && (middle - chord / 2.0).norm() > chord.norm() * 0.2
        })
    }

    /// Greatest rotation of the tool relative to the corner, in degrees: in the blend, and on the nominal pieces.
    fn turns(&self) -> [f64; 2] {
        let corner = self.segments[0].pose_at(&Model(self.arm), 1.0).rotation;
        let turn = |pose: &IsometryMatrix3<f64>| rotation::angle_between(&corner, &pose.rotation).to_degrees();
        let nominal = self.on_pieces(|segment, sigma| Some(turn(&segment.pose_at(&Model(self.arm), sigma))));
        [self.tips().iter().map(turn).fold(0.0, f64::max), nominal.into_iter().fold(0.0, f64::max)]
    }
}

/// Evenly distributed directions (golden spiral).
fn directions() -> Vec<Vector3<f64>> {
    const COUNT: usize = 400;
    const GOLDEN_ANGLE: f64 = 137.507_764_05;
    let directions = (0..COUNT).map(|index| {
        let z = 1.0 - 2.0 * (index as f64 + 0.5) / COUNT as f64;
        let (sin, cos) = degrees::sin_cos(index as f64 * GOLDEN_ANGLE);
        let radius = (1.0 - z * z).sqrt();
        Vector3::new(radius * cos, radius * sin, z)
    });
    directions.collect()
}

proptest! {
    #![proptest_config(cases())]

    #[test]
    fn a_joint_blend_stays_within_the_hull_of_its_nominal_pieces(program in programs()) {
        let (motion, requests) = program.record();
        let segments = segments(&program, &requests);
        for corner in corners(&motion, &requests, &segments).iter().filter(|corner| matches!(corner.curve(), BlendCurve::Joint(_))) {
            let (share, excess) = corner.excess_of_axes();
            prop_assert!(share < MARGIN + 1e-6 || excess < 1e-6, "{share} of the hull, {excess} at move {}", corner.parts[0].serial);
        }
    }

    #[test]
    fn a_cartesian_blend_stays_within_its_corner(program in programs()) {
        let (motion, requests) = program.record();
        let segments = segments(&program, &requests);
        let is_joint = |request: &Move| matches!(request.path, MovePath::Joint(_));
        for corner in corners(&motion, &requests, &segments).iter().filter(|corner| matches!(corner.curve(), BlendCurve::Pose(_))) {
            let [turn, nominal] = corner.turns();
            // On paths other than lines the orientation may return, and both pieces may differ from the corner at the
            // same time.
            let most = if corner.requests.iter().all(|request| matches!(request.path, MovePath::Line(_))) { nominal } else { 2.0 * nominal };
            prop_assert!(turn <= most + 1e-6, "{turn} degrees instead of {nominal} at move {}", corner.parts[0].serial);
            if !corner.requests.iter().any(|request| is_joint(request)) && !corner.has_wide_arc() {
                let (excess, size) = corner.excess_of_tip();
                // The tangents of a circle are outside of the circle.
                let tolerance = if corner.segments.iter().any(|segment| segment.is_arc()) { 0.02 * size } else { 0.0 };
                prop_assert!(excess < tolerance + 1e-6, "{excess} mm at move {}", corner.parts[0].serial);
            }
        }
    }

    #[test]
    fn leave_and_reach_are_exact_and_tangents_continuous(program in programs()) {
        let (motion, _) = program.record();
        let spans: Vec<_> = motion.timeline.spans.iter().collect();
        for pair in spans.windows(2).filter(|pair| !pair[1].begins_at_rest()) {
            let [before, after] = [&pair[0].span, &pair[1].span];
            let [end, start] = [before.axes(&Model(&motion.arm), before.range()[1]), after.axes(&Model(&motion.arm), after.range()[0])];
            prop_assert!((end - start).amax() < 1e-9);
            let directions = direction_at(&motion, before, true).zip(direction_at(&motion, after, false));
            let bend = directions.map_or(0.0, |(before, after)| (after - before).norm());
            prop_assert!(bend < 2e-2, "{bend} from {:?} to {:?}", before.part, after.part);
        }
    }
}

/// Direction of the axes at one span end; `None` if the move is so short that rounding errors dominate.
fn direction_at(motion: &Motion, span: &Span, at_end: bool) -> Option<Axes> {
    let model = Model(&motion.arm);
    let [from, to] = span.range();
    let step = (to - from) * 1e-5;
    let [one, other] = if at_end { [to - step, to] } else { [from, from + step] };
    (span.axes(&model, other) - span.axes(&model, one)).try_normalize(1e-10)
}
