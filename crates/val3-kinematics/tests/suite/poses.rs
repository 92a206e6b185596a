//! Poses from controllers and data sheets (manual 11.4.1).

use val3_geometry::Trsf;
use val3_kinematics::{Arm, Configuration, Elbow, Joints, Shoulder, Wrist};

use crate::{arm, difference, positions};

fn assert_flange(name: &str, joints: Joints, translation: [f64; 3]) {
    let flange = arm(name).forward(&joints);
    let off = flange.distance(&Trsf::new(translation, [0.0; 3]));
    assert!(off < 1e-9, "{name} {joints:?}: {flange:?}");
}

/// Values that a controller returns for a TX2-40, in radians and mm.
#[test]
fn a_controller_computes_the_same_pose() {
    let joints = [
        0.17802266491284555,
        0.1432564284624061,
        0.04146861396584183,
        0.018220282913886117,
        -0.04335413201761794,
        0.02481753214525766,
    ]
    .map(f64::to_degrees);
    let angles = [-0.024414085476768644, 0.13927023042103168, 0.22269036667578948].map(f64::to_degrees);
    let expected = Trsf::new([75.11429807347457, 49.02500428270507, 508.2186620597094], angles);
    let arm = arm("TX2-40");
    let (mm, rotation) = difference(&arm.flange(&joints), &expected.isometry());
    assert!(mm < 1e-12 && rotation < 1e-15, "{mm:e} {rotation:e}");
    let configuration = Configuration::new(Shoulder::Lefty, Elbow::Positive, Wrist::Negative);
    assert_eq!(arm.configuration(&joints), configuration);
}

/// A recorded position of a TX90. Its joints are stored to 0.01 degrees.
#[test]
fn a_recorded_position_agrees_with_its_joints() {
    let flange = arm("TX90").forward(&[0.0, 4.98, -90.18, 0.0, 85.08, 0.0]);
    let expected = Trsf::new([-336.829738845272, 49.9999961803571, 558.957317821961], [0.0, -0.115117715818688, 0.0]);
    assert!(flange.distance(&expected) < 0.005, "{flange:?}");
    assert!((flange.ry - expected.ry).abs() < 0.01, "{flange:?}");
}

#[test]
fn zero_stretches_the_arm_upwards() {
    assert_flange("TX60", [0.0; 6], [0.0, 20.0, 670.0]);
    assert_flange("TX90", [0.0; 6], [50.0, 50.0, 950.0]);
    assert_flange("RX160", [0.0; 6], [150.0, 0.0, 1560.0]);
    for name in ["TX60", "TX90", "RX160"] {
        assert_eq!(arm(name).forward(&[0.0; 6]).angles(), [0.0; 3]);
    }
}

#[test]
fn a_bent_arm_points_forwards() {
    let bent = [0.0, 0.0, 90.0, 0.0, 90.0, 0.0];
    assert_flange("TX60", bent, [310.0, 20.0, 220.0]);
    assert_flange("TX90", bent, [475.0, 50.0, 325.0]);
    assert_flange("RX160", bent, [775.0, 0.0, 715.0]);
}

/// Distance between the centre of the wrist and axis 2, as in data sheets for the folded and the stretched arm.
#[test]
fn data_sheets_give_the_same_radii() {
    assert!((radius("TX40", 138.0) - 161.3).abs() < 0.05);
    assert!((radius("TX90", 145.0) - 255.6).abs() < 0.05);
    assert!((radius("TX90", 0.0) - 850.0).abs() < 1e-9);
    let reach = radius("TX90", 0.0) + arm("TX90").links(&[0.0; 6])[1].translation.vector.x;
    assert!((reach - 900.0).abs() < 1e-9);
    assert_eq!(["TX90", "TX2-160L", "TS2-60"].map(|name| arm(name).reach()), [1000.0, 2010.0, 620.0]);
}

/// Distance between the centre of the wrist and axis 2, in mm.
fn radius(name: &str, j3: f64) -> f64 {
    let links = arm(name).links(&[0.0, 0.0, j3, 0.0, 0.0, 0.0]);
    let from_axis_2 = links[4].translation.vector - links[1].translation.vector;
    (from_axis_2.x.powi(2) + from_axis_2.z.powi(2)).sqrt()
}

#[test]
fn the_last_link_ends_at_the_flange() {
    for arm in Arm::names().map(arm) {
        for joints in positions(&arm, 20) {
            let links = arm.links(&joints);
            assert_eq!(links.len(), arm.axes() + 1);
            let (mm, rotation) = difference(links.last().unwrap(), &arm.flange(&joints));
            assert!(mm < 2e-12 && rotation < 3e-15, "{}: {mm:e} {rotation:e}", arm.name());
        }
    }
}

#[test]
fn the_flange_of_a_scara_arm_points_down() {
    let flange = arm("TS2-60").forward(&[0.0, 0.0, 100.0, 30.0, 0.0, 0.0]);
    assert_eq!(flange, Trsf::new([620.0, 0.0, 100.0], [180.0, 0.0, 30.0]));
}

/// The Jacobian agrees with differences of the forward kinematics.
#[test]
fn the_jacobian_is_the_derivative_of_the_pose() {
    const STEP: f64 = 1e-4;
    for arm in ["TX2-60L", "RX160", "TS60"].map(arm) {
        for joints in positions(&arm, 20) {
            let columns = arm.jacobian(&joints);
            for axis in 0..arm.axes() {
                let [before, after] = [-STEP, STEP].map(|by| {
                    let mut shifted = joints;
                    shifted[axis] += by;
                    arm.flange(&shifted)
                });
                let linear = (after.translation.vector - before.translation.vector) / (2.0 * STEP);
                assert!((linear - columns[axis].linear).amax() < 1e-6, "{} axis {}", arm.name(), axis + 1);
                let turn = (after.rotation * before.rotation.inverse()).matrix() / (2.0 * STEP);
                let angular = [turn.m32, turn.m13, turn.m21].map(f64::to_degrees);
                let off = angular.iter().zip(columns[axis].angular.iter()).map(|(left, right)| (left - right).abs());
                assert!(off.fold(0.0, f64::max) < 1e-6, "{} axis {}", arm.name(), axis + 1);
            }
        }
    }
}
