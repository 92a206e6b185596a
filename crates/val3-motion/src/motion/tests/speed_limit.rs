//! Acting speed limit in each cycle.

use std::collections::BTreeMap;

use proptest::prelude::*;

use super::*;
use crate::SpeedLimit;

/// Number of cycles for each limit, the most frequent limit first.
fn limits_of(motion: &mut Motion) -> Vec<(SpeedLimit, usize)> {
    let mut counts = BTreeMap::<SpeedLimit, usize>::new();
    let mut cycles = 0;
    while !motion.is_empty() {
        motion.advance(CYCLE);
        *counts.entry(motion.speed_limit()).or_default() += 1;
        cycles += 1;
        assert!(cycles < 100_000, "{counts:?}");
    }
    let mut counts: Vec<_> = counts.into_iter().collect();
    counts.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    counts
}

fn recorded(moves: &[Move]) -> Motion {
    let mut motion = motion();
    moves.iter().for_each(|request| motion.record(request).unwrap());
    motion
}

fn names(limits: &[(SpeedLimit, usize)]) -> Vec<SpeedLimit> {
    limits.iter().map(|(limit, _)| *limit).collect()
}

#[test]
fn a_short_joint_move_accelerates_and_decelerates_its_slowest_axis() {
    let path = MovePath::Joint([1.0, 2.0, 92.0, 10.0, 90.0, 0.0]);
    let mut motion = recorded(&[request(path, limits(100.0, 100.0, 50.0, 99999.0), Blend::Off, 0.0)]);
    // Axis 4 determines the duration. It brakes twice as long as it accelerates.
    let limits = limits_of(&mut motion);
    assert_eq!(names(&limits), [SpeedLimit::Deceleration(3), SpeedLimit::Acceleration(3)], "{limits:?}");
    let counts = [limits[0].1, limits[1].1];
    assert!(counts[0].abs_diff(2 * counts[1]) <= 2, "{limits:?}");
}

#[test]
fn a_long_joint_move_reaches_the_speed_of_its_slowest_axis() {
    let path = MovePath::Joint([180.0, 10.0, 90.0, 0.0, 90.0, 0.0]);
    let limits = limits_of(&mut recorded(&[request(path, fast(), Blend::Off, 0.0)]));
    let (speed, up, down) = (SpeedLimit::AxisSpeed(0), SpeedLimit::Acceleration(0), SpeedLimit::Deceleration(0));
    assert!(limits[0] == (speed, 120) && limits[1..].iter().all(|(limit, _)| [up, down].contains(limit)), "{limits:?}");
}

#[test]
fn a_slow_line_is_limited_by_the_speed_of_the_tool() {
    let slow = limits(100.0, 100.0, 100.0, 100.0);
    let limits = limits_of(&mut recorded(&[request(line(moved(0.0, 200.0, 0.0)), slow, Blend::Off, 0.0)]));
    assert!(limits[0].0 == SpeedLimit::Translation && limits[0].1 > 480, "{limits:?}");
    let turned = moved(0.0, 0.0, -10.0) * Trsf::new([0.0; 3], [0.0, 0.0, 40.0]).isometry();
    let slow = SpeedLimits { rotation: DegreesPerSecond(20.0), ..fast() };
    let limits = limits_of(&mut recorded(&[request(line(turned), slow, Blend::Off, 0.0)]));
    assert!(limits[0].0 == SpeedLimit::Rotation && limits[0].1 > 480, "{limits:?}");
}

#[test]
fn the_monitor_speed_is_the_limit_below_full_speed() {
    let path = MovePath::Joint([90.0, 0.0, 90.0, 0.0, 90.0, 0.0]);
    let mut motion = recorded(&[request(path, fast(), Blend::Off, 0.0)]);
    motion.set_monitor_speed(Percent(10.0));
    assert_eq!(names(&limits_of(&mut motion)), [SpeedLimit::MonitorSpeed]);
    let path = MovePath::Joint([0.0, 0.0, 90.0, 0.0, 90.0, 0.0]);
    motion.record(&request(path, fast(), Blend::Off, 1.0)).unwrap();
    motion.set_monitor_speed(Percent(0.0));
    motion.advance(CYCLE);
    assert_eq!(motion.speed_limit(), SpeedLimit::MonitorSpeed);
}

#[test]
fn a_sharp_corner_is_a_limit() {
    let mut motion = motion();
    let blend = |leave, reach| Blend::Cartesian { leave, reach };
    corner(&mut motion, blend, fast());
    let limits = limits_of(&mut motion);
    assert!(limits.iter().any(|(limit, count)| *limit == SpeedLimit::Corner && *count > 10), "{limits:?}");
}

#[test]
fn reduced_speed_is_a_limit() {
    let mut motion = recorded(&[request(line(moved(0.0, 200.0, 0.0)), fast(), Blend::Off, 0.0)]);
    motion.limit_tool_speed(Some(MillimetresPerSecond(250.0)));
    let limits = limits_of(&mut motion);
    assert!(limits[0].0 == SpeedLimit::ReducedSpeed && limits[0].1 > 180, "{limits:?}");
}

#[test]
fn an_arm_at_rest_has_a_reason() {
    let mut motion = motion();
    let blend = Blend::Joint { leave: Millimetres(50.0), reach: Millimetres(50.0) };
    assert_eq!(limit_after(&mut motion, 1), SpeedLimit::End);
    motion.record(&request(line(moved(0.0, 200.0, 0.0)), fast(), blend, 0.0)).unwrap();
    assert_eq!(limit_after(&mut motion, 500), SpeedLimit::NextMove);
    motion.close().unwrap();
    assert_eq!(limit_after(&mut motion, 5), SpeedLimit::Acceleration(0));
    motion.stop();
    assert_eq!(limit_after(&mut motion, 1), SpeedLimit::Stop);
    assert_eq!(limit_after(&mut motion, 100), SpeedLimit::Held);
    motion.restart();
    assert_eq!(limit_after(&mut motion, 500), SpeedLimit::End);
}

fn limit_after(motion: &mut Motion, cycles: usize) -> SpeedLimit {
    wait(motion, cycles);
    motion.speed_limit()
}

/// The next move is recorded after the cycle in which the arm has arrived.
#[test]
fn the_next_move_does_not_change_the_limit_of_the_last_cycle() {
    let path = MovePath::Joint([10.0, 0.0, 90.0, 0.0, 90.0, 0.0]);
    let mut motion = recorded(&[request(path, fast(), Blend::Off, 0.0)]);
    while !motion.is_empty() {
        motion.advance(CYCLE);
    }
    motion.record(&request(MovePath::Joint(START), fast(), Blend::Off, 1.0)).unwrap();
    assert_eq!(motion.speed_limit(), SpeedLimit::Deceleration(0));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// The plan is time-optimal, so a limit is reached in nearly every cycle.
    #[test]
    fn the_acting_limit_is_reached(
        corners in prop::collection::vec((-150.0..150.0_f64, -150.0..150.0_f64, -150.0..150.0_f64), 2..6),
        tvel in prop_oneof![Just(99999.0), 50.0..800.0_f64],
        distance in 5.0..60.0_f64,
        is_joint in any::<bool>(),
    ) {
        let mut motion = motion();
        let ends = (Millimetres(distance), Millimetres(distance));
        let blend = match is_joint {
            true => Blend::Joint { leave: ends.0, reach: ends.1 },
            false => Blend::Cartesian { leave: ends.0, reach: ends.1 },
        };
        for ((x, y, z), id) in corners.into_iter().zip(0..) {
            let request = request(line(moved(x, y, z)), limits(100.0, 80.0, 80.0, tvel), blend, f64::from(id));
            prop_assume!(motion.record(&request).is_ok());
        }
        prop_assume!(motion.close().is_ok());
        let (mut cycles, mut reached) = (0, 0);
        while !motion.is_empty() {
            motion.advance(CYCLE);
            if let ActingLimit::OnPath(state) = &motion.acting {
                cycles += 1;
                let load = state.load(&Model(&motion.arm));
                prop_assert!(load < 1.05, "{load} of {}", motion.speed_limit());
                reached += usize::from(load > 0.9);
            }
        }
        prop_assert!(reached * 10 >= cycles * 9, "{reached} of {cycles}");
    }
}
