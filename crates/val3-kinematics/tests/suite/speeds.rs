//! Speeds beyond the maximum, and the origin of times.

use val3_kinematics::Arm;

fn excess(arm: &str, vel: f64, axes: &[usize]) -> Option<String> {
    let excess = Arm::by_name(arm).unwrap().excess_speed(vel, |axis| axes.contains(&axis));
    excess.map(|excess| format!("{excess}; {}", excess.greatest_vel))
}

#[test]
fn the_axis_with_the_least_reserve_is_named() {
    let all = [0, 1, 2, 3, 4, 5];
    assert_eq!(excess("TX2-90", 100.0, &all), None);
    insta::assert_snapshot!(
        [
            excess("TX2-90", 200.0, &all),
            excess("TX2-90", 200.0, &[1]),
            excess("TX2-90", 152.0, &[0]),
            excess("TP80", 152.0, &[2]),
        ]
        .map(|found| found.unwrap_or_default())
        .join("\n")
    );
    assert_eq!(excess("TX2-90", 150.0, &[0]), None);
    assert_eq!(excess("TX2-90", 1000.0, &[]), None);
}

#[test]
fn maximum_speeds_of_the_model_limit_nothing() {
    assert_eq!(excess("TS2-60", 1000.0, &[0, 1, 2, 3]), None);
}

/// 150 % of a nominal speed of 0.66 times the maximum is 99 % of the maximum, and 151 % is 99.66 %.
#[test]
fn the_greatest_vel_is_allowed() {
    for name in Arm::names() {
        let arm = Arm::by_name(name).unwrap();
        if let Some(excess) = arm.excess_speed(1000.0, |_| true) {
            assert_eq!(arm.excess_speed(excess.greatest_vel, |_| true), None, "{name}");
            assert!(arm.excess_speed(excess.greatest_vel + 1.0, |_| true).is_some(), "{name}");
        }
    }
}

#[test]
fn the_note_names_the_arm() {
    let arm = Arm::by_name("TX2-90").unwrap();
    assert_eq!(arm.times_origin(), "model");
    insta::assert_snapshot!(arm.times_note().unwrap_or_default());
}
