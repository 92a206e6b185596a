//! Random programs during which the tool speed limit is set and removed.

use proptest::prelude::*;

use super::path_independence::{deviation, reference, requests, step};
use super::*;

/// Limit in mm/s.
const LIMIT: MillimetresPerSecond = MillimetresPerSecond(250.0);

/// Limit in mm/s plus the error between two knots: at most 0.011 mm/s in 20,000 programs.
const MOST: f64 = 250.02;

/// Runs a program. Every 25 cycles, a choice sets the limit, removes it or changes nothing.
fn follow(reference: &Motion, requests: &[Move], choices: &[u8]) -> Result<(), TestCaseError> {
    let mut motion = motion();
    requests.iter().try_for_each(|request| motion.record(request)).unwrap();
    motion.close().unwrap();
    let (mut is_limited, mut is_slow) = (false, false);
    for cycle in 0..50_000 {
        let choice = choices[cycle / 25 % choices.len()];
        if cycle % 25 == 0 && choice < 2 {
            is_limited = choice == 0;
            motion.limit_tool_speed(is_limited.then_some(LIMIT));
        }
        let sample = motion.advance(CYCLE);
        // If the arm is too fast, it brakes first.
        is_slow = is_limited && (is_slow || sample.phase != MotionPhase::Stopping && sample.speed.0 <= MOST);
        prop_assert!(!is_slow || sample.speed.0 <= MOST, "cycle {cycle}: {:?} mm/s", sample.speed);
        prop_assert!(deviation(reference, &motion) < 1e-5, "cycle {cycle}");
        if motion.is_empty() {
            let [arrived, destination] = [motion.joints(), reference.destination()].map(Axes::from);
            prop_assert!((arrived - destination).amax() < 1e-9);
            return Ok(());
        }
    }
    Err(TestCaseError::fail("the arm does not arrive"))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn the_limit_changes_speeds_and_no_path(
        steps in prop::collection::vec(step(), 1..6),
        choices in prop::collection::vec(0..6_u8, 1..12),
    ) {
        let requests = requests(&steps, 100.0);
        if let Some(reference) = reference(&requests) {
            follow(&reference, &requests, &choices)?;
        }
    }
}
