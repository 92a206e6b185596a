//! Accelerations from cycle to cycle, and the end of a run.

use super::*;

proptest! {
    #![proptest_config(cases())]

    /// From cycle to cycle no axis exceeds its acceleration by more than 2 %, and a run ends.
    #[test]
    fn accelerations_are_kept_at_every_cycle(program in programs()) {
        let (mut motion, _) = program.record();
        let (arm, limits) = (program.arm(), program.limits());
        let has_fault = motion.fault().is_some();
        let time = motion.time_left().0;
        prop_assert!(time.is_finite());
        let mut samples = vec![motion.joints(); 2];
        for _ in 0..(time / CYCLE.0) as usize + 3 {
            samples.push(motion.advance(CYCLE).joints);
        }
        prop_assert!(has_fault || motion.is_empty());
        for three in samples.windows(3) {
            let limits = limits.acceleration.iter().zip(limits.deceleration);
            for (axis, (up, down)) in limits.enumerate().take(arm.limits().len()) {
                let [before, here, after] = [0, 1, 2].map(|sample: usize| three[sample][axis]);
                let change = (after - 2.0 * here + before).abs() / CYCLE.0.powi(2);
                let used = change / up.max(down);
                prop_assert!(used < 1.02, "{used} of the acceleration of axis {}", axis + 1);
            }
        }
    }
}
