//! Expected times from section (e) of the motion model, and properties of the path.

use std::sync::LazyLock;

use val3_geometry::{IsometryMatrix3, Trsf};
use val3_kinematics::RequestedConfiguration;

use super::*;
use crate::{Blend, DegreesPerSecond, Millimetres, MovePath, MoveTarget, SpeedLimits};

pub(super) const CYCLE: Seconds = Seconds(0.004);
const NOMINAL: [f64; 6] = [265.0, 210.0, 315.0, 450.0, 370.0, 630.0];
pub(super) const START: Joints = [0.0, 0.0, 90.0, 0.0, 90.0, 0.0];

fn limits(vel: f64, accel: f64, decel: f64, tvel: f64) -> SpeedLimits {
    SpeedLimits {
        speed: NOMINAL.map(|speed| speed * vel / 100.0),
        acceleration: NOMINAL.map(|speed| 5.0 * speed * accel / 100.0),
        deceleration: NOMINAL.map(|speed| 5.0 * speed * decel / 100.0),
        translation: MillimetresPerSecond(tvel),
        rotation: DegreesPerSecond(99999.0),
    }
}

pub(super) fn fast() -> SpeedLimits {
    limits(100.0, 100.0, 100.0, 99999.0)
}

pub(super) fn request(path: MovePath, limits: SpeedLimits, blend: Blend, id: f64) -> Move {
    Move { path, tool: IsometryMatrix3::identity(), limits, blend, id, manner: Manner::Rigid }
}

pub(super) fn line(pose: IsometryMatrix3<f64>) -> MovePath {
    MovePath::Line(MoveTarget { pose, configuration: RequestedConfiguration::FREE })
}

/// The arm file is read once, because property tests create the arm thousands of times.
fn arm() -> Arm {
    static ARM: LazyLock<Arm> = LazyLock::new(|| Arm::by_name("TX2-90").unwrap());
    ARM.clone()
}

pub(super) fn motion() -> Motion {
    Motion::new(Arc::new(arm()), START)
}

pub(super) fn moved(x: f64, y: f64, z: f64) -> IsometryMatrix3<f64> {
    let start = arm().forward(&START);
    Trsf { x: start.x + x, y: start.y + y, z: start.z + z, ..start }.isometry()
}

#[track_caller]
fn assert_time(path: MovePath, limits: SpeedLimits, expected: f64) {
    let mut motion = motion();
    motion.record(&request(path, limits, Blend::Off, 0.0)).unwrap();
    let time = motion.time_left().0;
    assert!((time - expected).abs() < 0.003 * expected + 0.004, "{time} instead of {expected}");
}

#[test]
fn joint_moves_take_the_time_of_the_oracle() {
    let turned = [90.0, 0.0, 90.0, 0.0, 90.0, 0.0];
    assert_time(MovePath::Joint(turned), fast(), 0.539623);
    assert_time(MovePath::Joint(turned), limits(50.0, 100.0, 100.0, 99999.0), 0.779245);
    assert_time(MovePath::Joint(turned), limits(100.0, 50.0, 100.0, 99999.0), 0.639623);
    // Mostly at the maximum speed, which is reached after 0.07 degrees: 90 / 13.25 + 13.25 / 1325.
    assert_time(MovePath::Joint(turned), limits(5.0, 100.0, 100.0, 99999.0), 6.802453);
    assert_time(MovePath::Joint([30.0, 20.0, 70.0, -40.0, 60.0, 90.0]), fast(), 0.338062);
}

#[test]
fn lines_take_the_time_of_the_oracle() {
    assert_time(line(moved(0.0, 200.0, 0.0)), fast(), 0.26015);
    assert_time(line(moved(0.0, 200.0, 0.0)), limits(100.0, 100.0, 100.0, 250.0), 0.82075);
    assert_time(line(moved(100.0, 0.0, 100.0)), fast(), 0.28393);
    assert_time(line(moved(100.0, 0.0, 100.0)), limits(100.0, 100.0, 100.0, 250.0), 0.6026);
    let turned = moved(0.0, 0.0, -100.0) * Trsf::new([0.0; 3], [0.0, 0.0, 40.0]).isometry();
    assert_time(line(turned), fast(), 0.22537);
}

#[test]
fn a_line_ends_at_the_joints_of_the_oracle() {
    let mut motion = motion();
    motion.record(&request(line(moved(0.0, 200.0, 0.0)), fast(), Blend::Off, 0.0)).unwrap();
    let mut cycles = 0;
    while !motion.is_empty() {
        motion.advance(CYCLE);
        cycles += 1;
    }
    assert_eq!(cycles, 66);
    let end = [22.413731, 8.042334, 81.394151, 0.0, 90.563515, 22.413731];
    assert!(
        motion.joints().iter().zip(end).all(|(is, expected)| (is - expected).abs() < 1e-6),
        "{:?}",
        motion.joints()
    );
}

#[test]
fn the_arm_waits_at_its_leave_point() {
    let mut motion = motion();
    let blend = Blend::Joint { leave: Millimetres(50.0), reach: Millimetres(50.0) };
    motion.record(&request(line(moved(0.0, 200.0, 0.0)), fast(), blend, 15.0)).unwrap();
    wait(&mut motion, 500);
    let sample = motion.advance(CYCLE);
    let distance = (sample.pose.translation.vector - moved(0.0, 200.0, 0.0).translation.vector).norm();
    assert!((distance - 50.0).abs() < 1e-9 && !motion.is_empty());
    assert!((sample.id - 15.75).abs() < 1e-9);
}

/// Example from manual 10.6: 15.8 when 80 % of the path is covered.
#[test]
fn the_id_counts_the_share_of_the_way() {
    let mut motion = motion();
    let start = arm().forward(&START).translation();
    motion.record(&request(line(moved(100.0, 200.0, 0.0)), fast(), Blend::Off, 15.0)).unwrap();
    let way = (moved(100.0, 200.0, 0.0).translation.vector - start).norm();
    for _ in 0..50 {
        let sample = motion.advance(CYCLE);
        let done = (sample.pose.translation.vector - start).norm() / way;
        assert!((sample.id - 15.0 - done).abs() < 1e-9, "{} after {done}", sample.id);
    }
    run(&mut motion, |_, _| ());
    assert_eq!(motion.move_id(), 16.0);
}

/// Advances by a number of cycles.
fn wait(motion: &mut Motion, cycles: usize) {
    for _ in 0..cycles {
        motion.advance(CYCLE);
    }
}

/// Runs a motion until it rests, and returns all samples.
fn run(motion: &mut Motion, disturb: impl Fn(&mut Motion, usize)) -> Vec<Sample> {
    let mut samples = Vec::new();
    for cycle in 0..10_000 {
        disturb(motion, cycle);
        samples.push(motion.advance(CYCLE));
        if motion.is_empty() {
            break;
        }
    }
    samples
}

fn corner(motion: &mut Motion, blend: fn(Millimetres, Millimetres) -> Blend, limits: SpeedLimits) {
    let blend = blend(Millimetres(50.0), Millimetres(50.0));
    motion.record(&request(line(moved(0.0, 200.0, 0.0)), limits, blend, 0.0)).unwrap();
    motion.record(&request(line(moved(0.0, 200.0, 200.0)), limits, blend, 1.0)).unwrap();
    motion.record(&request(line(moved(0.0, 0.0, 200.0)), limits, Blend::Off, 2.0)).unwrap();
}

#[test]
fn a_cartesian_corner_is_a_circle() {
    let mut motion = motion();
    corner(&mut motion, |leave, reach| Blend::Cartesian { leave, reach }, fast());
    let samples = run(&mut motion, |_, _| ());
    let centre = moved(0.0, 150.0, 50.0).translation.vector;
    let first: Vec<_> = samples.iter().filter(|sample| sample.phase == MotionPhase::Blend && sample.id < 1.5).collect();
    assert!(first.len() > 5);
    for sample in first {
        assert!(((sample.pose.translation.vector - centre).norm() - 50.0).abs() < 1e-6, "{sample:?}");
    }
}

#[test]
fn speeds_stay_within_the_limits_of_the_axes() {
    for blend in [|leave, reach| Blend::Cartesian { leave, reach }, |leave, reach| Blend::Joint { leave, reach }] {
        let mut motion = motion();
        corner(&mut motion, blend, fast());
        let samples = run(&mut motion, |_, _| ());
        for pair in samples.windows(2) {
            for ((before, after), limit) in pair[0].joints.iter().zip(pair[1].joints).zip(NOMINAL) {
                let speed = (after - before).abs() / CYCLE.0;
                assert!(speed <= limit * (1.0 + 1e-6), "{speed} instead of {limit}");
            }
            assert!(pair[1].id >= pair[0].id);
        }
    }
}

#[test]
fn a_reset_brakes_on_the_path_and_the_next_move_starts_there() {
    let mut motion = motion();
    corner(&mut motion, |leave, reach| Blend::Joint { leave, reach }, fast());
    wait(&mut motion, 30);
    let mut reference = motion.clone();
    reference.stop();
    wait(&mut reference, 100);
    motion.reset();
    assert!(!motion.is_empty(), "the arm brakes first");
    run(&mut motion, |_, _| ());
    assert!(motion.is_empty() && motion.move_id() == 0.0);
    assert_eq!(motion.joints(), reference.joints());
    let stopped = motion.joints();
    motion.record(&request(MovePath::Joint(START), fast(), Blend::Off, 0.0)).unwrap();
    let first = motion.advance(Seconds(1e-6));
    assert!(first.joints.iter().zip(stopped).all(|(joint, stopped)| (joint - stopped).abs() < 1e-6));
    run(&mut motion, |_, _| ());
    assert_eq!(motion.joints(), START);
}

#[test]
fn a_reset_at_rest_changes_nothing_but_the_queue() {
    let mut motion = motion();
    motion.reset();
    assert!(motion.is_empty() && motion.joints() == START);
    let blend = Blend::Joint { leave: Millimetres(50.0), reach: Millimetres(50.0) };
    motion.record(&request(line(moved(0.0, 200.0, 0.0)), fast(), blend, 3.0)).unwrap();
    wait(&mut motion, 500);
    let waiting = motion.joints();
    motion.reset();
    assert!(motion.is_empty() && motion.joints() == waiting && motion.move_id() == 0.0);
}

#[test]
fn closing_a_corner_stops_at_its_point() {
    let mut motion = motion();
    let blend = Blend::Joint { leave: Millimetres(50.0), reach: Millimetres(50.0) };
    motion.record(&request(line(moved(0.0, 200.0, 0.0)), fast(), blend, 0.0)).unwrap();
    motion.close().unwrap();
    motion.record(&request(line(moved(0.0, 200.0, 200.0)), fast(), Blend::Off, 1.0)).unwrap();
    let samples = run(&mut motion, |_, _| ());
    let target = moved(0.0, 200.0, 0.0).translation.vector;
    let nearest =
        samples.iter().map(|sample| (sample.pose.translation.vector - target).norm()).fold(f64::INFINITY, f64::min);
    assert!(nearest < 0.5, "{nearest}");
    let slowest = samples[5..samples.len() - 5].iter().map(|sample| sample.speed.0).fold(f64::INFINITY, f64::min);
    // The speed changes by up to 40 mm/s per cycle.
    assert!(slowest < 40.0, "{slowest}");
}

#[test]
fn overlapping_distances_are_reduced_in_proportion() {
    let mut motion = motion();
    let blend = Blend::Cartesian { leave: Millimetres(150.0), reach: Millimetres(150.0) };
    motion.record(&request(line(moved(0.0, 200.0, 0.0)), fast(), blend, 0.0)).unwrap();
    motion.record(&request(line(moved(0.0, 200.0, 100.0)), fast(), blend, 1.0)).unwrap();
    motion.record(&request(line(moved(0.0, 0.0, 100.0)), fast(), Blend::Off, 2.0)).unwrap();
    let samples = run(&mut motion, |_, _| ());
    // Both blends share the second line, half each.
    let middle = moved(0.0, 200.0, 50.0).translation.vector;
    let nearest =
        samples.iter().map(|sample| (sample.pose.translation.vector - middle).norm()).fold(f64::INFINITY, f64::min);
    assert!(nearest < 3.0, "{nearest}");
    assert!(samples.windows(2).all(|pair| pair[0].id <= pair[1].id));
}

#[test]
fn a_speed_of_the_tool_is_kept_on_lines_and_corners() {
    let mut motion = motion();
    corner(&mut motion, |leave, reach| Blend::Cartesian { leave, reach }, limits(100.0, 100.0, 100.0, 100.0));
    let samples = run(&mut motion, |_, _| ());
    assert!(samples.iter().all(|sample| sample.speed.0 <= 100.1));
    let at_limit = samples.iter().filter(|sample| sample.speed.0 > 99.0).count();
    assert!(at_limit as f64 > 0.9 * samples.len() as f64, "{at_limit} of {}", samples.len());
}

mod faults {
    use super::*;
    use crate::Cause;
    use val3_kinematics::{ConfigurationRequest, Shoulder, Unreachable};

    #[track_caller]
    fn refused(path: MovePath) -> Cause {
        let mut motion = motion();
        let cause = motion.record(&request(path, fast(), Blend::Off, 0.0)).unwrap_err();
        assert!(motion.is_empty(), "nothing is recorded");
        cause
    }

    #[test]
    fn destinations_that_cannot_be_reached_are_refused_at_once() {
        assert!(matches!(refused(line(moved(2000.0, 0.0, 0.0))), Cause::Unreachable(Unreachable::OutOfReach { .. })));
        assert!(matches!(refused(MovePath::Joint([200.0, 0.0, 90.0, 0.0, 90.0, 0.0])), Cause::OutOfRange(_)));
    }

    #[test]
    fn a_line_does_not_change_the_configuration() {
        let shoulder = ConfigurationRequest::Exactly(Shoulder::Righty);
        let configuration = RequestedConfiguration { shoulder, ..RequestedConfiguration::FREE };
        let path = MovePath::Line(MoveTarget { pose: moved(0.0, 100.0, 0.0), configuration });
        assert_eq!(refused(path), Cause::Configuration);
    }

    #[test]
    fn three_points_on_a_line_make_no_circle() {
        let destination = MoveTarget { pose: moved(0.0, 200.0, 0.0), configuration: RequestedConfiguration::FREE };
        assert!(matches!(refused(MovePath::Circle(moved(0.0, 100.0, 0.0), destination)), Cause::Arc(_)));
    }

    /// An impossible line is an error in the instruction that requests it (manual 10.6, `movel`).
    #[test]
    fn a_line_through_the_first_axis_is_refused_at_once() {
        let mut motion = Motion::new(Arc::new(arm()), [0.0, 30.0, 100.0, 0.0, 50.0, 0.0]);
        let start = Trsf::from(motion.advance(CYCLE).pose);
        let pose = Trsf { x: -start.x, ..start }.isometry();
        let path = MovePath::Line(MoveTarget { pose, configuration: RequestedConfiguration::SAME });
        motion.record(&request(path, fast(), Blend::Off, 0.0)).unwrap_err();
        assert!(motion.is_empty() && motion.fault().is_none());
        motion.record(&request(MovePath::Joint(START), fast(), Blend::Off, 1.0)).unwrap();
    }

    /// Records two lines that pass axis 1 at a distance of 80 mm. Their blend would cut through the cylinder of 50 mm
    /// around the axis, which the wrist centre cannot reach. Returns the blend.
    pub(super) fn cut_through_axis_1(motion: &mut Motion) -> Blend {
        let blend = Blend::Cartesian { leave: Millimetres(200.0), reach: Millimetres(200.0) };
        let flange = Trsf::from(moved(0.0, 0.0, 0.0));
        let pose = |x: f64, y: f64| Trsf { x, y, ..flange }.isometry();
        let first = arm().solve(&pose(80.0, 300.0).into(), &START, RequestedConfiguration::SAME).unwrap();
        motion.record(&request(MovePath::Joint(first), fast(), Blend::Off, 0.0)).unwrap();
        motion.record(&request(line(pose(80.0, -80.0)), fast(), blend, 1.0)).unwrap();
        motion.record(&request(line(pose(-300.0, -80.0)), fast(), blend, 2.0)).unwrap();
        blend
    }

    /// A recorded path can only have a fault in a blend, because a blend is determined by the next move.
    #[test]
    fn a_blend_that_cannot_be_followed_brings_the_arm_to_rest_before_it() {
        let mut motion = motion();
        let blend = cut_through_axis_1(&mut motion);
        let fault = motion.path_fault().cloned().unwrap_or_else(|| panic!("no fault"));
        assert_eq!((fault.serial, fault.is_blend), (1, true), "{fault}");
        assert_eq!(motion.stuck(), None, "the arm still moves");
        run(&mut motion, |_, _| ());
        assert_eq!(motion.stuck(), Some(&fault));
        assert!(!motion.is_empty());
        assert_eq!(motion.record(&request(MovePath::Joint(START), fast(), blend, 2.0)), Err(fault.cause));
    }

    #[test]
    fn an_intermediate_point_out_of_reach_is_refused_at_once() {
        let destination = MoveTarget { pose: moved(0.0, 200.0, 0.0), configuration: RequestedConfiguration::FREE };
        assert!(matches!(refused(MovePath::Circle(moved(2000.0, 100.0, 0.0), destination)), Cause::Intermediate(_)));
    }
}

mod accuracy;
mod alter;
mod blends;
mod compliant;
mod configurations;
mod corners;
mod distances;
mod jog;
mod laws;
mod path_independence;
mod reasons;
mod reduced_speed;
mod speed_limit;
mod stepping;
mod steps;
mod stops;
