//! Compliant moves: a force moves the arm along its path, forwards or back (manual 11.1, section (i) of the motion model).

use val3_geometry::{Vector3, rotation};
use val3_moves::{Percent, Seconds};

use crate::bounds::Bounds;
use crate::model::Model;
use crate::span::{Reduction, Span};

/// Acceleration of gravity in m/s²: the nominal force lifts the nominal load.
const GRAVITY: f64 = 9.81;

/// Lever arm in metres at which the load resists a rotation of the tool (model choice).
const LEVER: f64 = 0.1;

/// Force below which the arm does not move, as a fraction of the nominal force (model choice).
const STICTION: f64 = 0.02;

/// Speed below which the arm is at rest, as a fraction of the greatest speed.
const AT_REST: f64 = 1e-4;

/// Maximum step of the integration, in seconds.
const STEP: f64 = 0.001;

/// External force on the arm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ExternalForce {
    /// Force on the tool centre point, in N along the axes of `world`.
    World(Vector3<f64>),
    /// Force along the path of the move, in N.
    Path(f64),
}

impl Default for ExternalForce {
    fn default() -> Self {
        Self::Path(0.0)
    }
}

/// State of the arm on the path of a compliant move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Glide {
    pub(crate) p: f64,
    /// ṗ; negative for a backward motion.
    pub(crate) rate: f64,
}

/// Forces and speed limits of a cycle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Forces<'a> {
    /// Force command of the move.
    pub(crate) command: Percent,
    pub(crate) external: ExternalForce,
    /// Monitor speed; 1 for 100 %.
    pub(crate) pace: f64,
    /// Reduced speed limits; `None` at normal speed.
    pub(crate) reduction: Option<&'a Reduction>,
}

impl Glide {
    /// State at rest at the start of a span.
    pub(crate) fn at_start(span: &Span) -> Self {
        let [p, _] = span.range();
        Self { p, rate: 0.0 }
    }

    /// Advances by a duration, at most to the end of the span. Returns whether the arm has moved.
    pub(crate) fn advance(&mut self, model: &Model<'_>, span: &Span, forces: &Forces<'_>, duration: Seconds) -> bool {
        let (start, mut left) = (self.p, duration.0);
        let tangent = Tangent::at(model, span, start);
        let nominal_force = model.0.nominal_load() * GRAVITY;
        let share = forces.command.0 / 100.0 + tangent.along(&forces.external) / nominal_force;
        let share = if share.abs() < STICTION { 0.0 } else { share };
        while left > 0.0 {
            let step = left.min(STEP);
            let Some(bounds) = span.bounds_within(self.p, None, forces.reduction) else { break };
            self.step(span, &bounds, share, tangent.inertia, forces.pace, step);
            left -= step;
        }
        self.p != start
    }

    /// Advances by a number of seconds under a fraction of the nominal force.
    fn step(&mut self, span: &Span, bounds: &Bounds<'_>, share: f64, inertia: f64, pace: f64, seconds: f64) {
        let fastest = bounds.top().sqrt() * pace;
        // Implicit Euler step of M·p̈ = F - c·ṗ. The damping c is chosen so that the nominal force sustains the
        // greatest speed.
        let (target, lag) = (share * fastest, inertia * fastest / GRAVITY);
        let wanted = (self.rate * lag + target * seconds) / (lag + seconds);
        let x = self.rate * self.rate;
        let (least, most) = (bounds.lowest(x).min(0.0) * seconds, bounds.highest(x).max(0.0) * seconds);
        let mut rate = (self.rate + (wanted - self.rate).clamp(least, most)).clamp(-fastest, fastest);
        if share == 0.0 && rate.abs() <= fastest * AT_REST {
            rate = 0.0;
        }
        let [from, to] = span.range();
        let p = self.p + (self.rate + rate) / 2.0 * seconds;
        *self = Self { p: p.clamp(from, to), rate: if (from..=to).contains(&p) { rate } else { 0.0 } };
    }
}

/// Direction and inertia of the tool along the path.
struct Tangent {
    /// Direction of the tool centre point in world; zero for a rotation.
    direction: Vector3<f64>,
    /// Distance that the load moves per unit of p, in metres.
    inertia: f64,
}

impl Tangent {
    fn at(model: &Model<'_>, span: &Span, p: f64) -> Self {
        let [from, to] = span.range();
        let step = (to - from) * 1e-3;
        let [before, after] = [(p - step).max(from), (p + step).min(to)];
        let [start, end] = [before, after].map(|p| model.flange(&span.axes(model, p)) * span.tool);
        let way = end.translation.vector - start.translation.vector;
        let turn = rotation::angle_between(&start.rotation, &end.rotation);
        Self {
            direction: way.try_normalize(1e-9).unwrap_or_default(),
            inertia: (way.norm() / 1000.0 + turn * LEVER) / (after - before),
        }
    }

    /// Force component along the path, in N.
    fn along(&self, force: &ExternalForce) -> f64 {
        match force {
            ExternalForce::World(force) => force.dot(&self.direction),
            ExternalForce::Path(force) => *force,
        }
    }
}
