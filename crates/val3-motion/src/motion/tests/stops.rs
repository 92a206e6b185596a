//! Stops, emergency stops and the monitor speed.

use super::*;

/// Motion that turns axis 1 by 90 degrees in 0.54 s.
fn joint_move() -> Motion {
    let mut motion = motion();
    motion.record(&request(MovePath::Joint([90.0, 0.0, 90.0, 0.0, 90.0, 0.0]), fast(), Blend::Off, 0.0)).unwrap();
    motion
}

#[test]
fn an_emergency_stop_brakes_twice_as_hard_on_the_path() {
    let slow = braking_way(Motion::stop);
    let fast = braking_way(Motion::brake);
    let soft = braking_way(|motion| {
        motion.stop();
        motion.brake();
    });
    assert!((2.0 * fast - slow).abs() < 0.2, "{fast}");
    assert!((soft - fast).abs() < 1e-9);
}

/// Degrees by which axis 1 moves after a stop in the middle of a joint move.
fn braking_way(stop: fn(&mut Motion)) -> f64 {
    let mut motion = joint_move();
    wait(&mut motion, 60);
    let from = motion.joints()[0];
    stop(&mut motion);
    wait(&mut motion, 100);
    motion.joints()[0] - from
}

/// Each reset removes the moves that were recorded while the arm had no power.
#[test]
fn resets_without_power_leave_no_moves() {
    let mut motion = motion();
    motion.brake();
    for _ in 0..3 {
        for side in [90.0, 0.0] {
            let path = MovePath::Joint([side, 0.0, 90.0, 0.0, 90.0, 0.0]);
            motion.record(&request(path, fast(), Blend::Off, 0.0)).unwrap();
        }
        wait(&mut motion, 2);
        assert!(!motion.is_empty());
        motion.reset();
        wait(&mut motion, 2);
        assert!(motion.is_empty());
    }
    motion.resume();
    wait(&mut motion, 100);
    assert_eq!(motion.joints(), START);
}

/// A stop outlasts a power loss, and the return of power does not restart the motion.
#[test]
fn power_and_stops_hold_the_arm_independently() {
    let mut motion = joint_move();
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
    assert!(halted.iter().all(|sample| sample.joints == samples[300].joints && sample.phase == MotionPhase::Waiting));
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
fn half_the_monitor_speed_takes_twice_the_time() {
    let [half, full] = [50.0, 100.0].map(|speed| {
        let mut motion = motion();
        motion.set_monitor_speed(Percent(speed));
        corner(&mut motion, |leave, reach| Blend::Cartesian { leave, reach }, fast());
        run(&mut motion, |_, _| ()).len()
    });
    assert!(half.abs_diff(2 * full) <= 2);
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

/// The deceleration of a stop does not depend on the monitor speed.
#[test]
fn a_stop_at_a_low_monitor_speed_is_as_hard_as_any_other() {
    let mut motion = joint_move();
    motion.set_monitor_speed(Percent(20.0));
    wait(&mut motion, 275);
    let before = speed(&mut motion);
    assert!((before - 0.2 * NOMINAL[0]).abs() < 1e-6, "{before}");
    motion.stop();
    let deceleration = (before - speed(&mut motion)) / CYCLE.0;
    // The first cycle contains half of the deceleration.
    assert!((deceleration - 2.5 * NOMINAL[0]).abs() < 1.0, "{deceleration}");
    motion.restart();
    let samples = run(&mut motion, |_, _| ());
    assert!(samples.windows(2).all(|pair| pair[1].joints[0] - pair[0].joints[0] <= 0.2001 * NOMINAL[0] * CYCLE.0));
    assert_eq!(motion.joints()[0], 90.0);
}

/// Speed of axis 1 in the next cycle, in degrees per second.
fn speed(motion: &mut Motion) -> f64 {
    let before = motion.joints()[0];
    (motion.advance(CYCLE).joints[0] - before) / CYCLE.0
}

#[test]
fn a_restart_while_the_arm_brakes_continues_after_the_stop() {
    let mut motion = joint_move();
    wait(&mut motion, 50);
    motion.stop();
    motion.advance(CYCLE);
    motion.restart();
    let samples = run(&mut motion, |_, _| ());
    assert_eq!(samples[0].phase, MotionPhase::Stopping);
    assert!(samples.iter().any(|sample| sample.speed.0 < 20.0));
    assert_eq!(motion.joints()[0], 90.0);
}

#[test]
fn a_stop_at_monitor_speed_zero_is_a_stop() {
    for late in [75, 130] {
        let mut motion = joint_move();
        wait(&mut motion, late);
        motion.set_monitor_speed(Percent(0.0));
        wait(&mut motion, 100);
        let held = motion.joints();
        motion.brake();
        wait(&mut motion, 2);
        assert!(!motion.is_going() && motion.joints() == held);
        motion.resume();
        motion.set_monitor_speed(Percent(100.0));
        run(&mut motion, |_, _| ());
        assert_eq!(motion.joints()[0], 90.0);
    }
}

#[test]
fn an_emergency_stop_does_not_depend_on_the_descriptor() {
    let mut motion = motion();
    let gentle = limits(100.0, 10.0, 10.0, 99999.0);
    motion.record(&request(MovePath::Joint([90.0, 0.0, 90.0, 0.0, 90.0, 0.0]), gentle, Blend::Off, 0.0)).unwrap();
    wait(&mut motion, 100);
    let before = motion.joints()[0];
    let speed = (motion.advance(CYCLE).joints[0] - before) / CYCLE.0;
    let from = motion.joints()[0];
    motion.brake();
    wait(&mut motion, 100);
    let way = motion.joints()[0] - from;
    let expected = speed * speed / (2.0 * 2.0 * 5.0 * NOMINAL[0]);
    assert!((way - expected).abs() < 0.1 * expected, "{way} instead of {expected}");
}
