//! Calibrated arms (manual 11.4).

use val3_kinematics::{Arm, Dh, Joints};

use crate::{apart, arm, difference, positions};

/// Next number from -1 to 1 of a linear congruential generator.
fn next_noise(state: &mut u32) -> f64 {
    *state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
    f64::from(*state) / f64::from(u32::MAX) * 2.0 - 1.0
}

/// Returns parameters as from a measurement: lengths differ by up to 0.5 mm, angles by up to 0.1 degrees.
fn measured(arm: &Arm) -> Dh {
    let mut dh = arm.default_dh();
    let mut state = 1_u32;
    let mut noise = |scale: f64| scale * next_noise(&mut state);
    for axis in 0..arm.axes() {
        dh.theta[axis] += noise(0.1);
        dh.d[axis] += noise(0.5);
        dh.a[axis] += noise(0.5);
        dh.b[axis] += noise(0.5);
        dh.alpha[axis] += noise(0.1);
        dh.beta[axis] += noise(0.1);
    }
    dh
}

fn is_far_from_singular(joints: &Joints) -> bool {
    joints[2].abs() > 10.0 && joints[4].abs() > 10.0
}

#[test]
fn newton_finds_the_joints_of_a_calibrated_arm() {
    for mut arm in ["TX60", "TX2-90", "RX160", "TS60"].map(arm) {
        arm.set_dh(&measured(&arm)).unwrap();
        let (mut tried, mut found) = (0, 0);
        for joints in positions(&arm, 500).filter(|joints| arm.is_scara() || is_far_from_singular(joints)) {
            tried += 1;
            let Ok(again) = arm.inverse_isometry_on(arm.configuration(&joints), &arm.flange(&joints), &joints) else {
                continue;
            };
            let (mm, _) = difference(&arm.flange(&again), &arm.flange(&joints));
            assert!(mm < 1e-9, "{} {joints:?}: {mm:e}", arm.name());
            found += usize::from(apart(&again, &joints) < 1e-6);
        }
        assert!(found * 100 >= tried * 98, "{}: {found} of {tried}", arm.name());
    }
}

#[test]
fn calibration_changes_the_pose_and_can_be_undone() {
    let mut arm = arm("TX2-90");
    let joints = [10.0, 20.0, 70.0, 30.0, 50.0, 40.0];
    let nominal = arm.forward(&joints);
    arm.set_dh(&measured(&arm)).unwrap();
    assert!(arm.is_calibrated() && arm.forward(&joints).distance(&nominal) > 0.01);
    assert_eq!(arm.dh(), measured(&arm));
    arm.set_dh(&arm.default_dh()).unwrap();
    assert!(!arm.is_calibrated());
    assert_eq!(arm.forward(&joints), nominal);
}

#[test]
fn parameters_far_from_the_nominal_ones_are_refused() {
    let mut arm = arm("TX2-90");
    let mut refused = [arm.default_dh(); 3];
    refused[0].a[1] += 5.1;
    refused[1].alpha[0] -= 2.1;
    refused[2].d[6] = f64::NAN;
    let mut accepted = arm.default_dh();
    accepted.a[1] += 4.9;
    for dh in refused {
        arm.set_dh(&dh).unwrap_err();
        assert!(!arm.is_calibrated());
    }
    arm.set_dh(&accepted).unwrap();
    let error = arm.set_dh(&refused[0]).unwrap_err();
    assert_eq!(error.to_string(), "a[1] is 430.1, which differs by more than 5 from the nominal 425");
    assert_eq!(arm.dh(), accepted);
}

/// Values that a controller returns for a TX2-40.
#[test]
fn nominal_parameters_are_those_of_the_controller() {
    let dh = arm("TX2-40").default_dh();
    assert_eq!(dh.theta, [0.0, -90.0, 90.0, 0.0, 0.0, 0.0]);
    assert_eq!(dh.d, [0.0, 0.0, 35.0, 225.0, 0.0, 65.0, 0.0]);
    assert_eq!(dh.a, [0.0, 225.0, 0.0, 0.0, 0.0, 0.0]);
    assert_eq!(dh.alpha, [-90.0, 0.0, 90.0, -90.0, 90.0, 0.0]);
}
