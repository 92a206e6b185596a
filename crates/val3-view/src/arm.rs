//! Arm description, from which pages compute link poses.

use base64::prelude::{BASE64_STANDARD, Engine as _};
use serde_json::{Value, json};
use val3_geometry::IsometryMatrix3;
use val3_kinematics::{Arm, Joints};
use val3_machine::shapes::LinkShape;

use crate::coordinates;

/// Returns the name, the note about times, the axes with their limits, all axis frames' poses, each relative to the
/// previous frame, the pose of the flange relative to the last frame, and the shapes of the links. An axis rotates
/// about the z axis of its frame, or moves along it.
pub(crate) fn description(arm: &Arm, shapes: &[Option<LinkShape>]) -> Value {
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
    let axis = |(index, axis): (usize, &val3_kinematics::Axis)| {
        json!({
            "isLinear": arm.is_stroke(index),
            "min": axis.min,
            "max": axis.max,
            "speed": arm.nominal_speed(index),
        })
    };
    json!({
        "name": arm.name(),
        "timesNote": arm.times_note(),
        "axes": arm.limits().iter().enumerate().map(axis).collect::<Vec<_>>(),
        "links": offsets.iter().map(|offset| json!({ "offset": offset, "axis": [0, 0, 1] })).collect::<Vec<_>>(),
        "flange": flange,
        "shapes": shapes.iter().map(|shape| shape.as_ref().map(described)).collect::<Vec<_>>(),
    })
}

fn described(LinkShape { format, bytes }: &LinkShape) -> Value {
    json!({ "format": format.extension(), "data": BASE64_STANDARD.encode(bytes) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use val3_geometry::{Rotation3, Trsf};

    /// Computes the flange as a page does.
    fn flange(description: &Value, joints: &Joints) -> IsometryMatrix3<f64> {
        let pose = |value: &Value| {
            let numbers: Vec<f64> = value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect();
            Trsf::new(numbers[..3].try_into().unwrap(), numbers[3..].try_into().unwrap()).isometry()
        };
        let mut found = IsometryMatrix3::identity();
        for ((link, axis), joint) in
            description["links"].as_array().unwrap().iter().zip(description["axes"].as_array().unwrap()).zip(joints)
        {
            let (way, turn) = if axis["isLinear"] == true { (*joint, 0.0) } else { (0.0, *joint) };
            found *= pose(&link["offset"]) * Trsf::new([0.0, 0.0, way], [0.0, 0.0, turn]).isometry();
        }
        found * pose(&description["flange"])
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(50))]

        #[test]
        fn the_chain_leads_to_the_flange(joints in prop::array::uniform6(-170.0..170.0_f64)) {
            for arm in Arm::names().map(|name| Arm::by_name(name).unwrap()) {
                let difference = flange(&description(&arm, &[]), &joints).inverse() * arm.flange(&joints);
                let distance = difference.translation.vector.norm();
                let turn = (difference.rotation.matrix() - Rotation3::identity().matrix()).norm();
                prop_assert!(distance < 1e-9 && turn < 1e-12, "{}: {} mm, {}", arm.name(), distance, turn);
            }
        }
    }
}
