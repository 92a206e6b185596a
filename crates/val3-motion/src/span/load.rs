//! Loads of a span: speeds and accelerations relative to their limits.

use val3_geometry::rotation;

use super::{Reduction, Span};
use crate::bounds::AxisMotion;
use crate::model::Model;
use crate::speed_limit::{PathState, SpeedLimit};

/// Half the distance over which the tool speed is measured, relative to the distance between two knots.
const NEARBY: f64 = 0.01;

impl Span {
    /// Limit with the greatest load, and this load, which is about 1 if the planner reaches a limit.
    ///
    /// The loads are compared with each other, not with a threshold, because the planner keeps a margin from speed
    /// limits that change between two knots.
    pub(crate) fn speed_limit(
        &self,
        model: &Model<'_>,
        state: &PathState,
        reduction: Option<&Reduction>,
    ) -> (SpeedLimit, f64) {
        let index = self.knot_before(state.p).0.min(self.len().saturating_sub(2));
        let loads = self.axis_loads(index, state).chain(self.tool_loads(model, state));
        let reduced = reduction.map(|reduction| (SpeedLimit::ReducedSpeed, (state.x / reduction.level(index)).sqrt()));
        let none = (SpeedLimit::NextMove, 0.0);
        loads.chain(reduced).fold(none, |most, next| if next.1 > most.1 { next } else { most })
    }

    fn axis_loads(&self, index: usize, state: &PathState) -> impl Iterator<Item = (SpeedLimit, f64)> {
        let ends = self.interval_ends.get(index).zip(self.interval_ends.get(index + 1));
        let share = (state.p - self.at_knot(index)) / self.step;
        let axes = ends.map(|(start, end)| start.towards(end, share).axes).unwrap_or_default();
        let (speeds, is_blend) = (self.limits.at(state.p).speed, self.is_blend());
        let (x, u) = (state.x, state.u);
        axes.into_iter().zip(speeds).enumerate().flat_map(move |(axis, (motion, speed))| {
            let of_speed = (SpeedLimit::AxisSpeed(axis), motion.tangent.abs() * x.sqrt() / speed);
            [of_speed, acceleration_load(axis, &motion, is_blend, x, u)]
        })
    }

    /// Loads by the tool speeds, measured around p over a short fraction of the knot distance. If the tool reverses on
    /// a blend, its speed at a constant ṗ changes strongly from one knot to the next.
    fn tool_loads(&self, model: &Model<'_>, state: &PathState) -> [(SpeedLimit, f64); 2] {
        let [first, last] = self.range();
        let [from, to] = [-NEARBY, NEARBY].map(|share| (state.p + share * self.step).clamp(first, last));
        let [start, end] = [from, to].map(|p| self.curve.tip(model, p, &self.axes(model, p), &self.tool));
        let (limits, rate) = (self.limits.at(state.p), state.x.sqrt() / (to - from));
        let way = (end.translation.vector - start.translation.vector).norm();
        let turn = rotation::angle_between(&start.rotation, &end.rotation).to_degrees();
        [
            (SpeedLimit::Translation, way * rate / limits.translation.0),
            (SpeedLimit::Rotation, turn * rate / limits.rotation.0),
        ]
    }
}

/// Axis load by the acceleration q′·u + q″·x.
fn acceleration_load(axis: usize, motion: &AxisMotion, is_blend: bool, x: f64, u: f64) -> (SpeedLimit, f64) {
    let (along, across) = (motion.tangent * u, motion.curvature * x);
    let acceleration = along + across;
    let speeds_up = acceleration * motion.tangent >= 0.0;
    let limit = match speeds_up {
        _ if is_blend && across.abs() > along.abs() => SpeedLimit::Corner,
        true => SpeedLimit::Acceleration(axis),
        false => SpeedLimit::Deceleration(axis),
    };
    (limit, acceleration.abs() / if speeds_up { motion.acceleration } else { motion.deceleration })
}
