//! Comparison with rs-opw-kinematics, which computes in metres and radians.

use nalgebra::{Quaternion, UnitQuaternion};
use rs_opw_kinematics::kinematic_traits::{Kinematics, Pose};
use rs_opw_kinematics::kinematics_impl::OPWKinematics;
use rs_opw_kinematics::parameters::opw_kinematics::Parameters;
use val3_kinematics::{Arm, Joints};

use crate::{arm, positions};

/// Number of positions per arm.
const POSITIONS: usize = 10_000;

fn peer(arm: &Arm) -> OPWKinematics {
    let dh = arm.default_dh();
    OPWKinematics::new(Parameters {
        a1: dh.a[0] / 1000.0,
        a2: 0.0,
        b: dh.d[2] / 1000.0,
        c1: 0.0,
        c2: dh.a[1] / 1000.0,
        c3: dh.d[3] / 1000.0,
        c4: dh.d[5] / 1000.0,
        offsets: [0.0; 6],
        sign_corrections: [1; 6],
        dof: 6,
    })
}

fn six_axis_arms() -> impl Iterator<Item = Arm> {
    Arm::names().map(arm).filter(|arm| !arm.is_scara())
}

/// Returns the largest difference between two positions of the same axis, without whole turns.
fn apart(left: &Joints, right: &Joints) -> f64 {
    let one = |(left, right): (&f64, &f64)| ((left - right) - ((left - right) / 360.0).round() * 360.0).abs();
    left.iter().zip(right).map(one).fold(0.0, f64::max)
}

/// Whether the position is not near a singular one, where the two libraries may choose differently.
fn is_regular(arm: &Arm, joints: &Joints) -> bool {
    let links = arm.links(joints);
    let centre = links[4].translation.vector;
    let offset = arm.default_dh().d[2];
    let shoulder = centre.x.powi(2) + centre.y.powi(2) - offset.powi(2);
    shoulder > 25.0 && joints[2].abs() > 1.0 && joints[4].abs() > 1.0
}

fn assert_same_pose(arm: &Arm, joints: &Joints, pose: &Pose) {
    let flange = arm.flange(joints);
    let place = [pose.translation.x, pose.translation.y, pose.translation.z].map(|metres| metres * 1000.0);
    let mm = flange.translation.vector.iter().zip(place).map(|(left, right)| (left - right).abs());
    assert!(mm.fold(0.0, f64::max) < 1e-9, "{} {joints:?}", arm.name());
    let rotation = Quaternion::new(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z);
    let rotation = UnitQuaternion::new_normalize(rotation).to_rotation_matrix();
    assert!((rotation.matrix() - flange.rotation.matrix()).amax() < 1e-12, "{} {joints:?}", arm.name());
}

#[test]
fn poses_joints_and_configurations_are_those_of_the_peer() {
    for arm in six_axis_arms() {
        let peer = peer(&arm);
        for joints in positions(&arm, POSITIONS) {
            let pose = peer.forward(&joints.map(f64::to_radians));
            assert_same_pose(&arm, &joints, &pose);
            if is_regular(&arm, &joints) {
                assert_same_solutions(&arm, &joints, &peer.inverse(&pose));
            }
        }
    }
}

/// Checks that each regular solution of one library within the limits is also a solution from the other library.
fn assert_same_solutions(arm: &Arm, joints: &Joints, theirs: &[Joints]) {
    let flange = arm.flange(joints);
    let theirs: Vec<_> = theirs.iter().map(|joints| joints.map(f64::to_degrees)).collect();
    let ours: Vec<_> = arm.solutions(&flange, joints).collect();
    for our in ours.iter().filter(|our| is_regular(arm, our)) {
        let found = theirs.iter().any(|their| apart(their, our) < 1e-5);
        assert!(found, "{} {joints:?}: {our:?} is none of {theirs:?}", arm.name());
    }
    for their in theirs.iter().filter(|their| is_regular(arm, their)) {
        let on_branch = arm.inverse_isometry_on(arm.configuration(their), &flange, their);
        let Ok(our) = on_branch else { continue };
        assert!(apart(&our, their) < 1e-5, "{} {joints:?}: {our:?} {their:?}", arm.name());
        assert!(ours.iter().any(|our| apart(our, their) < 1e-5), "{} {joints:?}: {their:?}", arm.name());
    }
    assert!(ours.iter().any(|our| apart(our, joints) < 1e-5), "{} {joints:?}", arm.name());
}
