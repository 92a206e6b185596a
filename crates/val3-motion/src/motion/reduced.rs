//! Reduced tool speed, as in manual mode.

use std::sync::Arc;

use val3_moves::MillimetresPerSecond;

use super::Motion;
use crate::model::Model;
use crate::span::Span;
use crate::timeline::TimedSpan;

impl Motion {
    /// Limits the speed of the tool centre point and of the flange; `None` removes the limit. The path does not change.
    ///
    /// The limit applies at full monitor speed, and a lower monitor speed reduces it in proportion. If the limit
    /// decreases while the arm moves, the arm first brakes to rest on its path and then continues automatically.
    pub fn limit_tool_speed(&mut self, limit: Option<MillimetresPerSecond>) {
        if let Some(motion) = self.moving_away() {
            motion.limit_tool_speed(limit);
        }
        let before = std::mem::replace(&mut self.tool_speed, limit);
        if before == limit {
            return;
        }
        let is_lower = limit.is_some_and(|limit| before.is_none_or(|before| limit < before));
        if is_lower && self.timeline.rate() > 0.0 {
            self.halt_as_planned();
        }
        let spans = std::mem::take(&mut self.timeline.spans);
        self.timeline.spans = spans.into_iter().map(|timed| self.reduced(timed)).collect();
        self.timeline.replan();
    }

    /// Converts a span for the timeline, with the current tool speed limit.
    pub(super) fn timed(&self, span: Arc<Span>, from_rest: bool) -> TimedSpan {
        self.reduced(TimedSpan::new(span, from_rest))
    }

    fn reduced(&self, timed: TimedSpan) -> TimedSpan {
        let reduction = self.tool_speed.map(|speed| timed.span.reduction(&Model(&self.arm), speed));
        TimedSpan { reduction, ..timed }
    }
}

#[cfg(test)]
mod tests {
    use val3_geometry::{IsometryMatrix3, Trsf, Vector3};
    use val3_kinematics::Joints;

    use super::super::tests::{CYCLE, START, fast, line, motion, moved, request};
    use super::*;
    use crate::{Blend, ExternalForce, Jog, Manner, Millimetres, MotionPhase, Move, MovePath, Percent, Seconds};

    const LIMIT: Option<MillimetresPerSecond> = Some(MillimetresPerSecond(250.0));
    /// The limit with a rounding tolerance, in mm/s.
    const MOST: f64 = 250.001;
    const TURNED: Joints = [60.0, 20.0, 70.0, 40.0, 90.0, 170.0];

    /// A tool whose centre point is 150 mm off axis 6.
    fn tool() -> IsometryMatrix3<f64> {
        Trsf::new([150.0, 0.0, 80.0], [0.0; 3]).isometry()
    }

    fn program() -> Vec<Move> {
        let rounded = Blend::Cartesian { leave: Millimetres(40.0), reach: Millimetres(30.0) };
        let corner = Blend::Joint { leave: Millimetres(30.0), reach: Millimetres(50.0) };
        let paths = [
            (line(moved(0.0, 150.0, 0.0) * tool()), rounded),
            (line(moved(0.0, 150.0, 100.0) * tool()), corner),
            (MovePath::Joint(TURNED), corner),
            (MovePath::Joint(START), Blend::Off),
        ];
        let move_of = |((path, blend), id)| Move { tool: tool(), ..request(path, fast(), blend, f64::from(id)) };
        paths.into_iter().zip(0..).map(move_of).collect()
    }

    fn recorded(limit: Option<MillimetresPerSecond>) -> Motion {
        let mut motion = motion();
        motion.limit_tool_speed(limit);
        program().iter().for_each(|request| motion.record(request).unwrap());
        motion
    }

    /// Advances by one cycle and returns the speeds of the tool centre point and the flange, in mm/s.
    fn speeds(motion: &mut Motion) -> [f64; 2] {
        let before = tip_and_flange(motion);
        motion.advance(CYCLE);
        let after = tip_and_flange(motion);
        [(after[0] - before[0]).norm() / CYCLE.0, (after[1] - before[1]).norm() / CYCLE.0]
    }

    fn tip_and_flange(motion: &Motion) -> [Vector3<f64>; 2] {
        let flange = Model(&motion.arm).flange(&motion.joints().into());
        [(flange * tool()).translation.vector, flange.translation.vector]
    }

    fn fastest(motion: &mut Motion, cycles: usize) -> [f64; 2] {
        let all = (0..cycles).map(|_| speeds(motion));
        all.fold([0.0; 2], |most, [tip, flange]| [tip.max(most[0]), flange.max(most[1])])
    }

    fn cycles_to_the_end(mut motion: Motion) -> usize {
        let mut cycles = 0;
        while !motion.is_empty() {
            motion.advance(CYCLE);
            cycles += 1;
            assert!(cycles < 20_000, "{:?}", motion.joints());
        }
        cycles
    }

    #[test]
    fn neither_the_tool_nor_the_flange_exceeds_the_limit() {
        assert!(fastest(&mut recorded(None), 2_000).iter().all(|speed| *speed > 900.0));
        let mut slow = recorded(LIMIT);
        let [tip, flange] = fastest(&mut slow, 4_000);
        assert!((245.0..=MOST).contains(&tip) && (200.0..=MOST).contains(&flange), "{tip} {flange}");
        assert_eq!((slow.joints(), slow.is_empty()), (START, true));
        // Without a tool, a rotation of axis 6 moves neither the flange nor the tool centre point, so the limit has no
        // effect.
        let mut spin = motion();
        spin.limit_tool_speed(LIMIT);
        let turn = MovePath::Joint([0.0, 0.0, 90.0, 0.0, 90.0, 180.0]);
        spin.record(&request(turn, fast(), Blend::Off, 0.0)).unwrap();
        assert!(cycles_to_the_end(spin) < 150);
    }

    #[test]
    fn the_path_is_the_same() {
        let (fast, mut slow) = (recorded(None), recorded(LIMIT));
        let spans: Vec<_> = fast.timeline.spans.iter().map(|timed| timed.span.clone()).collect();
        for (timed, full) in slow.timeline.spans.iter().zip(&spans) {
            let ([from, to], model) = (full.range(), Model(&slow.arm));
            assert_eq!(timed.span.range(), [from, to]);
            for part in 0..=100 {
                let p = from + (to - from) * f64::from(part) / 100.0;
                assert_eq!(timed.span.axes(&model, p), full.axes(&model, p));
            }
        }
        assert_eq!(spans.len(), slow.timeline.spans.len());
        slow.advance(CYCLE);
    }

    #[test]
    fn an_arm_that_is_too_fast_brakes_and_continues_at_reduced_speed() {
        let mut motion = recorded(None);
        let [tip, _] = fastest(&mut motion, 40);
        assert!(tip > 500.0, "{tip}");
        motion.limit_tool_speed(LIMIT);
        let (mut before, mut phases) = (speeds(&mut motion)[0], vec![MotionPhase::Nominal]);
        while motion.is_moving() {
            phases.push(motion.phase());
            let now = speeds(&mut motion)[0];
            // The speed decreases by at most 20 m/s² × 4 ms per cycle.
            assert!(now <= before && before - now < 80.0, "{before} {now}");
            before = now;
        }
        phases.dedup();
        assert_eq!(phases, [MotionPhase::Nominal, MotionPhase::Stopping]);
        let rest = fastest(&mut motion, 4_000);
        assert!(rest.iter().all(|speed| (100.0..=MOST).contains(speed)), "{rest:?}");
        assert!(motion.is_empty());
    }

    #[test]
    fn without_the_limit_the_arm_accelerates_on_its_way() {
        let (full, reduced) = (cycles_to_the_end(recorded(None)), cycles_to_the_end(recorded(LIMIT)));
        let mut motion = recorded(LIMIT);
        fastest(&mut motion, 100);
        motion.limit_tool_speed(None);
        let mut slowest = f64::MAX;
        for _ in 0..20 {
            slowest = slowest.min(speeds(&mut motion)[0]);
        }
        assert!(slowest > 200.0, "{slowest}");
        let cycles = 120 + cycles_to_the_end(motion);
        assert!(full < cycles && cycles + 100 < reduced, "{full} {cycles} {reduced}");
    }

    #[test]
    fn the_monitor_speed_reduces_the_limit_in_proportion() {
        let mut motion = recorded(LIMIT);
        motion.set_monitor_speed(Percent(10.0));
        let [tip, _] = fastest(&mut motion, 2_000);
        assert!((24.0..=MOST / 10.0).contains(&tip), "{tip}");
    }

    #[test]
    fn an_arm_moved_by_hand_and_its_way_back_keep_the_limit() {
        let mut motion = recorded(LIMIT);
        fastest(&mut motion, 50);
        motion.brake();
        fastest(&mut motion, 100);
        let jog = Jog::Joints([100.0, 0.0, 0.0, 0.0, 0.0, 300.0]);
        let mut most: [f64; 2] = [0.0; 2];
        for _ in 0..100 {
            motion.jog(&jog, CYCLE).unwrap();
            let [tip, flange] = speeds(&mut motion.clone());
            assert_eq!([tip, flange], [0.0; 2]);
            let before = motion.commanded;
            motion.jog(&jog, CYCLE).unwrap();
            let ways = [tool(), IsometryMatrix3::identity()].map(|tool| {
                let [from, to] = [before, motion.commanded].map(|axes| Model(&motion.arm).flange(&axes) * tool);
                (to.translation.vector - from.translation.vector).norm() / CYCLE.0
            });
            most = [most[0].max(ways[0]), most[1].max(ways[1])];
        }
        assert!(most.iter().all(|speed| (150.0..=MOST).contains(speed)), "{most:?}");
        motion.resume();
        motion.connect().unwrap();
        let back = fastest(&mut motion, 6_000);
        assert!(back.iter().all(|speed| (100.0..=MOST).contains(speed)), "{back:?}");
        assert!(motion.is_empty());
    }

    #[test]
    fn a_compliant_move_keeps_the_limit() {
        let mut motion = motion();
        let path = line(moved(0.0, 300.0, 0.0) * tool());
        let compliant = Manner::Compliant(Percent(100.0));
        motion.record(&Move { tool: tool(), manner: compliant, ..request(path, fast(), Blend::Off, 0.0) }).unwrap();
        motion.set_external_force(ExternalForce::Path(100.0));
        let mut slow = motion.clone();
        slow.limit_tool_speed(LIMIT);
        assert!(fastest(&mut motion, 1_000)[0] > 400.0);
        let [tip, flange] = fastest(&mut slow, 1_000);
        assert!((240.0..=250.5).contains(&tip) && flange <= 250.5, "{tip} {flange}");
        assert!(slow.is_empty());
    }

    #[test]
    fn a_forgotten_path_is_braked_on_as_before() {
        let mut motion = recorded(None);
        fastest(&mut motion, 40);
        motion.limit_tool_speed(LIMIT);
        motion.reset();
        motion.advance(Seconds(1.0));
        assert!(motion.is_empty() && !motion.is_moving());
    }
}
