//! Rough shapes of arms: files, and whether they fit the links.

use val3_geometry::{IsometryMatrix3, Vector3};
use val3_kinematics::{Arm, Joints, LinkCapsule};

use crate::arm;

/// A file with the shapes of a SCARA arm.
const FILE: &str = r#"
name = "mine"
kind = "scara"
[geometry]
l1 = 300
l2 = 200
z0 = 0
[axes]
min = [-180, -150, 0, -400]
max = [180, 150, 200, 400]
maximum_speed = [400, 400, 1000, 900]
[shapes]
base = [{ from = [0, 0, -100], to = [0, 0, 0], radius = 90 }]
link1 = [{ from = [0, 0, 0], to = [300, 0, 0], radius = 60 }, { from = [0, 0, 0], to = [0, 0, 90], radius = 80 }]
link2 = [{ from = [0, 0, 0], to = [200, 0, 0], radius = 50 }]
link3 = [{ from = [0, 0, 0], to = [0, 0, 200], radius = 12.5 }]
link4 = [{ from = [0, 0, 0], to = [0, 0, 0], radius = 20 }]
"#;

#[test]
fn a_part_may_have_several_capsules() {
    let arm = Arm::from_toml(FILE).unwrap();
    assert_eq!(arm.shapes().iter().map(Vec::len).collect::<Vec<_>>(), [1, 2, 1, 1, 1]);
    let quill = LinkCapsule { from: Vector3::zeros(), to: Vector3::new(0.0, 0.0, 200.0), radius: 12.5 };
    assert_eq!(arm.shapes()[3], [quill]);
    let (without, _) = FILE.split_once("[shapes]").unwrap();
    assert!(Arm::from_toml(without).unwrap().shapes().is_empty());
}

#[test]
fn nonsense_is_an_error_with_its_line() {
    let changes = [
        ("link4 = [{ from = [0, 0, 0], to = [0, 0, 0], radius = 20 }]", ""),
        ("link4 =", "link5 ="),
        ("link4 = [{ from = [0, 0, 0], to = [0, 0, 0], radius = 20 }]", "link4 = []"),
        ("radius = 12.5", "radius = 0"),
        ("to = [0, 0, 200]", "to = [0, 0, inf]"),
        ("to = [0, 0, 200]", "to = [0, 200]"),
        (", radius = 12.5", ""),
        ("radius = 12.5", "diameter = 25"),
    ];
    let messages = changes.map(|(from, to)| {
        let error = Arm::from_toml(&FILE.replacen(from, to, 1)).unwrap_err();
        format!("{to:?}\n    {error}\n")
    });
    insta::assert_snapshot!(messages.concat());
}

/// Returns the ends of the axes of all capsules in world, with the number of the part.
fn ends(arm: &Arm, joints: &Joints) -> Vec<(usize, Vector3<f64>)> {
    let place = |(part, capsules): (usize, &Vec<LinkCapsule>)| {
        let frame: IsometryMatrix3<f64> = arm.parts(joints)[part];
        let placed = |point: &Vector3<f64>| (part, frame.rotation * point + frame.translation.vector);
        capsules.iter().flat_map(|capsule| [placed(&capsule.from), placed(&capsule.to)]).collect::<Vec<_>>()
    };
    arm.shapes().iter().enumerate().flat_map(place).collect()
}

/// The upper arm of a six-axis arm is beside the line from axis 2 to axis 3, where a drawing of the chain would show
/// it.
#[test]
fn upper_arms_are_beside_the_chain() {
    let families =
        [("TX60", 110.0..240.0), ("TX2-60L", 110.0..240.0), ("TX2-90", 150.0..320.0), ("RX160", 170.0..360.0)];
    for (name, range) in families {
        let upper: Vec<f64> = ends(&arm(name), &Joints::default())
            .into_iter()
            .filter_map(|(part, point)| (part == 2).then_some(point.y))
            .collect();
        assert!(!upper.is_empty() && upper.iter().all(|y| range.contains(y)), "{name}: {upper:?}");
    }
}

/// Parts that follow each other touch, and the last one is at the flange.
#[test]
fn shipped_shapes_are_connected() {
    for name in Arm::names() {
        let arm = arm(name);
        assert_eq!(arm.shapes().len(), arm.axes() + 1, "{name}");
        let joints: Joints =
            std::array::from_fn(|axis| arm.limits().get(axis).map_or(0.0, |axis| (axis.min + axis.max) / 2.0));
        let parts = arm.parts(&joints);
        let of = |part: usize| {
            let frame = parts[part];
            let capsule = arm.shapes()[part][0];
            let placed = [capsule.from, capsule.to].map(|point| frame.rotation * point + frame.translation.vector);
            (placed, capsule.radius)
        };
        for part in 1..=arm.axes() {
            let ((before, wide), (after, narrow)) = (of(part - 1), of(part));
            // The axes as ten points each are near enough for parts that overlap by centimetres.
            let points =
                |[from, to]: [Vector3<f64>; 2]| (0..=10).map(move |step| from.lerp(&to, f64::from(step) / 10.0));
            let apart =
                points(before).flat_map(|a| points(after).map(move |b| (a - b).norm())).fold(f64::MAX, f64::min);
            assert!(apart < wide + narrow, "{name}: link {part} is {apart} mm from the part before");
        }
        let flange = arm.flange(&joints).translation.vector;
        let (last, radius) = of(arm.axes());
        assert!(
            (last[1] - flange).norm() < radius + 20.0,
            "{name}: the last part is {} from the flange",
            last[1] - flange
        );
    }
}
