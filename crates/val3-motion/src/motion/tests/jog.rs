//! Jogging.

use super::*;
use crate::Jog;
use val3_geometry::Vector3;

/// Motion whose arm has lost power on a line along y.
fn held() -> Motion {
    let mut motion = motion();
    motion.record(&request(line(moved(0.0, 200.0, 0.0)), fast(), Blend::Off, 0.0)).unwrap();
    wait(&mut motion, 30);
    motion.brake();
    wait(&mut motion, 100);
    motion
}

fn jog(motion: &mut Motion, jog: &Jog, cycles: usize) {
    for _ in 0..cycles {
        motion.jog(jog, CYCLE).unwrap();
        motion.advance(CYCLE);
    }
}

fn tip(motion: &Motion) -> IsometryMatrix3<f64> {
    arm().flange(&motion.joints())
}

#[test]
fn axes_move_at_their_speeds_however_slow_they_are() {
    for speed in [0.01, 5.0] {
        let mut motion = held();
        let before = motion.joints();
        jog(&mut motion, &Jog::Joints([speed, 0.0, 0.0, 0.0, -speed, 0.0]), 250);
        let after = motion.joints();
        assert!((after[0] - before[0] - speed).abs() < 1e-9 && (after[4] - before[4] + speed).abs() < 1e-9);
        let connection = motion.connection().unwrap();
        assert!((connection.axis - speed).abs() < 1e-9 && connection.distance.0 > 0.0);
        assert_eq!(Joints::from(motion.axes_on_path()), before);
    }
}

#[test]
fn an_axis_stays_within_its_limits() {
    let mut motion = held();
    jog(&mut motion, &Jog::Joints([0.0, 0.0, 0.0, 0.0, 100.0, 0.0]), 100);
    let before = motion.joints();
    assert!(motion.jog(&Jog::Joints([0.0, 0.0, 0.0, 0.0, 10_000.0, 0.0]), CYCLE).is_err());
    assert_eq!(motion.joints(), before);
}

#[test]
fn a_tool_moves_along_and_around_its_axes_or_those_of_a_frame() {
    let tool = IsometryMatrix3::translation(0.0, 50.0, 100.0);
    let (translation, rotation) = (Vector3::new(0.0, 0.0, -40.0), Vector3::zeros());
    let mut motion = held();
    let before = tip(&motion) * tool;
    jog(&mut motion, &Jog::Cartesian { tool, frame: None, translation, rotation }, 250);
    let step = before.inverse() * tip(&motion) * tool;
    assert!((step.translation.vector - translation).norm() < 1e-6 && step.rotation.angle() < 1e-9);

    let frame = Trsf::new([0.0; 3], [0.0, 0.0, 30.0]).isometry().rotation;
    let (translation, rotation) = (Vector3::new(-20.0, 0.0, 0.0), Vector3::new(0.0, 0.0, 10.0));
    let before = tip(&motion) * tool;
    jog(&mut motion, &Jog::Cartesian { tool, frame: Some(frame), translation, rotation }, 250);
    let after = tip(&motion) * tool;
    let way = after.translation.vector - before.translation.vector;
    assert!((way - frame * translation).norm() < 1e-6);
    let turn = after.rotation * before.rotation.inverse();
    assert!((turn.scaled_axis() - Vector3::z() * 10_f64.to_radians()).norm() < 1e-9);
}

#[test]
fn an_arm_that_moves_by_itself_is_not_jogged() {
    let mut motion = motion();
    motion.record(&request(line(moved(0.0, 200.0, 0.0)), fast(), Blend::Off, 0.0)).unwrap();
    wait(&mut motion, 10);
    let mut plain = motion.clone();
    motion.jog(&Jog::Joints([5.0; 6]), CYCLE).unwrap();
    assert_eq!(motion.advance(CYCLE), plain.advance(CYCLE));
}

#[test]
fn an_arm_that_is_hardly_moved_continues_at_once() {
    let mut motion = held();
    motion.jog(&Jog::Joints([0.1, 0.0, 0.0, 0.0, 0.0, 0.0]), CYCLE).unwrap();
    assert_eq!(motion.connection(), None);
    motion.resume();
    run(&mut motion, |_, _| ());
    assert!((tip(&motion).translation.vector - moved(0.0, 200.0, 0.0).translation.vector).norm() < 1e-6);
}

/// After a jog of 5 degrees, the arm returns to the position at which it left its path and follows the path from there.
#[test]
fn a_jogged_arm_returns_to_where_it_left_its_path() {
    let mut motion = held();
    let left = tip(&motion).translation.vector;
    jog(&mut motion, &Jog::Joints([5.0, 5.0, -5.0, 0.0, 0.0, 5.0]), 250);
    motion.resume();
    motion.connect().unwrap();
    let samples = run(&mut motion, |_, _| ());
    let back = samples.iter().position(|sample| sample.phase == MotionPhase::Nominal).unwrap();
    assert!((samples[back - 1].pose.translation.vector - left).norm() < 1e-9);
    for sample in &samples[back..] {
        let offset = sample.pose.translation.vector - left;
        assert!((offset - Vector3::y() * offset.y).norm() < 1e-6);
    }
}
