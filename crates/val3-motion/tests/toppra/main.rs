//! Comparison of motion durations with toppra, which computes time-optimal speeds along the same paths.
//!
//! `durations.csv` contains the results of `durations.py`, which reads the paths from the test `export`:
//! ```text
//! cargo test -p val3-motion --test toppra -- --ignored
//! pip install toppra && python crates/val3-motion/tests/toppra/durations.py target/tmp/toppra
//! ```

#![allow(missing_docs, reason = "tests are named by their functions")]
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test may fail loudly")]

mod cases;

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

use val3_motion::{MotionPhase, Sample, Seconds, SpeedLimits};

use cases::Case;

/// Durations by toppra, as `case,seconds`.
const DURATIONS: &str = include_str!("durations.csv");

/// Number of samples in an exported path.
const SAMPLES: f64 = 6000.0;

const CYCLE: f64 = 0.004;

#[test]
fn motions_take_the_shortest_time_that_their_limits_allow() {
    let rows = DURATIONS.lines().filter_map(|row| row.split_once(','));
    let expected: BTreeMap<_, f64> = rows.map(|(name, seconds)| (name, seconds.parse().unwrap())).collect();
    let mut wrong = String::new();
    for case in cases::all() {
        let time = case.motion().time_left().0;
        let Some(expected) = expected.get(case.name.as_str()) else { panic!("no duration for {}", case.name) };
        let off = time - expected;
        println!("{:60} {time:.5} {expected:.5} {:+.3} %", case.name, 100.0 * off / expected);
        if off.abs() > 0.003 * expected + CYCLE {
            writeln!(wrong, "{}: {time} s instead of {expected} s", case.name).unwrap();
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
#[ignore = "writes the paths that `durations.py` reads"]
fn export() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("toppra");
    std::fs::create_dir_all(&folder).unwrap();
    for case in cases::all() {
        std::fs::write(folder.join(&case.name).with_extension("csv"), path(&case)).unwrap();
    }
}

/// Samples at equal time steps, each with the number of its piece between corners and the applicable limits.
fn samples(case: &Case, count: f64) -> (f64, Vec<(usize, Sample, SpeedLimits)>) {
    let mut motion = case.motion();
    let step = motion.time_left().0 / count;
    let (mut piece, mut phase, mut last_nominal) = (0, MotionPhase::Nominal, 0);
    let mut samples = Vec::new();
    while !motion.is_empty() {
        let sample = motion.advance(Seconds(step));
        piece += usize::from(sample.phase != phase);
        phase = sample.phase;
        let index = sample.id.floor() as usize;
        let limits = if phase == MotionPhase::Blend {
            corner_limits(case, index, if index == last_nominal { index + 1 } else { index - 1 })
        } else {
            last_nominal = index;
            *case.limits(index)
        };
        samples.push((piece, sample, limits));
    }
    (step, samples)
}

/// Limits in a blend: the lower speeds of both moves, and the accelerations of the nearer move.
fn corner_limits(case: &Case, index: usize, other: usize) -> SpeedLimits {
    let (mut limits, other) = (*case.limits(index), case.limits(other));
    limits.speed.iter_mut().zip(other.speed).for_each(|(speed, other)| *speed = speed.min(other));
    limits.translation.0 = limits.translation.0.min(other.translation.0);
    limits.rotation.0 = limits.rotation.0.min(other.rotation.0);
    limits
}

/// CSV with one row per sample: piece number, axis positions, position and rotation matrix of the tool centre point,
/// limits.
fn path(case: &Case) -> String {
    let mut text = String::new();
    for (piece, sample, limits) in samples(case, SAMPLES).1 {
        let place = sample.pose.translation.vector;
        let rotation = sample.pose.rotation.matrix().transpose();
        let axes = case.axes();
        let numbers = sample.joints[..axes].iter().chain(place.iter()).chain(rotation.iter());
        let numbers = numbers.chain(&limits.speed[..axes]).chain(&limits.acceleration[..axes]);
        let numbers = numbers.chain(&limits.deceleration[..axes]);
        write!(text, "{piece}").unwrap();
        for number in numbers.chain(&[limits.translation.0, limits.rotation.0]) {
            write!(text, ",{number}").unwrap();
        }
        text.push('\n');
    }
    text
}

/// At almost any time one limit is reached within 2 %, so the motion cannot be faster. Between two knots, a speed is
/// below a limit that bends.
#[test]
fn a_limit_is_reached_at_any_time() {
    let used = cases::all().iter().flat_map(|case| uses(case, 2000.0)).collect::<Vec<_>>();
    let reached = used.iter().filter(|used| **used > 0.98).count() as f64 / used.len() as f64;
    assert!(reached > 0.96, "{reached}");
}

/// The planner limits the mean acceleration between two knots, so the acceleration over two cycles may exceed the limit
/// slightly.
#[test]
fn limits_are_kept_from_cycle_to_cycle() {
    for case in cases::all() {
        let used = uses(&case, case.motion().time_left().0 / CYCLE);
        let most = used.iter().copied().fold(0.0, f64::max);
        assert!(most < 1.03, "{}: {most}", case.name);
    }
}

/// Greatest load at `count` samples, except at samples where the limits change.
fn uses(case: &Case, count: f64) -> Vec<f64> {
    let (step, samples) = samples(case, count);
    let in_one_piece =
        |window: &&[(usize, Sample, SpeedLimits)]| (window[0].0, &window[0].2) == (window[2].0, &window[2].2);
    samples.windows(3).filter(in_one_piece).map(|window| used(window, step, case.axes())).collect()
}

/// Greatest load that follows from three samples.
fn used(window: &[(usize, Sample, SpeedLimits)], step: f64, axes: usize) -> f64 {
    let [(_, before, _), (_, here, limits), (_, after, _)] = window else { return 0.0 };
    let turn = after.pose.rotation.angle_to(&here.pose.rotation).to_degrees() / step / limits.rotation.0;
    let mut used = (after.speed.0 / limits.translation.0).max(turn);
    for axis in 0..axes {
        let [before, here, after] = [before, here, after].map(|sample| sample.joints[axis]);
        let (speed, change) = ((after - here) / step, (after - 2.0 * here + before) / step.powi(2));
        let limit = if speed * change > 0.0 { limits.acceleration[axis] } else { limits.deceleration[axis] };
        used = used.max(speed.abs() / limits.speed[axis]).max(change.abs() / limit);
    }
    used
}
