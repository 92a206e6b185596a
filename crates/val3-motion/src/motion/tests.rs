//! Timing oracles of section (e) of the motion model, and laws of the path.

use val3_geometry::{IsometryMatrix3, Trsf, Vector3};
use val3_kinematics::RequestedConfiguration;

use super::*;
use crate::{Blend, Corner, DegreesPerSecond, Destination, Limits, Millimetres, MovePath};

const CYCLE: Seconds = Seconds(0.004);
const NOMINAL: [f64; 6] = [265.0, 210.0, 315.0, 450.0, 370.0, 630.0];
const START: Joints = [0.0, 0.0, 90.0, 0.0, 90.0, 0.0];

fn limits(vel: f64, accel: f64, decel: f64, tvel: f64) -> Limits {
    Limits {
        speed: NOMINAL.map(|speed| speed * vel / 100.0),
        acceleration: NOMINAL.map(|speed| 5.0 * speed * accel / 100.0),
        deceleration: NOMINAL.map(|speed| 5.0 * speed * decel / 100.0),
        translation: MillimetresPerSecond(tvel),
        rotation: DegreesPerSecond(99999.0),
    }
}

fn fast() -> Limits {
    limits(100.0, 100.0, 100.0, 99999.0)
}

fn request(path: MovePath, limits: Limits, blend: Blend, id: f64) -> Move {
    Move { path, tool: IsometryMatrix3::identity(), limits, blend, id }
}

fn line(pose: IsometryMatrix3<f64>) -> MovePath {
    MovePath::Line(Destination { pose, configuration: RequestedConfiguration::FREE })
}

fn arm() -> Arm {
    Arm::by_name("TX2-90").unwrap()
}

fn motion() -> Motion {
    Motion::new(Arc::new(arm()), START)
}

fn moved(x: f64, y: f64, z: f64) -> IsometryMatrix3<f64> {
    let start = arm().forward(&START);
    Trsf { x: start.x + x, y: start.y + y, z: start.z + z, ..start }.isometry()
}

#[track_caller]
fn assert_time(path: MovePath, limits: Limits, expected: f64) {
    let mut motion = motion();
    motion.record(&request(path, limits, Blend::Off, 0.0)).unwrap();
    let time = motion.time_left().0;
    eprintln!("{time} {expected}");
    assert!((time - expected).abs() < 0.003 * expected + 0.004, "{time} instead of {expected}");
}

#[test]
fn joint_moves_take_the_time_of_the_oracle() {
    let turned = [90.0, 0.0, 90.0, 0.0, 90.0, 0.0];
    assert_time(MovePath::Joint(turned), fast(), 0.539623);
    assert_time(MovePath::Joint(turned), limits(50.0, 100.0, 100.0, 99999.0), 0.779245);
    assert_time(MovePath::Joint(turned), limits(100.0, 50.0, 100.0, 99999.0), 0.639623);
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

/// The example of manual 10.6: 15.8 where 80 % of the way is done.
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

/// What happens to the moves of a motion: `serial kind`.
fn steps(motion: &mut Motion) -> String {
    run(motion, |_, _| ());
    let steps = motion.take_steps();
    steps.iter().map(|step| format!("{} {:?}", step.serial, step.kind)).collect::<Vec<_>>().join(", ")
}

#[test]
fn moves_are_accounted_for_step_by_step() {
    let blend = Blend::Joint { leave: Millimetres(50.0), reach: Millimetres(50.0) };
    let mut motion = motion();
    for (number, (y, blend)) in [(200.0, blend), (200.0, Blend::Off), (0.0, Blend::Off)].into_iter().enumerate() {
        let z = if number == 0 { 0.0 } else { 100.0 };
        motion.record(&request(line(moved(0.0, y, z)), fast(), blend, 5.0)).unwrap();
    }
    let corners: Vec<_> = motion.moves().map(|queued| (queued.leave, queued.reach)).collect();
    let position = |corner: Option<Corner>| corner.map(|corner| (corner.position, corner.distance));
    let [leave, reach] = [moved(0.0, 150.0, 0.0), moved(0.0, 200.0, 50.0)].map(|pose| pose.translation.vector);
    let near = |is: Option<Corner>, expected: Vector3<f64>| {
        position(is).is_some_and(|(is, distance)| (is - expected).norm() < 1e-9 && distance == Millimetres(50.0))
    };
    assert!(near(corners[0].0, leave) && near(corners[0].1, reach), "{corners:?}");
    assert_eq!(corners[1..], [(None, None), (None, None)]);
    assert_eq!(steps(&mut motion), "0 Started, 0 Blend, 0 Reached, 0 Done, 1 Started, 1 Done, 2 Started, 2 Done");
    assert_eq!(motion.moves().len(), 0);
}

#[test]
fn a_move_to_where_the_arm_is_is_done_at_once() {
    let mut motion = motion();
    motion.record(&request(MovePath::Joint(START), fast(), Blend::Off, 0.0)).unwrap();
    assert_eq!(steps(&mut motion), "0 Started, 0 Done");
}

#[test]
fn an_emergency_stop_brakes_twice_as_hard_on_the_path() {
    let way = |stop: fn(&mut Motion)| {
        let mut motion = motion();
        motion.record(&request(MovePath::Joint([90.0, 0.0, 90.0, 0.0, 90.0, 0.0]), fast(), Blend::Off, 0.0)).unwrap();
        wait(&mut motion, 60);
        let from = motion.joints()[0];
        stop(&mut motion);
        wait(&mut motion, 100);
        (motion, from)
    };
    let (slow, from) = way(Motion::stop);
    let (fast, _) = way(Motion::brake);
    let (soft, _) = way(|motion| {
        motion.stop();
        motion.brake();
    });
    let braked = fast.joints()[0] - from;
    assert!((2.0 * braked - (slow.joints()[0] - from)).abs() < 0.2, "{braked}");
    assert!((soft.joints()[0] - fast.joints()[0]).abs() < 1e-9);
}

/// A stop outlasts the loss of power, and power that comes back does not restart it.
#[test]
fn power_and_stops_hold_the_arm_independently() {
    let mut motion = motion();
    motion.record(&request(MovePath::Joint([90.0, 0.0, 90.0, 0.0, 90.0, 0.0]), fast(), Blend::Off, 0.0)).unwrap();
    wait(&mut motion, 20);
    motion.stop();
    motion.brake();
    wait(&mut motion, 100);
    let held = motion.joints();
    motion.resume();
    wait(&mut motion, 100);
    assert_eq!(motion.joints(), held);
    motion.restart();
    run(&mut motion, |_, _| ());
    assert_eq!(motion.joints()[0], 90.0);
}

/// Lets some cycles pass.
fn wait(motion: &mut Motion, cycles: usize) {
    for _ in 0..cycles {
        motion.advance(CYCLE);
    }
}

/// All samples of a motion until it is at rest.
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

fn corner(motion: &mut Motion, blend: fn(Millimetres, Millimetres) -> Blend, limits: Limits) {
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
    let first: Vec<_> = samples.iter().filter(|sample| sample.phase == Phase::Blend && sample.id < 1.5).collect();
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
fn a_stop_stays_in_place_until_the_restart() {
    let mut motion = motion();
    corner(&mut motion, |leave, reach| Blend::Joint { leave, reach }, fast());
    let samples = run(&mut motion, |motion, cycle| match cycle {
        20 => motion.stop(),
        400 => motion.restart(),
        _ => (),
    });
    let halted = &samples[300..399];
    assert!(halted.iter().all(|sample| sample.joints == samples[300].joints && sample.phase == Phase::Waiting));
    assert_eq!(motion.move_id(), 3.0);
}

#[test]
fn a_stop_holds_moves_that_are_recorded_later() {
    let mut motion = motion();
    motion.stop();
    motion.record(&request(line(moved(0.0, 200.0, 0.0)), fast(), Blend::Off, 0.0)).unwrap();
    assert!((0..100).all(|_| motion.advance(CYCLE).joints == START));
    motion.restart();
    assert!(!run(&mut motion, |_, _| ()).is_empty());
    assert_eq!(motion.move_id(), 1.0);
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
fn half_the_monitor_speed_takes_twice_the_time() {
    let cycles = |speed: f64| {
        let mut motion = motion();
        motion.set_monitor_speed(Percent(speed));
        corner(&mut motion, |leave, reach| Blend::Cartesian { leave, reach }, fast());
        run(&mut motion, |_, _| ()).len()
    };
    assert!(cycles(50.0).abs_diff(2 * cycles(100.0)) <= 2);
}

#[test]
fn a_zero_monitor_speed_holds_the_arm_on_its_path() {
    let mut motion = motion();
    corner(&mut motion, |leave, reach| Blend::Joint { leave, reach }, fast());
    let samples = run(&mut motion, |motion, cycle| match cycle {
        20 => motion.set_monitor_speed(Percent(0.0)),
        300 => motion.set_monitor_speed(Percent(100.0)),
        _ => (),
    });
    assert_eq!(samples[150].joints, samples[299].joints);
    assert_eq!(motion.move_id(), 3.0);
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
    // The arm changes its speed by up to 40 mm/s in a cycle.
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
    // Both blends share the second line: each gets half of it.
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
    use val3_kinematics::{Request, Shoulder, Unreachable};

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
        let shoulder = Request::Exactly(Shoulder::Righty);
        let configuration = RequestedConfiguration { shoulder, ..RequestedConfiguration::FREE };
        let path = MovePath::Line(Destination { pose: moved(0.0, 100.0, 0.0), configuration });
        assert_eq!(refused(path), Cause::Configuration);
    }

    #[test]
    fn three_points_on_a_line_make_no_circle() {
        let destination = Destination { pose: moved(0.0, 200.0, 0.0), configuration: RequestedConfiguration::FREE };
        assert!(matches!(refused(MovePath::Circle(moved(0.0, 100.0, 0.0), destination)), Cause::Arc(_)));
    }

    #[test]
    fn a_line_through_the_first_axis_stops_before_it_and_the_next_move_is_refused() {
        let mut motion = Motion::new(Arc::new(arm()), [0.0, 30.0, 100.0, 0.0, 50.0, 0.0]);
        let start = Trsf::from(motion.advance(CYCLE).pose);
        let opposite = Trsf { x: -start.x, ..start }.isometry();
        motion.record(&request(line(opposite), fast(), Blend::Off, 0.0)).unwrap_or_else(|cause| panic!("{cause}"));
        let samples = run(&mut motion, |_, _| ());
        assert!(samples.iter().all(|sample| sample.pose.translation.vector.x > 0.0));
        assert!(motion.record(&request(MovePath::Joint(START), fast(), Blend::Off, 1.0)).is_err());
    }
}

mod path_independence {
    use proptest::prelude::*;

    use super::*;

    #[derive(Clone, Debug)]
    enum Shape {
        Joint([f64; 6]),
        Line([f64; 3], [f64; 3]),
        Circle([f64; 3], [f64; 3]),
    }

    #[derive(Clone, Debug)]
    struct Step {
        shape: Shape,
        blend: Blend,
    }

    fn step() -> impl Strategy<Value = Step> {
        let offset = || prop::array::uniform3(-150.0..150.0_f64);
        let angles = prop::array::uniform3(-20.0..20.0_f64);
        let shape = prop_oneof![
            prop::array::uniform6(-20.0..20.0_f64).prop_map(Shape::Joint),
            (offset(), angles).prop_map(|(offset, angles)| Shape::Line(offset, angles)),
            (offset(), offset()).prop_map(|(through, to)| Shape::Circle(through, to)),
        ];
        let distances = || (0.0..120.0_f64, 0.0..120.0_f64);
        let blend = prop_oneof![
            Just(Blend::Off),
            distances()
                .prop_map(|(leave, reach)| Blend::Joint { leave: Millimetres(leave), reach: Millimetres(reach) }),
            distances()
                .prop_map(|(leave, reach)| Blend::Cartesian { leave: Millimetres(leave), reach: Millimetres(reach) }),
        ];
        (shape, blend).prop_map(|(shape, blend)| Step { shape, blend })
    }

    fn requests(steps: &[Step], vel: f64) -> Vec<Move> {
        let at = |[x, y, z]: [f64; 3]| moved(x, y, z);
        let free = |pose| Destination { pose, configuration: RequestedConfiguration::FREE };
        let path = |shape: &Shape| match shape {
            Shape::Joint(offsets) => {
                let mut joints = START;
                joints.iter_mut().zip(offsets).for_each(|(joint, offset)| *joint += offset);
                MovePath::Joint(joints)
            }
            Shape::Line(offset, angles) => line(at(*offset) * Trsf::new([0.0; 3], *angles).isometry()),
            Shape::Circle(through, to) => MovePath::Circle(at(*through), free(at(*to))),
        };
        let ids = (0..).map(f64::from);
        let limits = limits(vel, 100.0, 100.0, 99999.0);
        steps.iter().zip(ids).map(|(step, id)| request(path(&step.shape), limits, step.blend, id)).collect()
    }

    /// The spans of a program that is recorded all at once, if the arm can follow it.
    fn reference(requests: &[Move]) -> Option<Motion> {
        let mut motion = motion();
        requests.iter().try_for_each(|request| motion.record(request)).ok()?;
        motion.close().ok()?;
        Some(motion)
    }

    /// The greatest difference of the arm from the path of the reference, in degrees.
    fn deviation(reference: &Motion, motion: &Motion) -> f64 {
        let (Some(front), Some(p)) = (motion.timeline.spans.front(), motion.timeline.p()) else { return 0.0 };
        let model = Model(&motion.arm);
        let same = |other: &&crate::timeline::TimedSpan| {
            let [from, to] = other.span.range();
            other.span.part == front.span.part && (from..=to).contains(&p)
        };
        let spans = reference.timeline.spans.iter().filter(same);
        let differences = spans.map(|other| (other.span.axes(&model, p) - motion.axes()).amax());
        differences.fold(f64::INFINITY, f64::min)
    }

    /// Runs a program, with moves recorded as late as `early` allows, and disturbances by a sequence of choices.
    fn follow(reference: &Motion, requests: &[Move], early: f64, choices: &[u8]) -> Result<(), TestCaseError> {
        let mut motion = motion();
        let mut waiting = requests.iter();
        let mut more = true;
        for cycle in 0..50_000 {
            while more && motion.time_left().0 <= early {
                more = match waiting.next() {
                    Some(request) => {
                        motion.record(request).unwrap();
                        true
                    }
                    None => {
                        motion.close().unwrap();
                        false
                    }
                };
            }
            match choices[cycle / 25 % choices.len()] {
                _ if cycle % 25 != 0 => (),
                0 => motion.stop(),
                speed if speed < 100 => {
                    motion.restart();
                    motion.set_monitor_speed(Percent(f64::from(speed.max(50))));
                }
                _ => motion.restart(),
            }
            motion.advance(CYCLE);
            let deviation = deviation(reference, &motion);
            prop_assert!(deviation < 1e-6, "{} degrees from the path at {}", deviation, motion.move_id());
            if !more && motion.is_empty() {
                return Ok(());
            }
        }
        Err(TestCaseError::fail("the program does not end"))
    }

    /// Greatest share of a limit of speed that the arm uses between two samples.
    fn used(before: &Sample, after: &Sample, limits: &Limits) -> f64 {
        let axes = before.joints.iter().zip(after.joints).zip(limits.speed);
        let fastest = axes.map(|((before, after), limit)| (after - before).abs() / CYCLE.0 / limit).fold(0.0, f64::max);
        fastest.max(after.speed.0 / limits.translation.0)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(100))]

        #[test]
        fn the_path_is_fixed_by_the_moves_alone(
            steps in prop::collection::vec(step(), 1..6),
            vel in 5.0..100.0_f64,
            early in prop_oneof![Just(0.0), 0.0..1.0_f64, Just(f64::INFINITY)],
            choices in prop::collection::vec(prop_oneof![1 => Just(0), 4 => 50..=200_u8], 5..20),
        ) {
            let reference = reference(&requests(&steps, 100.0));
            prop_assume!(reference.is_some());
            prop_assume!(choices.iter().filter(|choice| **choice == 0).count() * 2 < choices.len());
            follow(&reference.unwrap(), &requests(&steps, vel), early, &choices)?;
        }

        #[test]
        fn limits_of_speed_are_kept_and_ids_never_fall(
            steps in prop::collection::vec(step(), 1..6),
            vel in 20.0..100.0_f64,
            tvel in prop_oneof![Just(99999.0), 50.0..500.0_f64],
        ) {
            let mut requests = requests(&steps, vel);
            requests.iter_mut().for_each(|request| request.limits.translation = MillimetresPerSecond(tvel));
            let motion = reference(&requests);
            prop_assume!(motion.is_some());
            let samples = run(&mut motion.unwrap(), |_, _| ());
            for pair in samples.windows(2) {
                let used = used(&pair[0], &pair[1], &requests[0].limits);
                prop_assert!(used < 1.000_001, "{} of the limit at {}", used, pair[1].id);
                prop_assert!(pair[0].id <= pair[1].id + 1e-9, "{} after {}", pair[1].id, pair[0].id);
            }
        }
    }
}
