//! Alter mode: section (h) of the motion model.

use super::*;
use crate::{AlterReference, AlterStatus, Cause};
use val3_geometry::Vector3;

const FRAME: Trsf = Trsf { x: 300.0, y: -200.0, z: 100.0, rx: 10.0, ry: 20.0, rz: 30.0 };

fn alterable(path: MovePath, blend: Blend, id: f64) -> Move {
    Move { manner: Manner::Alterable, ..request(path, limits(100.0, 100.0, 100.0, 200.0), blend, id) }
}

/// Motion on an alterable line of 200 mm along y at 200 mm/s, shortly after the start.
fn on_its_way() -> Motion {
    let mut motion = motion();
    motion.record(&alterable(line(moved(0.0, 200.0, 0.0)), Blend::Off, 0.0)).unwrap();
    wait(&mut motion, 50);
    motion
}

fn frame() -> AlterReference {
    AlterReference::Frame(FRAME.isometry())
}

fn shift(x: f64, y: f64, z: f64) -> IsometryMatrix3<f64> {
    IsometryMatrix3::translation(x, y, z)
}

/// Increases the deviation linearly to the full deviation in a number of cycles. Returns the samples.
fn ramp(motion: &mut Motion, cycles: u32, deviation: impl Fn(f64) -> IsometryMatrix3<f64>) -> Vec<Sample> {
    let samples = (1..=cycles).map(|cycle| {
        assert_eq!(motion.alter(deviation(f64::from(cycle) / f64::from(cycles))), AlterStatus::Done);
        motion.advance(CYCLE)
    });
    samples.collect()
}

fn tip(joints: &Joints) -> IsometryMatrix3<f64> {
    arm().flange(joints)
}

#[test]
fn no_deviation_changes_nothing() {
    let (mut plain, mut altered) = (on_its_way(), on_its_way());
    assert_eq!(altered.alter_begin(frame(), fast()), AlterStatus::Done);
    for _ in 0..300 {
        altered.alter(IsometryMatrix3::identity());
        let (plain, altered) = (plain.advance(CYCLE), altered.advance(CYCLE));
        assert_eq!((plain.joints, plain.id), (altered.joints, altered.id));
    }
}

#[test]
fn a_shift_in_a_frame_moves_the_path_along_its_axes() {
    let (mut plain, mut altered) = (on_its_way(), on_its_way());
    altered.alter_begin(frame(), fast());
    ramp(&mut altered, 50, |share| shift(10.0 * share, 0.0, 0.0));
    wait(&mut plain, 50);
    let x: Vector3<f64> = FRAME.isometry().rotation.matrix().column(0).into_owned();
    for _ in 0..200 {
        let (plain, altered) = (plain.advance(CYCLE), altered.advance(CYCLE));
        assert!((altered.pose.translation.vector - plain.pose.translation.vector - x * 10.0).norm() < 1e-9);
        assert_eq!(
            (altered.phase, altered.id),
            (if altered.id < 1.0 { MotionPhase::Alter } else { altered.phase }, plain.id)
        );
    }
}

#[test]
fn a_rotation_around_a_tool_keeps_its_point() {
    let tool = shift(30.0, 0.0, 150.0);
    let (mut plain, mut altered) = (on_its_way(), on_its_way());
    altered.alter_begin(AlterReference::Tool(tool), fast());
    let turn = |share: f64| Trsf::new([0.0; 3], [0.0, 0.0, 30.0 * share]).isometry();
    let samples = ramp(&mut altered, 100, turn);
    for (cycle, sample) in samples.iter().enumerate() {
        let [expected, is] = [tip(&plain.advance(CYCLE).joints), tip(&sample.joints)].map(|flange| flange * tool);
        assert!((is.translation.vector - expected.translation.vector).norm() < 1e-9);
        let angle = expected.rotation.angle_to(&is.rotation).to_degrees();
        assert!((angle - 0.3 * (cycle + 1) as f64).abs() < 1e-6, "{angle}");
    }
}

#[test]
fn a_large_step_is_a_fault_that_needs_a_reset() {
    let mut motion = on_its_way();
    motion.alter_begin(frame(), limits(100.0, 100.0, 100.0, 250.0));
    let before = motion.joints();
    assert_eq!(motion.alter(shift(10.0, 0.0, 0.0)), AlterStatus::Done);
    assert_eq!(motion.advance(CYCLE).joints, before);
    assert_eq!(motion.fault(), Some(&Cause::AlterSpeed));
    wait(&mut motion, 100);
    assert_eq!((motion.joints(), motion.can_go_on()), (before, false));
    let answers = [motion.alter(shift(0.0, 0.0, 0.0)), motion.alter_end(), motion.alter_begin(frame(), fast())];
    assert_eq!((answers, motion.alter_stop_time()), ([AlterStatus::Fault; 3], Seconds(0.0)));
    assert!(motion.record(&request(MovePath::Joint(START), fast(), Blend::Off, 1.0)).is_err());
    motion.reset();
    assert!(motion.is_empty() && motion.joints() == before);
    motion.record(&request(MovePath::Joint(START), fast(), Blend::Off, 0.0)).unwrap();
    run(&mut motion, |_, _| ());
    assert_eq!(motion.joints(), START);
}

#[test]
fn a_deviation_out_of_reach_is_a_fault() {
    let mut motion = on_its_way();
    let endless = SpeedLimits { translation: MillimetresPerSecond(1e9), speed: [1e9; 6], ..fast() };
    motion.alter_begin(frame(), endless);
    motion.alter(shift(5000.0, 0.0, 0.0));
    motion.advance(CYCLE);
    assert!(matches!(motion.fault(), Some(Cause::Unreachable(_))));
}

#[test]
fn answers_follow_the_manual() {
    let mut motion = motion();
    assert_eq!(motion.alter_begin(frame(), fast()), AlterStatus::Waiting);
    assert_eq!((motion.alter_end(), motion.alter(shift(0.0, 0.0, 0.0))), (AlterStatus::Ignored, AlterStatus::Ignored));
    assert_eq!(motion.alter_stop_time(), Seconds(0.0));
    motion.record(&alterable(line(moved(0.0, 200.0, 0.0)), Blend::Off, 0.0)).unwrap();
    assert_eq!(motion.alter_begin(frame(), fast()), AlterStatus::Waiting);
    wait(&mut motion, 10);
    assert_eq!(motion.alter_begin(frame(), fast()), AlterStatus::Done);
    assert_eq!(motion.alter_begin(frame(), fast()), AlterStatus::Ignored);
    assert_eq!(motion.alter_end(), AlterStatus::Done);
    assert_eq!(motion.alter_end(), AlterStatus::Ignored);
    assert_eq!(motion.alter(shift(0.0, 0.0, 0.0)), AlterStatus::Ignored);
    assert_eq!(motion.alter_begin(frame(), fast()), AlterStatus::Waiting, "not again on the same path");
    let codes = [AlterStatus::Done, AlterStatus::Waiting, AlterStatus::Ignored, AlterStatus::Fault];
    assert_eq!(codes.map(AlterStatus::code), [1, 0, -1, -3]);
}

#[test]
fn a_rigid_move_cannot_be_altered() {
    let mut motion = motion();
    motion.record(&request(line(moved(0.0, 200.0, 0.0)), fast(), Blend::Off, 0.0)).unwrap();
    wait(&mut motion, 10);
    assert_eq!(motion.alter_begin(frame(), fast()), AlterStatus::Waiting);
}

#[test]
fn the_deviation_stays_after_alter_end_and_the_next_move_starts_there() {
    let mut motion = on_its_way();
    motion.record(&request(line(moved(0.0, 200.0, -50.0)), fast(), Blend::Off, 1.0)).unwrap();
    assert_eq!(motion.moves().len(), 2);
    motion.alter_begin(frame(), fast());
    ramp(&mut motion, 50, |share| shift(0.0, 0.0, 20.0 * share));
    assert_eq!(motion.alter_end(), AlterStatus::Done);
    let z: Vector3<f64> = FRAME.isometry().rotation.matrix().column(2).into_owned();
    let altered = moved(0.0, 200.0, 0.0).translation.vector + z * 20.0;
    let samples = run(&mut motion, |_, _| ());
    let nearest = samples.iter().map(|sample| (sample.pose.translation.vector - altered).norm());
    assert!(nearest.fold(f64::INFINITY, f64::min) < 0.3);
    for pair in samples.windows(2) {
        assert!((pair[1].pose.translation.vector - pair[0].pose.translation.vector).norm() < 8.0);
        assert!(pair[0].id <= pair[1].id);
    }
    assert!(
        (samples.last().unwrap().pose.translation.vector - moved(0.0, 200.0, -50.0).translation.vector).norm() < 1e-6
    );
    assert_eq!(motion.alter_begin(frame(), fast()), AlterStatus::Waiting);
}

#[test]
fn the_arm_deviates_at_the_end_of_its_path_until_alter_end() {
    let mut motion = on_its_way();
    motion.alter_begin(frame(), fast());
    wait(&mut motion, 300);
    assert!(motion.is_empty() && motion.move_id() == 1.0);
    let before = motion.joints();
    ramp(&mut motion, 50, |share| shift(0.0, 0.0, 20.0 * share));
    assert!((tip(&motion.joints()).translation.vector - tip(&before).translation.vector).norm() > 19.9);
    motion.record(&request(line(moved(0.0, 0.0, 0.0)), fast(), Blend::Off, 1.0)).unwrap();
    let held = motion.joints();
    wait(&mut motion, 100);
    assert!(!motion.is_empty() && motion.joints() == held, "it waits for the end of the deviation");
    motion.alter_end();
    let samples = run(&mut motion, |_, _| ());
    assert!((tip(&samples[0].joints).translation.vector - tip(&held).translation.vector).norm() < 1.0);
    assert!((tip(&motion.joints()).translation.vector - moved(0.0, 0.0, 0.0).translation.vector).norm() < 1e-6);
}

#[test]
fn a_path_that_is_never_altered_continues_after_its_end() {
    let mut motion = motion();
    let corner = Blend::Joint { leave: Millimetres(30.0), reach: Millimetres(30.0) };
    motion.record(&alterable(line(moved(0.0, 100.0, 0.0)), corner, 0.0)).unwrap();
    motion.record(&alterable(line(moved(0.0, 100.0, 100.0)), corner, 1.0)).unwrap();
    motion.record(&request(MovePath::Joint(START), fast(), corner, 2.0)).unwrap();
    motion.record(&request(line(moved(0.0, 50.0, 0.0)), fast(), corner, 3.0)).unwrap();
    motion.close().unwrap();
    let samples = run(&mut motion, |_, _| ());
    assert!(samples.windows(2).all(|pair| pair[0].id <= pair[1].id));
    assert!((tip(&motion.joints()).translation.vector - moved(0.0, 50.0, 0.0).translation.vector).norm() < 1e-6);
    let done = motion.take_events().iter().filter(|step| step.kind == crate::MoveEventKind::Done).count();
    assert_eq!(done, 4);
}

#[test]
fn a_stop_locks_the_deviation_after_the_stop_time() {
    let mut motion = on_its_way();
    motion.alter_begin(frame(), limits(100.0, 20.0, 20.0, 9999.0));
    ramp(&mut motion, 50, |share| shift(0.0, 0.0, 20.0 * share));
    assert!(motion.alter_stop_time().0 < 0.0);
    motion.stop();
    let mut left = motion.alter_stop_time().0;
    assert!(left > 0.05, "{left}");
    let mut cycles = 0;
    while left > 0.0 {
        assert_eq!(motion.alter(shift(0.0, 0.0, 20.0 + f64::from(cycles) * 0.1)), AlterStatus::Done);
        motion.advance(CYCLE);
        assert!((motion.alter_stop_time().0 - (left - CYCLE.0).max(0.0)).abs() < 1e-12);
        left = motion.alter_stop_time().0;
        cycles += 1;
    }
    let held = motion.advance(CYCLE).joints;
    assert_eq!(motion.alter(shift(0.0, 0.0, 0.0)), AlterStatus::Waiting);
    wait(&mut motion, 50);
    assert_eq!(motion.joints(), held);
    motion.restart();
    assert!(motion.alter_stop_time().0 < 0.0);
    assert_eq!(motion.alter(shift(0.0, 0.0, 20.0 + f64::from(cycles) * 0.1)), AlterStatus::Done);
    wait(&mut motion, 500);
    assert!(motion.is_empty() && motion.fault().is_none());
}

#[test]
fn a_reset_brakes_on_the_deviating_path() {
    let mut motion = on_its_way();
    motion.alter_begin(frame(), fast());
    ramp(&mut motion, 50, |share| shift(0.0, 0.0, 20.0 * share));
    let z: Vector3<f64> = FRAME.isometry().rotation.matrix().column(2).into_owned();
    motion.reset();
    let end = motion.destination();
    let samples = run(&mut motion, |_, _| ());
    let start = moved(0.0, 0.0, 0.0).translation.vector + z * 20.0;
    for sample in &samples {
        let offset = sample.pose.translation.vector - start;
        assert!((offset - Vector3::y() * offset.y).norm() < 1e-6, "{offset:?}");
    }
    wait(&mut motion, 2);
    assert!(motion.joints().iter().zip(end).all(|(is, end)| (is - end).abs() < 1e-6), "{:?} {end:?}", motion.joints());
    motion.record(&request(MovePath::Joint(START), fast(), Blend::Off, 0.0)).unwrap();
    run(&mut motion, |_, _| ());
    assert_eq!(motion.joints(), START);
}

#[test]
fn an_alterable_joint_move_keeps_the_configuration() {
    let mut motion = motion();
    let other = MovePath::Joint([0.0, 0.0, 90.0, 0.0, -30.0, 0.0]);
    assert_eq!(motion.record(&alterable(other, Blend::Off, 0.0)), Err(Cause::Configuration));
    assert!(motion.record(&alterable(MovePath::Joint([20.0, 0.0, 90.0, 0.0, 60.0, 0.0]), Blend::Off, 0.0)).is_ok());
}

#[test]
fn a_copy_of_a_deviating_arm_does_the_same() {
    let mut motion = on_its_way();
    motion.alter_begin(frame(), fast());
    ramp(&mut motion, 20, |share| shift(0.0, 0.0, 20.0 * share));
    let mut copy = motion.clone();
    assert!((0..200).all(|_| motion.advance(CYCLE) == copy.advance(CYCLE)));
}

/// With a blend, the arm does not stop between the deviated path and the next move.
#[test]
fn the_arm_does_not_stop_after_an_early_alter_end() {
    let corner = Blend::Joint { leave: Millimetres(30.0), reach: Millimetres(30.0) };
    let references = [frame(), AlterReference::Tool(shift(0.0, 0.0, 120.0))];
    for (reference, is_late) in references.into_iter().flat_map(|reference| [(reference, false), (reference, true)]) {
        let mut motion = motion();
        motion.record(&alterable(line(moved(0.0, 200.0, 0.0)), corner, 0.0)).unwrap();
        let next = request(line(moved(0.0, 200.0, -150.0)), limits(100.0, 100.0, 100.0, 200.0), Blend::Off, 1.0);
        if !is_late {
            motion.record(&next).unwrap();
        }
        wait(&mut motion, 50);
        motion.alter_begin(reference, fast());
        let deviation = |share: f64| Trsf::new([0.0, 0.0, 15.0 * share], [10.0 * share, 0.0, 0.0]).isometry();
        let mut samples = ramp(&mut motion, 50, deviation);
        motion.alter_end();
        if is_late {
            motion.record(&next).unwrap();
        }
        samples.extend(run(&mut motion, |_, _| ()));
        let blend = samples.iter().position(|sample| sample.phase == MotionPhase::Blend).unwrap();
        let around = &samples[blend - 10..blend + 20];
        assert!(around.iter().all(|sample| sample.speed.0 > 50.0), "{reference:?}");
        let change = |pair: &[Sample], axis: usize| pair[1].joints[axis] - pair[0].joints[axis];
        for three in around.windows(3) {
            for (axis, speed) in NOMINAL.into_iter().enumerate() {
                let jump = (change(&three[1..], axis) - change(&three[..2], axis)) / CYCLE.0;
                assert!(jump.abs() < 6.0 * speed * CYCLE.0, "{reference:?} axis {axis}: {jump}");
            }
        }
        assert!(
            (tip(&motion.joints()).translation.vector - moved(0.0, 200.0, -150.0).translation.vector).norm() < 1e-6
        );
        assert_eq!((motion.move_id(), motion.is_empty()), (2.0, true));
    }
}

#[test]
fn a_move_after_an_alterable_path_that_waits_at_its_corner_is_recorded_at_once() {
    let corner = Blend::Joint { leave: Millimetres(30.0), reach: Millimetres(30.0) };
    let mut motion = motion();
    motion.record(&alterable(line(moved(0.0, 100.0, 0.0)), corner, 0.0)).unwrap();
    wait(&mut motion, 500);
    assert!(!motion.can_go_on());
    motion.record(&request(MovePath::Joint(START), fast(), Blend::Off, 1.0)).unwrap();
    assert!(motion.can_go_on());
    run(&mut motion, |_, _| ());
    assert_eq!(motion.joints(), START);
}
