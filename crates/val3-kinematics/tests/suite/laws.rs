//! Laws that hold for all joint positions of all arms.

use proptest::prelude::*;
use val3_kinematics::{Arm, Joints, RequestedConfiguration};

use crate::{apart, arm, difference, positions};

/// Number of positions per arm.
const POSITIONS: usize = 100;

/// Whether the position is not near a singular one, where a pose has many joint positions.
fn is_regular(arm: &Arm, joints: &Joints) -> bool {
    if arm.is_scara() {
        return joints[1].abs() > 0.1 && (180.0 - joints[1].abs()) > 0.1;
    }
    let links = arm.links(joints);
    let centre = links[4].translation.vector;
    let offset = arm.default_dh().d[2];
    let shoulder = (centre.x.powi(2) + centre.y.powi(2) - offset.powi(2)).max(0.0).sqrt();
    shoulder > 1.0 && joints[2].abs() > 0.1 && joints[4].abs() > 0.1
}

#[test]
fn every_solution_reproduces_the_pose_on_its_branch_within_limits() {
    for arm in Arm::names().map(arm) {
        for joints in positions(&arm, POSITIONS) {
            let flange = arm.flange(&joints);
            for branch in arm.branches() {
                let Ok(found) = arm.inverse_isometry_on(*branch, &flange, &joints) else { continue };
                let (mm, rotation) = difference(&arm.flange(&found), &flange);
                assert!(mm < 1e-9 && rotation < 1e-12, "{} {joints:?}: {mm:e} {rotation:e}", arm.name());
                assert!(arm.is_in_range(&found), "{} {found:?}", arm.name());
                assert!(!is_regular(&arm, &joints) || arm.configuration(&found) == *branch, "{}", arm.name());
            }
        }
    }
}

#[test]
fn the_joints_of_a_pose_are_found_again() {
    for arm in Arm::names().map(arm) {
        for joints in positions(&arm, POSITIONS).filter(|joints| is_regular(&arm, joints)) {
            let found = arm.inverse_on(arm.configuration(&joints), &arm.forward(&joints), &joints).unwrap();
            assert!(apart(&found, &joints) < 1e-7, "{} {joints:?} {found:?}", arm.name());
            let same = arm.solve(&arm.forward(&joints), &joints, RequestedConfiguration::SAME).unwrap();
            assert_eq!(same, found);
            let free = arm.solve(&arm.forward(&joints), &joints, RequestedConfiguration::FREE).unwrap();
            assert!(apart(&free, &joints) < 1e-7, "{} {joints:?} {free:?}", arm.name());
        }
    }
}

/// No other turn of an axis is within the limits and nearer to the start.
#[test]
fn turns_are_the_nearest_to_the_start() {
    for arm in ["TX2-60L", "RX160", "TS60"].map(arm) {
        let starts = positions(&arm, 2 * POSITIONS).skip(POSITIONS);
        for (joints, start) in positions(&arm, POSITIONS).zip(starts) {
            let flange = arm.flange(&joints);
            for found in arm.solutions(&flange, &start) {
                for (index, axis) in arm.limits().iter().enumerate().filter(|(index, _)| !arm.is_stroke(*index)) {
                    for turn in [-720.0, -360.0, 360.0, 720.0] {
                        let other = found[index] + turn;
                        let inside = axis.min <= other && other <= axis.max;
                        let nearer = (other - start[index]).abs() < (found[index] - start[index]).abs() - 1e-9;
                        assert!(!inside || !nearer, "{} {found:?} {start:?}", arm.name());
                    }
                }
            }
        }
    }
}

proptest! {
    #[test]
    fn no_pose_makes_an_inverse_panic_or_leave_its_limits(
        place in proptest::array::uniform3(-3000.0..3000.0_f64),
        angles in proptest::array::uniform3(-400.0..400.0_f64),
        near in proptest::array::uniform6(-1e4..1e4_f64),
    ) {
        let flange = val3_geometry::Trsf::new(place, angles);
        for arm in ["TX2-90", "TX2-60L", "TS2-60"].map(arm) {
            for found in arm.solutions(&flange.isometry(), &near) {
                prop_assert!(arm.is_in_range(&found));
                let (mm, rotation) = difference(&arm.flange(&found), &flange.isometry());
                prop_assert!(mm < 1e-9 && rotation < 1e-12, "{mm:e} {rotation:e}");
            }
        }
    }
}
