//! Accelerations between cycles, and the end of a run.

use super::*;

/// Runs a motion to its end. Returns each axis' greatest acceleration between cycles, relative to its limit.
fn greatest_accelerations(motion: &mut Motion, limits: &SpeedLimits) -> Joints {
    let mut samples = vec![motion.joints(); 2];
    for _ in 0..(motion.time_left().0 / CYCLE.0) as usize + 3 {
        samples.push(motion.advance(CYCLE).joints);
    }
    std::array::from_fn(|axis| {
        let limit = limits.acceleration[axis].max(limits.deceleration[axis]);
        let changes = samples.windows(3).map(|three| (three[2][axis] - 2.0 * three[1][axis] + three[0][axis]).abs());
        changes.fold(0.0, f64::max) / CYCLE.0.powi(2) / limit
    })
}

/// Near the straight arm, axes are locally fast without bound. With equidistant knots, axis 3 reached twice its maximum
/// acceleration.
#[test]
fn accelerations_are_kept_next_to_the_straight_arm() {
    for elbow in [0.1, 0.3, 0.5, 1.0, 1.5, 2.0] {
        for length in [1.0, 50.0, 280.0] {
            let start = [0.0, 40.0, elbow, 0.0, 60.0, 0.0];
            let mut inward = arm().flange(&start);
            inward.translation.vector -= Vector3::new(length, 0.0, length);
            let mut motion = Motion::new(Arc::new(arm()), start);
            let there = line(arm().flange(&start));
            for (path, id) in [line(inward), there].into_iter().zip(0..) {
                motion.record(&request(path, fast(), Blend::Off, f64::from(id))).unwrap();
            }
            let used = greatest_accelerations(&mut motion, &fast());
            assert!(motion.is_empty() && used.iter().all(|used| *used < 1.01), "{used:?} from {elbow} degrees");
        }
    }
}

proptest! {
    #![proptest_config(cases())]

    /// Between cycles, no axis exceeds its acceleration by more than 2 %, and the run ends.
    #[test]
    fn accelerations_are_kept_at_every_cycle(program in programs()) {
        let (mut motion, _) = program.record();
        let axes = program.arm().limits().len();
        let has_fault = motion.fault().is_some();
        prop_assert!(motion.time_left().0.is_finite());
        let used = greatest_accelerations(&mut motion, &program.limits());
        prop_assert!(has_fault || motion.is_empty());
        prop_assert!(used.iter().take(axes).all(|used| *used < 1.02), "{used:?} of the accelerations");
    }
}
