//! Arm description, from which pages compute link poses.

use base64::prelude::{BASE64_STANDARD, Engine as _};
use val3_geometry::IsometryMatrix3;
use val3_kinematics::{Arm, Joints};
use val3_machine::shapes::LinkShape;

use crate::coordinates;
use crate::wire::{self, ArmChain, Link};

/// Returns the name, whether it is the default, the note about times, the axes with their limits, all axis frames'
/// poses, each relative to the previous frame, the pose of the flange relative to the last frame, and the shapes of the
/// links. An axis rotates about the z axis of its frame, or moves along it.
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
        shapes: shapes.iter().map(|shape| shape.as_ref().map(described)).collect(),
    }
}

fn described(LinkShape { format, bytes }: &LinkShape) -> wire::LinkShape {
    wire::LinkShape { format: format.extension().to_owned(), data: BASE64_STANDARD.encode(bytes) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use val3_geometry::{Rotation3, Trsf};

    /// Computes the flange as a page does.
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
