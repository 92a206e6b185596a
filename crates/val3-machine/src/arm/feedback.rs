//! Measured position and forces of the arm (10.6, section (j) of the motion model): it follows its commands with a lag.

use val3_geometry::{IsometryMatrix3, Vector3};
use val3_kinematics::{Arm, Joints};
use val3_lang::ports::Time;
use val3_vm::CYCLE;

use crate::event::seconds;

/// Time constant of the lag, in seconds (model choice).
const LAG: f64 = 0.008;

/// Maximum position error of an axis that is in place, in degrees or mm: 1 % of the maximum position error (model
/// choice).
const IN_PLACE: f64 = 0.01;

/// Time in place after which the arm counts as settled (10.6).
const SETTLING: Time = 50_000_000;

/// Lags below this value are set to 0.
const NO_LAG: f64 = 1e-9;

/// Acceleration of gravity, in mm/s².
const GRAVITY: f64 = 9810.0;

/// Mass of the links, as a multiple of the nominal load, and each link's share (model choice after the published masses
/// of TX60, TX90 and RX160).
const MASS: f64 = 6.0;
const SHARES: [f64; 6] = [0.38, 0.31, 0.19, 0.11, 0.009, 0.001];

/// The last commands and the measured position.
#[derive(Debug, Clone)]
pub(super) struct Feedback {
    /// Commands of the last three cycles, the newest first.
    commanded: [Joints; 3],
    measured: Joints,
    in_place: Time,
}

impl Feedback {
    /// Arm that rests at these joints.
    pub(super) fn at(joints: Joints) -> Self {
        Self { commanded: [joints; 3], measured: joints, in_place: SETTLING }
    }

    /// Advances by one cycle, at whose end the arm is commanded to be at these joints.
    pub(super) fn advance(&mut self, joints: Joints) {
        let [before, earlier, _] = self.commanded;
        self.commanded = [joints, before, earlier];
        let cycle = seconds(CYCLE);
        let decay = libm::exp(-cycle / LAG);
        for ((measured, now), before) in self.measured.iter_mut().zip(joints).zip(before) {
            // The response of the lag to a command that changes evenly.
            let lag = LAG * (now - before) / cycle;
            let error = (before - *measured - lag) * decay + lag;
            *measured = if error.abs() < NO_LAG { now } else { now - error };
        }
        let is_in_place = joints == before && self.error().iter().all(|error| error.abs() < IN_PLACE);
        self.in_place = if is_in_place { self.in_place.saturating_add(CYCLE) } else { 0 };
    }

    /// Axis positions measured by the encoders.
    pub(super) fn measured(&self) -> Joints {
        self.measured
    }

    /// Commanded minus measured position.
    fn error(&self) -> Joints {
        let [commanded, ..] = self.commanded;
        std::array::from_fn(|axis| difference(&commanded, &self.measured, axis))
    }

    /// Whether the arm has settled (`isSettled`).
    pub(super) fn is_settled(&self) -> bool {
        self.in_place >= SETTLING
    }

    /// Whether the command did not change in the last cycle.
    pub(super) fn is_at_rest(&self) -> bool {
        let [now, before, _] = self.commanded;
        now == before
    }

    /// Whether the state is constant without a new command.
    pub(super) fn is_quiet(&self) -> bool {
        let [commanded, ..] = self.commanded;
        self.is_settled() && self.measured == commanded
    }

    /// The commanded speed of a tool centre point over the last cycle, in mm/s.
    pub(super) fn speed(&self, arm: &Arm, tool: &IsometryMatrix3<f64>) -> f64 {
        let [now, before, _] = &self.commanded;
        let [now, before] = [now, before].map(|joints| (arm.flange(joints) * tool).translation.vector);
        (now - before).norm() / seconds(CYCLE)
    }

    /// Axis torques in Nm, for a linear axis the force in N: weight and inertia of the links, each link as a mass in
    /// its middle.
    pub(super) fn force(&self, arm: &Arm) -> Joints {
        let mass = MASS * arm.nominal_load();
        let [now, before, earlier] = self.commanded.map(|joints| centres(arm, &joints));
        let cycle = seconds(CYCLE);
        let loads: Vec<Vector3<f64>> = (0..now.len())
            .filter_map(|link| {
                let [now, before, earlier] = [now.get(link)?, before.get(link)?, earlier.get(link)?];
                let acceleration = (now - before * 2.0 + earlier) / (cycle * cycle);
                Some((acceleration + Vector3::z() * GRAVITY) * (mass * SHARES.get(link)?))
            })
            .collect();
        let [joints, ..] = self.commanded;
        std::array::from_fn(|axis| if axis < arm.axes() { work(arm, &joints, axis, &loads) } else { 0.0 })
    }
}

/// Signed axis distance between two joint positions.
pub(super) fn difference(left: &Joints, right: &Joints, axis: usize) -> f64 {
    left.get(axis).copied().unwrap_or_default() - right.get(axis).copied().unwrap_or_default()
}

/// Centres of the links, in `world`.
fn centres(arm: &Arm, joints: &Joints) -> Vec<Vector3<f64>> {
    let frames = arm.links(joints);
    let ends: Vec<_> = frames.iter().map(|frame| frame.translation.vector).collect();
    ends.windows(2).map(|pair| pair.iter().sum::<Vector3<f64>>() / 2.0).collect()
}

/// Work of the loads per unit of axis motion, as torque in Nm or force in N.
fn work(arm: &Arm, joints: &Joints, axis: usize, loads: &[Vector3<f64>]) -> f64 {
    const STEP: f64 = 1e-4;
    let [ahead, behind] = [STEP, -STEP].map(|by| centres(arm, &moved(joints, axis, by)));
    let step = if arm.is_stroke(axis) { STEP } else { STEP.to_radians() };
    let ways = ahead.iter().zip(&behind).map(|(ahead, behind)| (ahead - behind) / (2.0 * step));
    let work: f64 = ways.zip(loads).map(|(way, load)| way.dot(load)).sum();
    // 1 Nm = 1e6 kg mm²/s², 1 N = 1e3 kg mm/s².
    work / if arm.is_stroke(axis) { 1e3 } else { 1e6 }
}

/// Joint position with one axis moved.
fn moved(joints: &Joints, axis: usize, by: f64) -> Joints {
    let mut joints = *joints;
    if let Some(position) = joints.get_mut(axis) {
        *position += by;
    }
    joints
}

#[cfg(test)]
mod tests {
    use super::*;

    const START: Joints = [0.0, 0.0, 90.0, 0.0, 90.0, 0.0];

    fn arm() -> Arm {
        Arm::by_name("TX2-90").unwrap()
    }

    fn turned(angle: f64) -> Joints {
        let [_, rest @ ..] = START;
        let [j2, j3, j4, j5, j6] = rest;
        [angle, j2, j3, j4, j5, j6]
    }

    #[test]
    fn the_lag_of_an_even_motion_is_its_time_constant() {
        let mut feedback = Feedback::at(START);
        for cycle in 1..=100 {
            feedback.advance(turned(f64::from(cycle) * 0.4));
        }
        // 100 degrees a second.
        assert!((feedback.error()[0] - 100.0 * LAG).abs() < 1e-4, "{:?}", feedback.error());
        assert_eq!(feedback.error()[1..], [0.0; 5]);
    }

    #[test]
    fn an_arm_settles_between_50_and_100_ms_after_its_command() {
        let mut feedback = Feedback::at(START);
        for cycle in 1..=50 {
            feedback.advance(turned(f64::from(cycle) * 0.4));
        }
        let end = turned(20.0);
        assert!(!feedback.is_settled() && !feedback.is_at_rest());
        let settled = (1..).find(|_| {
            feedback.advance(end);
            feedback.is_settled()
        });
        assert!((13..=25).contains(&settled.unwrap()), "{settled:?}");
        let quiet = (1..100).find(|_| {
            feedback.advance(end);
            feedback.is_quiet()
        });
        assert!(quiet.is_some() && feedback.measured() == end);
    }

    #[test]
    fn the_speed_is_that_of_the_tool() {
        let mut feedback = Feedback::at(START);
        feedback.advance(turned(0.4));
        let radius = arm().forward(&START).translation().xy().norm();
        let flange = feedback.speed(&arm(), &IsometryMatrix3::identity());
        assert!((flange - 100_f64.to_radians() * radius).abs() < 0.01, "{flange}");
        let tool = IsometryMatrix3::translation(0.0, 0.0, 200.0);
        assert!((feedback.speed(&arm(), &tool) - flange).abs() < 1e-6);
    }

    #[test]
    fn a_stretched_arm_is_heavy_and_an_upright_one_is_not() {
        let force = |joints| Feedback::at(joints).force(&arm());
        let upright = force([0.0; 6]);
        assert!(upright.iter().all(|torque| torque.abs() < 5.0), "{upright:?}");
        let stretched = force([0.0, 90.0, 0.0, 0.0, 0.0, 0.0]);
        assert!(stretched[1] < -20.0 && stretched[0].abs() < 1e-6, "{stretched:?}");
        assert!(stretched[1].abs() > stretched[2].abs() && stretched[2].abs() > stretched[4].abs());
    }

    #[test]
    fn a_rising_stroke_carries_its_weight() {
        let arm = Arm::by_name("TS2-60").unwrap();
        let force = Feedback::at([0.0, 10.0, 50.0, 0.0, 0.0, 0.0]).force(&arm);
        assert!(force[2] > 1.0 && force[0].abs() < 1e-6, "{force:?}");
    }
}
