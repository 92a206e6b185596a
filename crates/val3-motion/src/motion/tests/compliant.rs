//! Compliant moves: section (i) of the motion model.

use super::*;
use crate::{Cause, ExternalForce, MoveEventKind};
use val3_geometry::Vector3;

/// Motion on a line of 200 mm along y under a force, with a maximum speed of 500 mm/s.
fn pushed(force: f64) -> Motion {
    let mut motion = motion();
    let limits = limits(100.0, 100.0, 100.0, 500.0);
    let request = request(line(moved(0.0, 200.0, 0.0)), limits, Blend::Off, 4.0);
    motion.record(&Move { manner: Manner::Compliant(Percent(force)), ..request }).unwrap();
    motion
}

fn way(motion: &Motion) -> f64 {
    let tip = arm().flange(&motion.joints());
    (tip.translation.vector - moved(0.0, 0.0, 0.0).translation.vector).norm()
}

/// The nominal force of the arm, in N.
fn nominal_force() -> f64 {
    let payload = arm().payload();
    payload.nominal.or(payload.maximum).unwrap() * 9.81
}

#[test]
fn without_a_force_the_arm_rests() {
    let mut motion = pushed(0.0);
    assert!(!motion.is_compliant());
    motion.advance(CYCLE);
    assert!(motion.is_compliant());
    wait(&mut motion, 15_000);
    assert!(motion.joints() == START && motion.is_compliant() && !motion.is_empty());
}

#[test]
fn half_the_nominal_force_moves_it_at_half_the_speed_to_the_end() {
    let mut motion = pushed(50.0);
    let samples = run(&mut motion, |_, _| ());
    let fastest = samples.iter().map(|sample| sample.speed.0).fold(0.0, f64::max);
    assert!((220.0..=250.0).contains(&fastest), "{fastest}");
    let moving = samples.len() - 1;
    assert!(samples[..moving].iter().all(|sample| sample.phase == MotionPhase::Compliant));
    assert!((way(&motion) - 200.0).abs() < 1e-9 && !motion.is_compliant());
    assert_eq!(motion.move_id(), 5.0);
    let steps: Vec<_> = motion.take_events().iter().map(|step| step.kind).collect();
    assert_eq!(steps, [MoveEventKind::Started, MoveEventKind::Done]);
}

#[test]
fn a_large_force_keeps_the_limits_of_the_descriptor() {
    let mut motion = pushed(1000.0);
    let samples = run(&mut motion, |_, _| ());
    assert!(samples.iter().all(|sample| sample.speed.0 < 500.5));
    assert!(samples.iter().any(|sample| sample.speed.0 > 495.0));
    let change = |pair: &[Sample], axis: usize| pair[1].joints[axis] - pair[0].joints[axis];
    for three in samples[..samples.len() - 1].windows(3) {
        for (axis, speed) in NOMINAL.into_iter().enumerate() {
            let acceleration = (change(&three[1..], axis) - change(&three[..2], axis)) / CYCLE.0.powi(2);
            assert!(acceleration.abs() < 5.0 * speed * 1.05, "axis {axis}: {acceleration}");
        }
    }
}

#[test]
fn a_negative_force_needs_a_greater_one_from_outside() {
    let mut motion = pushed(-50.0);
    wait(&mut motion, 1000);
    assert_eq!(motion.joints(), START);
    motion.set_external_force(ExternalForce::World(Vector3::new(500.0, 0.4 * nominal_force(), 0.0)));
    wait(&mut motion, 1000);
    assert_eq!(motion.joints(), START);
    motion.set_external_force(ExternalForce::World(Vector3::y() * 0.8 * nominal_force()));
    wait(&mut motion, 200);
    assert!(way(&motion) > 50.0);
    motion.set_external_force(ExternalForce::default());
    let mut before = way(&motion);
    let back = (0..1000).find(|_| {
        motion.advance(CYCLE);
        let now = way(&motion);
        assert!(now <= before + 10.0);
        before = now;
        now == 0.0
    });
    assert!(back.is_some() && motion.is_compliant() && motion.move_id() == 4.0);
    wait(&mut motion, 10);
    assert_eq!(motion.joints(), START);
}

#[test]
fn a_stop_ends_the_compliance_until_the_restart() {
    let mut motion = pushed(100.0);
    wait(&mut motion, 40);
    motion.stop();
    assert!(!motion.is_compliant());
    let held = motion.joints();
    motion.set_external_force(ExternalForce::Path(1000.0));
    wait(&mut motion, 100);
    assert_eq!(motion.joints(), held);
    motion.restart();
    wait(&mut motion, 1);
    assert!(motion.is_compliant());
    run(&mut motion, |_, _| ());
    assert!((way(&motion) - 200.0).abs() < 1e-9);
}

#[test]
fn a_reset_ends_it_where_the_arm_is() {
    let mut motion = pushed(100.0);
    motion.record(&request(line(moved(0.0, 0.0, 0.0)), fast(), Blend::Off, 5.0)).unwrap();
    wait(&mut motion, 40);
    let held = motion.joints();
    motion.reset();
    assert!(!motion.is_compliant() && motion.is_empty() && motion.joints() == held);
    motion.record(&request(MovePath::Joint(START), fast(), Blend::Off, 0.0)).unwrap();
    run(&mut motion, |_, _| ());
    assert_eq!(motion.joints(), START);
}

#[test]
fn rigid_moves_before_and_after_stop_at_its_ends() {
    let mut motion = motion();
    let corner = Blend::Joint { leave: Millimetres(50.0), reach: Millimetres(50.0) };
    let compliant = Manner::Compliant(Percent(100.0));
    motion.record(&request(line(moved(0.0, 100.0, 0.0)), fast(), Blend::Off, 0.0)).unwrap();
    let middle = request(MovePath::Joint([20.0, 0.0, 90.0, 0.0, 90.0, 0.0]), fast(), corner, 1.0);
    motion.record(&Move { manner: compliant, ..middle }).unwrap();
    motion.record(&request(line(moved(0.0, 0.0, 0.0)), fast(), corner, 2.0)).unwrap();
    let refused =
        motion.record(&Move { manner: compliant, ..request(line(moved(0.0, 90.0, 0.0)), fast(), corner, 3.0) });
    assert_eq!(refused, Err(Cause::BlendBeforeCompliant));
    motion.close().unwrap();
    let samples = run(&mut motion, |_, _| ());
    let mut phases: Vec<_> = samples.iter().map(|sample| sample.phase).collect();
    phases.dedup();
    assert_eq!(phases, [MotionPhase::Nominal, MotionPhase::Compliant, MotionPhase::Nominal]);
    assert!(samples.windows(2).all(|pair| pair[0].id <= pair[1].id));
    assert!(way(&motion) < 1e-6);
}

#[test]
fn a_rotation_yields_too() {
    let mut motion = motion();
    let turned = moved(0.0, 0.0, 0.0) * Trsf::new([0.0; 3], [0.0, 0.0, 60.0]).isometry();
    let request = request(line(turned), fast(), Blend::Off, 0.0);
    motion.record(&Move { manner: Manner::Compliant(Percent(50.0)), ..request }).unwrap();
    run(&mut motion, |_, _| ());
    assert!((motion.joints()[5] - 60.0).abs() < 1e-6);
}
