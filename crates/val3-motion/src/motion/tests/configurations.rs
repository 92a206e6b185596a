//! Configurations along Cartesian moves, and tool changes: sections (a) and (k) of the motion model.

use super::*;
use crate::Cause;
use val3_kinematics::{Configuration, ConfigurationRequest, Elbow, Shoulder, Unreachable, Wrist};

const FREE: RequestedConfiguration = RequestedConfiguration::FREE;

fn at(joints: Joints) -> Motion {
    Motion::new(Arc::new(arm()), joints)
}

fn line_to(pose: IsometryMatrix3<f64>, configuration: RequestedConfiguration) -> Move {
    let limits = limits(100.0, 100.0, 100.0, 300.0);
    request(MovePath::Line(MoveTarget { pose, configuration }), limits, Blend::Off, 0.0)
}

/// Executes a move, and checks that the arm follows the pose and that no axis jumps. Returns the configuration at the
/// end.
fn run_evenly(motion: &mut Motion, request: &Move) -> Configuration {
    let mut before = motion.joints();
    motion.record(request).unwrap();
    let samples = run(motion, |_, _| ());
    for sample in &samples {
        let widest = sample.joints.iter().zip(before).map(|(joint, before)| (joint - before).abs());
        let limit = NOMINAL.map(|speed| speed * CYCLE.0 * 1.001);
        assert!(widest.zip(limit).all(|(way, limit)| way <= limit), "{before:?} to {:?}", sample.joints);
        before = sample.joints;
    }
    assert!(motion.fault().is_none(), "{:?}", motion.fault());
    arm().configuration(&motion.joints())
}

fn near(is: Joints, expected: Joints) -> bool {
    is.iter().zip(expected).all(|(is, expected)| (is - expected).abs() < 1e-4)
}

/// The tool swings in the plane of the arm and passes the position in line with the forearm.
#[test]
fn a_wrist_that_passes_straight_changes_its_configuration() {
    let (start, end) = ([10.0, 0.0, 90.0, 0.0, 40.0, 5.0], [10.0, 5.0, 80.0, 0.0, -35.0, 5.0]);
    let mut motion = at(start);
    let configuration = run_evenly(&mut motion, &line_to(arm().flange(&end), FREE));
    assert_eq!(configuration.wrist, Wrist::Negative);
    assert!(near(motion.joints(), end), "{:?}", motion.joints());
}

/// The tool rotates around the wrist centre, only by axis 5.
#[test]
fn a_wrist_passes_straight_out_of_the_plane_of_the_arm_too() {
    let (start, end) = ([10.0, 0.0, 90.0, 25.0, 40.0, 5.0], [10.0, 0.0, 90.0, 25.0, -35.0, 5.0]);
    let tool = IsometryMatrix3::translation(0.0, 0.0, -100.0);
    let mut motion = at(start);
    run_evenly(&mut motion, &Move { tool, ..line_to(arm().flange(&end) * tool, FREE) });
    assert!(near(motion.joints(), end), "{:?}", motion.joints());
}

#[test]
fn a_wrist_that_must_stay_cannot_pass_straight() {
    let (start, end) = ([10.0, 0.0, 90.0, 0.0, 40.0, 5.0], [10.0, 5.0, 80.0, 0.0, -35.0, 5.0]);
    for wrist in [ConfigurationRequest::Same, ConfigurationRequest::Exactly(Wrist::Positive)] {
        let mut motion = at(start);
        let configuration = RequestedConfiguration { wrist, ..FREE };
        assert_eq!(motion.record(&line_to(arm().flange(&end), configuration)), Err(Cause::Singular));
        assert!(motion.is_empty() && motion.destination() == start, "nothing is recorded");
    }
    let configuration = RequestedConfiguration { wrist: ConfigurationRequest::Exactly(Wrist::Negative), ..FREE };
    assert_eq!(at(start).record(&line_to(arm().flange(&end), configuration)), Err(Cause::Configuration));
}

#[test]
fn a_wrist_that_starts_straight_chooses_its_side() {
    let (start, end) = ([10.0, 0.0, 90.0, 0.0, 0.0, 5.0], [10.0, 5.0, 80.0, 0.0, -35.0, 5.0]);
    let mut motion = at(start);
    run_evenly(&mut motion, &line_to(arm().flange(&end), FREE));
    assert!(near(motion.joints(), end), "{:?}", motion.joints());
}

/// The wrist centre passes over axis 1, at the lateral offset of the arm.
#[test]
fn an_arm_that_passes_over_its_shoulder_changes_its_configuration() {
    let start = [0.0, 0.0, 60.0, 0.0, 40.0, 0.0];
    let mut motion = at(start);
    let pose = Trsf::from(motion.advance(CYCLE).pose);
    let opposite = Trsf { x: -100.0, ..pose }.isometry();
    let configuration = run_evenly(&mut motion, &line_to(opposite, FREE));
    assert_eq!(configuration.shoulder, Shoulder::Righty);
    assert!(motion.joints()[0].abs() < 1e-6, "{:?}", motion.joints());
}

#[test]
fn a_path_beside_the_first_axis_cannot_change_the_configuration() {
    for aside in [0.5, 0.001, -0.001, -0.5] {
        let mut motion = at([0.0, 0.0, 60.0, 0.0, 40.0, 0.0]);
        let pose = Trsf::from(motion.advance(CYCLE).pose);
        let beside = Trsf { x: -100.0, y: pose.y + aside, ..pose }.isometry();
        let refused = motion.record(&line_to(beside, FREE)).is_err();
        assert!(refused || motion.fault().is_some(), "{aside}");
    }
}

/// The wrist centre moves on a circle that touches the boundary of the reach from inside.
#[test]
fn an_elbow_that_is_stretched_on_the_way_changes_its_configuration() {
    let start = [0.0, 40.0, 20.0, 0.0, 40.0, 0.0];
    let branch = Configuration { elbow: Elbow::Positive, ..arm().configuration(&start) };
    let start = arm().inverse_isometry_on(branch, &on_circle(-40.0), &start).unwrap();
    let mut motion = at(start);
    let end = MoveTarget { pose: on_circle(40.0), configuration: FREE };
    let circle = request(MovePath::Circle(on_circle(5.0), end), limits(100.0, 100.0, 100.0, 300.0), Blend::Off, 0.0);
    let configuration = run_evenly(&mut motion, &circle);
    assert_eq!(configuration.elbow, Elbow::Negative, "{:?}", motion.joints());
}

/// Flange pose on a circle of 300 mm that touches the boundary of the reach at 0 degrees.
fn on_circle(angle: f64) -> IsometryMatrix3<f64> {
    let stretched = [0.0, 40.0, 0.0, 0.0, 60.0, 0.0];
    let mut pose = arm().flange(&stretched);
    let wrist = pose.translation.vector - pose.rotation.matrix().column(2) * 100.0;
    let shoulder = val3_geometry::Vector3::new(50.0, 50.0, 0.0);
    let outwards = (wrist - shoulder).normalize();
    let turn = val3_geometry::rotation::from_vector(&(val3_geometry::Vector3::y() * angle.to_radians()));
    pose.translation.vector += (turn * outwards - outwards) * 300.0;
    pose
}

#[test]
fn ordinary_lines_keep_their_configuration() {
    let mut motion = motion();
    let before = arm().configuration(&START);
    assert_eq!(run_evenly(&mut motion, &line_to(moved(100.0, 200.0, 50.0), FREE)), before);
}

/// A move with another tool starts at the position of this tool. `leave` is measured with the tool of the move before
/// the corner, and `reach` with the tool of the move after the corner.
#[test]
fn each_tool_has_its_own_distances() {
    let tools = [IsometryMatrix3::translation(0.0, 0.0, 100.0), IsometryMatrix3::translation(40.0, 0.0, 200.0)];
    let blend = Blend::Cartesian { leave: Millimetres(50.0), reach: Millimetres(30.0) };
    let mut motion = motion();
    let targets = [moved(0.0, 200.0, 0.0), moved(0.0, 200.0, 150.0)];
    for ((tool, target), id) in tools.iter().zip(targets).zip([0.0, 1.0]) {
        let request = request(line(target * tool), limits(100.0, 100.0, 100.0, 100.0), blend, id);
        motion.record(&Move { tool: *tool, ..request }).unwrap();
    }
    motion.close().unwrap();
    let samples = run(&mut motion, |_, _| ());
    let tip = |sample: &Sample, tool: usize| (arm().flange(&sample.joints) * tools[tool]).translation.vector;
    let corner = |tool: usize| (targets[0] * tools[tool]).translation.vector;
    let of = |phase| samples.iter().filter(move |sample| sample.phase == phase);
    // The first part is the first tool's line, up to 50 mm before the corner.
    let first: Vec<_> = of(MotionPhase::Nominal).filter(|sample| sample.id < 0.9).collect();
    let last = first.last().unwrap();
    let left = (tip(last, 0) - corner(0)).norm();
    assert!((50.0..50.5).contains(&left), "{left}");
    for sample in of(MotionPhase::Nominal).filter(|sample| sample.id >= 1.0 && sample.id < 2.0) {
        let offset = tip(sample, 1) - corner(1);
        assert!(offset.xy().norm() < 1e-6 && offset.z >= 30.0 - 1e-6, "{offset:?}");
    }
    assert!(of(MotionPhase::Blend).count() > 10);
    assert!(samples.iter().all(|sample| sample.speed.0 <= 100.1 || sample.phase == MotionPhase::Blend));
}

/// The tool rotates only by axis 6, which can reach the last orientation only after a full turn back.
#[test]
fn a_turn_that_ends_beyond_a_limit_names_the_axis_and_its_limit() {
    for (from, turn) in [(260.0, 40.0), (260.0, 90.0), (-260.0, -90.0), (260.0, 170.0), (100.0, 178.0)] {
        let at_axis_6 = |axis_6| [10.0, 0.0, 90.0, 0.0, 40.0, axis_6];
        let line = line_to(arm().flange(&at_axis_6(from + turn)), FREE);
        let Err(Cause::Unreachable(Unreachable::Limit { axis: 6, position, max, .. })) =
            at(at_axis_6(from)).record(&line)
        else {
            panic!("{from} + {turn}: {:?}", at(at_axis_6(from)).record(&line))
        };
        assert!(max == 270.0 && (270.0..271.0).contains(&position.abs()), "{from} + {turn}: {position}");
    }
}

#[test]
fn a_joint_move_to_a_point_ends_at_the_nearest_joint_position_that_it_allows() {
    let pose = moved(0.0, 150.0, 40.0);
    let tool = IsometryMatrix3::translation(0.0, 0.0, 80.0);
    let target = MoveTarget { pose: pose * tool, configuration: FREE };
    let (mut by_point, mut by_joints) = (motion(), motion());
    let joints = arm().solve(&pose.into(), &START, FREE).unwrap();
    let to = |path| Move { tool, ..request(path, fast(), Blend::Off, 0.0) };
    by_point.record(&to(MovePath::JointToPoint(target))).unwrap();
    by_joints.record(&to(MovePath::Joint(joints))).unwrap();
    assert_eq!(by_point.destination(), by_joints.destination());
    assert_eq!(run(&mut by_point, |_, _| ()), run(&mut by_joints, |_, _| ()));
}

#[test]
fn a_joint_move_to_a_point_out_of_reach_is_rejected() {
    let mut motion = motion();
    let target = MoveTarget { pose: moved(5000.0, 0.0, 0.0), configuration: FREE };
    let result = motion.record(&request(MovePath::JointToPoint(target), fast(), Blend::Off, 0.0));
    assert!(matches!(result, Err(Cause::Unreachable(_))), "{result:?}");
    assert!(motion.is_empty());
}
