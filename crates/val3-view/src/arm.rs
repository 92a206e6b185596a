//! Arm description, from which pages compute link poses.

use base64::prelude::{BASE64_STANDARD, Engine as _};
use val3_geometry::IsometryMatrix3;
use val3_kinematics::{Arm, Joints, LinkCapsule};
use val3_machine::shapes::LinkShape;

use crate::coordinates;
use crate::wire::{self, ArmChain, Link};

/// Returns the description of an arm for pages: the name, the note about times, the axes with their limits, the pose of
/// each axis frame relative to the previous frame, the pose of the flange relative to the last frame, and the shapes of
/// the links. An axis rotates about the z axis of its frame, or moves along it. After this movement, the frames are
/// those of [`Arm::parts`], to which the capsules are relative.
pub(crate) fn description(arm: &Arm, is_default: bool, shapes: &[Option<LinkShape>]) -> ArmChain {
    let poses = arm.links(&Joints::default());
    let mut before = IsometryMatrix3::identity();
    let mut offsets: Vec<[f64; 6]> = poses
        .iter()
        .map(|pose| {
            let offset = before.inverse() * pose;
            before = *pose;
            coordinates(&offset)
        })
        .collect();
    let flange = offsets.pop();
    let axes = arm.limits().iter().enumerate().map(|(index, axis)| wire::Axis {
        is_linear: arm.is_stroke(index),
        min: axis.min,
        max: axis.max,
        speed: arm.nominal_speed(index),
    });
    ArmChain {
        name: arm.name().to_owned(),
        is_default,
        times_note: arm.times_note(),
        axes: axes.collect(),
        links: offsets.into_iter().map(|offset| Link { offset, axis: [0, 0, 1] }).collect(),
        flange,
        height: arm.height(),
        capsules: arm.shapes().iter().map(|part| part.iter().map(capsule).collect()).collect(),
        shapes: shapes.iter().map(|shape| shape.as_ref().map(described)).collect(),
    }
}

fn capsule(LinkCapsule { from, to, radius }: &LinkCapsule) -> wire::Capsule {
    wire::Capsule { from: (*from).into(), to: (*to).into(), radius: *radius }
}

fn described(LinkShape { format, bytes, unit, pose }: &LinkShape) -> wire::LinkShape {
    let (format, data) = (format.extension().to_owned(), BASE64_STANDARD.encode(bytes));
    wire::LinkShape { format, data, unit: *unit, pose: coordinates(pose) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::expect_file;
    use proptest::prelude::*;
    use serde_json::json;
    use val3_geometry::{Rotation3, Trsf, Vector3};

    /// Joint positions in sample postures, as fractions from 0 to 1 in the range for each axis.
    const SHARES: [[f64; 6]; 2] = [[0.3, 0.7, 0.6, 0.2, 0.65, 0.9], [0.85, 0.35, 0.25, 0.7, 0.2, 0.1]];

    /// Rounds a coordinate to 0.000001 mm.
    fn rounded(value: f64) -> f64 {
        (value * 1e6).round() / 1e6 + 0.0
    }

    /// Returns both ends for each arm capsule in `world`, by link.
    fn capsule_ends(arm: &Arm, joints: &Joints) -> Vec<Vec<[[f64; 3]; 2]>> {
        let placed = |frame: &IsometryMatrix3<f64>, point: &Vector3<f64>| {
            let point = frame.rotation * point + frame.translation.vector;
            [point.x, point.y, point.z].map(rounded)
        };
        let parts = arm.parts(joints);
        let of_part = |(frame, capsules): (&IsometryMatrix3<f64>, &Vec<LinkCapsule>)| {
            capsules.iter().map(|LinkCapsule { from, to, .. }| [placed(frame, from), placed(frame, to)]).collect()
        };
        parts.iter().zip(arm.shapes()).map(of_part).collect()
    }

    /// The page's test `armShape` draws these arms and expects the capsules at these positions.
    #[test]
    fn the_page_tests_contain_the_capsules_in_world() {
        let arms = ["TX2-60L", "TS2-60"].map(|name| {
            let arm = Arm::by_name(name).unwrap();
            let of_shares = |shares: &[f64; 6]| -> Joints {
                let within =
                    |(share, axis): (&f64, &val3_kinematics::AxisLimits)| axis.min + share * (axis.max - axis.min);
                let mut joints = Joints::default();
                joints
                    .iter_mut()
                    .zip(shares.iter().zip(arm.limits()).map(within))
                    .for_each(|(joint, value)| *joint = value);
                joints
            };
            let postures = std::iter::once(Joints::default()).chain(SHARES.iter().map(of_shares));
            let postures = postures.map(|joints| {
                json!({ "joints": joints.get(..arm.axes()).unwrap(), "ends": capsule_ends(&arm, &joints) }).to_string()
            });
            let chain = json!(description(&arm, false, &[]));
            format!("{{ \"arm\": {chain}, \"postures\": [\n{}\n] }}", postures.collect::<Vec<_>>().join(",\n"))
        });
        expect_file!["../../../editors/view/test/scene/armCapsules.json"]
            .assert_eq(&format!("[{}]\n", arms.join(",\n")));
    }

    /// Computes the flange pose in the same way as a page.
    fn flange(description: &ArmChain, joints: &Joints) -> IsometryMatrix3<f64> {
        let pose = |&[x, y, z, rx, ry, rz]: &wire::Pose| Trsf::new([x, y, z], [rx, ry, rz]).isometry();
        let mut found = IsometryMatrix3::identity();
        for ((link, axis), joint) in description.links.iter().zip(&description.axes).zip(joints) {
            let (way, turn) = if axis.is_linear { (*joint, 0.0) } else { (0.0, *joint) };
            found *= pose(&link.offset) * Trsf::new([0.0, 0.0, way], [0.0, 0.0, turn]).isometry();
        }
        found * pose(&description.flange.unwrap())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(50))]

        #[test]
        fn the_chain_leads_to_the_flange(joints in prop::array::uniform6(-170.0..170.0_f64)) {
            for arm in Arm::names().map(|name| Arm::by_name(name).unwrap()) {
                let difference = flange(&description(&arm, false, &[]), &joints).inverse() * arm.flange(&joints);
                let distance = difference.translation.vector.norm();
                let turn = (difference.rotation.matrix() - Rotation3::identity().matrix()).norm();
                prop_assert!(distance < 1e-9 && turn < 1e-12, "{}: {} mm, {}", arm.name(), distance, turn);
            }
        }
    }
}
