//! `val3 arm urdf`: an arm as URDF, for ROS and other simulators. Lengths are in metres and angles in radians there.

use nalgebra::{IsometryMatrix3, Rotation3, Translation3, Vector3};
use val3_kinematics::{Arm, AxisLimits, Joints, LinkCapsule};
use val3_session::ArmFile;

use crate::args::ArmUrdfArgs;
use crate::color::Color;
use crate::output::{OutputContent, to_stdout_as};
use crate::user_error::UserError;

/// Millimetres in a metre.
const MILLIMETRES: f64 = 1000.0;

/// Runs the command.
pub(super) fn run(args: &ArmUrdfArgs, color: Color) -> Result<(), UserError> {
    let arm = ArmFile::named(&args.name)?.arm;
    to_stdout_as(OutputContent::Data, color, |out| write!(out, "{}", document(&arm)))
}

/// Joint between two consecutive links.
struct UrdfJoint<'a> {
    /// Frame of the link in the frame of the link before, while all joints are at 0.
    origin: IsometryMatrix3<f64>,
    /// Limits of the axis; `None` for a fixed joint.
    limits: Option<&'a AxisLimits>,
    is_stroke: bool,
}

/// Returns the joints from the mounting face to the flange: to `base`, whose frame is `world` of VAL 3, to each link,
/// and to the flange.
fn joints(arm: &Arm) -> Vec<UrdfJoint<'_>> {
    let zero = Joints::default();
    let mut frames = arm.parts(&zero);
    frames.push(arm.flange(&zero));
    let fixed = |origin| UrdfJoint { origin, limits: None, is_stroke: false };
    let height = Translation3::new(0.0, 0.0, arm.height());
    let mut joints = vec![fixed(IsometryMatrix3::from_parts(height, Rotation3::identity()))];
    for (axis, frames) in frames.windows(2).enumerate() {
        if let [before, frame] = frames {
            let origin = before.inv_mul(frame);
            joints.push(UrdfJoint { origin, limits: arm.limits().get(axis), is_stroke: arm.is_stroke(axis) });
        }
    }
    joints
}

/// Returns the document.
fn document(arm: &Arm) -> String {
    let mut text = format!("<?xml version=\"1.0\"?>\n<robot name=\"{}\">\n", arm.name().to_lowercase());
    text += "  <!-- base_link is the mounting face; the frame of base is world of VAL 3. Masses are unknown, and an effort of 0 is. -->\n";
    text += "  <link name=\"base_link\"/>\n";
    let mut before = "base_link".to_owned();
    let last = arm.axes() + 1;
    for (number, joint) in joints(arm).iter().enumerate() {
        let name = match number {
            0 => "base".to_owned(),
            number if number == last => "flange".to_owned(),
            number => format!("link{number}"),
        };
        let shapes = arm.shapes().get(number).filter(|_| number < last);
        text += &link(&name, shapes.map_or(&[][..], Vec::as_slice));
        text += &joint.text(number, &before, &name);
        before = name;
    }
    text + "</robot>\n"
}

/// Returns a link with its shapes, for drawing and for collisions.
fn link(name: &str, capsules: &[LinkCapsule]) -> String {
    let shapes: String = capsules.iter().flat_map(shapes).collect();
    if shapes.is_empty() {
        return format!("  <link name=\"{name}\"/>\n");
    }
    format!("  <link name=\"{name}\">\n{shapes}  </link>\n")
}

/// Returns a capsule as a cylinder with two spheres, because URDF has no capsules.
fn shapes(LinkCapsule { from, to, radius }: &LinkCapsule) -> Vec<String> {
    let radius = radius / MILLIMETRES;
    let (line, middle) = (to - from, (from + to) / 2.0);
    let sphere = |at: &Vector3<f64>| {
        let place = IsometryMatrix3::from_parts(Translation3::from(*at), Rotation3::identity());
        shape(&place, &format!("<sphere radius=\"{radius:.6}\"/>"))
    };
    let length = line.norm();
    if length <= f64::EPSILON {
        return vec![sphere(from)];
    }
    // A line against z can be turned around any axis.
    let turn = Rotation3::rotation_between(&Vector3::z(), &line);
    let turn = turn.unwrap_or_else(|| Rotation3::from_axis_angle(&Vector3::x_axis(), std::f64::consts::PI));
    let cylinder = format!("<cylinder radius=\"{radius:.6}\" length=\"{:.6}\"/>", length / MILLIMETRES);
    let place = IsometryMatrix3::from_parts(Translation3::from(middle), turn);
    vec![shape(&place, &cylinder), sphere(from), sphere(to)]
}

fn shape(place: &IsometryMatrix3<f64>, geometry: &str) -> String {
    let inside = format!("{}<geometry>{geometry}</geometry>", origin(place));
    format!("    <visual>{inside}</visual>\n    <collision>{inside}</collision>\n")
}

impl UrdfJoint<'_> {
    fn text(&self, number: usize, parent: &str, child: &str) -> String {
        let ends = format!("<parent link=\"{parent}\"/><child link=\"{child}\"/>");
        let place = origin(&self.origin);
        let Some(limits) = self.limits else {
            return format!("  <joint name=\"{parent}-{child}\" type=\"fixed\">{place}{ends}</joint>\n");
        };
        let (kind, unit) =
            if self.is_stroke { ("prismatic", MILLIMETRES.recip()) } else { ("revolute", 1f64.to_radians()) };
        let (lower, upper, velocity) = (limits.min * unit, limits.max * unit, limits.maximum_speed * unit);
        let effort = limits.maximum_effort.unwrap_or_default();
        format!(
            "  <joint name=\"joint{number}\" type=\"{kind}\">{place}{ends}<axis xyz=\"0 0 1\"/>\
             <limit lower=\"{lower:.6}\" upper=\"{upper:.6}\" velocity=\"{velocity:.6}\" effort=\"{effort}\"/></joint>\n"
        )
    }
}

/// Returns a position in metres, with angles around the fixed axes x, y, z in radians.
fn origin(place: &IsometryMatrix3<f64>) -> String {
    let [x, y, z] = [place.translation.x, place.translation.y, place.translation.z].map(|length| length / MILLIMETRES);
    let (roll, pitch, yaw) = place.rotation.euler_angles();
    let [x, y, z, roll, pitch, yaw] = [x, y, z, roll, pitch, yaw].map(rounded);
    format!("<origin xyz=\"{x} {y} {z}\" rpy=\"{roll} {pitch} {yaw}\"/>")
}

/// Rounds to nine digits after the point, so that every machine writes the same text.
fn rounded(value: f64) -> f64 {
    // The sum turns -0 into 0.
    (value * 1e9).round() / 1e9 + 0.0
}

#[cfg(test)]
mod tests {
    use expect_test::expect;
    use val3_kinematics::Arm;

    use super::*;

    /// Pose of the flange in `world`, computed from the joints of the document alone.
    fn flange(arm: &Arm, positions: &Joints) -> IsometryMatrix3<f64> {
        let mut pose = IsometryMatrix3::identity();
        for (axis, joint) in joints(arm).iter().skip(1).enumerate() {
            pose *= joint.origin;
            let moved = if joint.limits.is_some() { positions[axis] } else { 0.0 };
            let (stroke, angle) = if joint.is_stroke { (moved, 0.0) } else { (0.0, moved.to_radians()) };
            let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), angle);
            pose *= IsometryMatrix3::from_parts(Translation3::new(0.0, 0.0, stroke), turn);
        }
        pose
    }

    #[test]
    fn the_flange_is_that_of_the_arm() {
        for name in Arm::names() {
            let arm = Arm::by_name(name).unwrap();
            for step in 0..20 {
                let mut positions = Joints::default();
                for (axis, position) in positions.iter_mut().enumerate().take(arm.axes()) {
                    *position = f64::from((step * 37 + i32::try_from(axis).unwrap() * 53) % 200 - 100);
                }
                let (own, expected) = (flange(&arm, &positions), arm.flange(&positions));
                assert!((own.to_homogeneous() - expected.to_homogeneous()).abs().max() < 1e-9, "{name} {positions:?}");
            }
        }
    }

    #[test]
    fn the_document_has_links_joints_and_shapes() {
        let text = document(&Arm::by_name("ts2-60").unwrap());
        let joints: Vec<&str> = text.lines().filter(|line| line.contains("<joint")).map(str::trim).collect();
        expect![[r#"
            <joint name="base_link-base" type="fixed"><origin xyz="0 0 0" rpy="0 0 0"/><parent link="base_link"/><child link="base"/></joint>
            <joint name="joint1" type="revolute"><origin xyz="0 0 0" rpy="0 0 0"/><parent link="base"/><child link="link1"/><axis xyz="0 0 1"/><limit lower="-3.141593" upper="3.141593" velocity="9.162979" effort="0"/></joint>
            <joint name="joint2" type="revolute"><origin xyz="0.38 0 0" rpy="0 0 0"/><parent link="link1"/><child link="link2"/><axis xyz="0 0 1"/><limit lower="-2.469641" upper="2.469641" velocity="9.162979" effort="0"/></joint>
            <joint name="joint3" type="prismatic"><origin xyz="0.24 0 0" rpy="0 0 0"/><parent link="link2"/><child link="link3"/><axis xyz="0 0 1"/><limit lower="0.000000" upper="0.200000" velocity="2.000000" effort="0"/></joint>
            <joint name="joint4" type="revolute"><origin xyz="0 0 0" rpy="3.141592654 0 0"/><parent link="link3"/><child link="link4"/><axis xyz="0 0 1"/><limit lower="-8.726646" upper="8.726646" velocity="41.887902" effort="0"/></joint>
            <joint name="link4-flange" type="fixed"><origin xyz="0 0 0" rpy="0 0 0"/><parent link="link4"/><child link="flange"/></joint>"#]].assert_eq(&joints.join("\n"));
        assert_eq!(text.matches("<visual>").count(), text.matches("<collision>").count());
        assert!(text.contains("<sphere") && text.contains("<cylinder"), "{text}");
    }
}
