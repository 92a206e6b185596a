//! `val3 arm urdf`: an arm as URDF, for ROS and other simulators. URDF has lengths in metres and angles in radians.

mod shape;

use std::io;

use codespan_reporting::term::termcolor::WriteColor;
use nalgebra::{IsometryMatrix3, Rotation3, Translation3};
use quick_xml::events::{BytesStart, BytesText, Event};
use val3_kinematics::{Arm, AxisLimits, Joints, LinkCapsule};
use val3_session::ArmFile;

use self::shape::{UrdfShape, shapes};
use crate::args::ArmUrdfArgs;
use crate::color::Color;
use crate::format::xml::{self, XmlWriter};
use crate::output::{OutputContent, to_stdout_as};
use crate::user_error::UserError;

/// Millimetres in a metre.
const MILLIMETRES: f64 = 1000.0;

/// Runs the command.
pub(super) fn run(args: &ArmUrdfArgs, color: Color) -> Result<(), UserError> {
    let arm = ArmFile::named(&args.name)?.arm;
    to_stdout_as(OutputContent::Data, color, |out| document(&arm, out))
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

/// Writes the document.
fn document(arm: &Arm, out: &mut dyn WriteColor) -> io::Result<()> {
    xml::document(out, |writer| {
        let robot = writer.create_element("robot").with_attribute(("name", arm.name().to_lowercase().as_str()));
        robot.write_inner_content(|writer| robot_parts(arm, writer)).map(drop)
    })
}

/// Writes the links and joints, from the mounting face on.
fn robot_parts(arm: &Arm, writer: &mut XmlWriter<'_>) -> io::Result<()> {
    let note = " base_link is the mounting face; the frame of base is `world` of VAL 3. There are no masses. An effort of 0 \
                is unknown. ";
    writer.write_event(Event::Comment(BytesText::new(note)))?;
    writer.create_element("link").with_attribute(("name", "base_link")).write_empty()?;
    let mut parent = "base_link".to_owned();
    let last = arm.axes() + 1;
    for (number, joint) in joints(arm).iter().enumerate() {
        let name = match number {
            0 => "base".to_owned(),
            number if number == last => "flange".to_owned(),
            number => format!("link{number}"),
        };
        let capsules = arm.shapes().get(number).filter(|_| number < last);
        link(&name, capsules.map_or(&[], Vec::as_slice), writer)?;
        joint.write(number, [&parent, &name], writer)?;
        parent = name;
    }
    Ok(())
}

/// Writes a link with its shapes, for drawing and for collisions.
fn link(name: &str, capsules: &[LinkCapsule], writer: &mut XmlWriter<'_>) -> io::Result<()> {
    let element = writer.create_element("link").with_attribute(("name", name));
    let shapes: Vec<UrdfShape> = capsules.iter().flat_map(shapes).collect();
    if shapes.is_empty() {
        return element.write_empty().map(drop);
    }
    element.write_inner_content(|writer| shapes.iter().try_for_each(|shape| shape.write(writer))).map(drop)
}

impl UrdfJoint<'_> {
    /// Writes the joint between a parent and its child.
    fn write(&self, number: usize, [parent, child]: [&str; 2], writer: &mut XmlWriter<'_>) -> io::Result<()> {
        let (name, kind) = match self.limits {
            None => (format!("{parent}-{child}"), "fixed"),
            Some(_) => (format!("joint{number}"), if self.is_stroke { "prismatic" } else { "revolute" }),
        };
        let joint = writer.create_element("joint").with_attributes([("name", name.as_str()), ("type", kind)]);
        joint
            .write_inner_content(|writer| {
                origin(&self.origin, writer)?;
                writer.create_element("parent").with_attribute(("link", parent)).write_empty()?;
                writer.create_element("child").with_attribute(("link", child)).write_empty()?;
                self.limits.map_or(Ok(()), |limits| self.limits(limits, writer))
            })
            .map(drop)
    }

    fn limits(&self, limits: &AxisLimits, writer: &mut XmlWriter<'_>) -> io::Result<()> {
        writer.create_element("axis").with_attribute(("xyz", "0 0 1")).write_empty()?;
        let unit = if self.is_stroke { MILLIMETRES.recip() } else { 1f64.to_radians() };
        let [lower, upper, velocity] =
            [limits.min, limits.max, limits.maximum_speed].map(|limit| format!("{:.6}", limit * unit));
        let effort = limits.maximum_effort.unwrap_or_default();
        let element = format!("limit lower=\"{lower}\" upper=\"{upper}\" velocity=\"{velocity}\" effort=\"{effort}\"");
        let name_length = element.find(' ').unwrap_or(element.len());
        writer.write_event(Event::Empty(BytesStart::from_content(element, name_length)))
    }
}

/// Writes a pose in metres, with angles around the fixed axes x, y, z in radians.
fn origin(pose: &IsometryMatrix3<f64>, writer: &mut XmlWriter<'_>) -> io::Result<()> {
    let [x, y, z] = [pose.translation.x, pose.translation.y, pose.translation.z].map(|length| length / MILLIMETRES);
    let (roll, pitch, yaw) = pose.rotation.euler_angles();
    let [position, angles] =
        [[x, y, z], [roll, pitch, yaw]].map(|numbers| numbers.map(rounded).map(|n| n.to_string()).join(" "));
    let attributes = [("xyz", position.as_str()), ("rpy", angles.as_str())];
    writer.create_element("origin").with_attributes(attributes).write_empty().map(drop)
}

/// Rounds to nine digits after the point, so that every machine writes the same text.
fn rounded(value: f64) -> f64 {
    // The sum turns -0 into 0.
    (value * 1e9).round() / 1e9 + 0.0
}

#[cfg(test)]
mod tests {
    use codespan_reporting::term::termcolor::NoColor;
    use expect_test::expect;
    use nalgebra::Vector3;

    use super::*;

    /// Pose of the flange in `world`, computed only from the joints of the document.
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

    fn text(arm: &Arm) -> String {
        let mut out = NoColor::new(Vec::new());
        document(arm, &mut out).unwrap();
        String::from_utf8(out.into_inner()).unwrap()
    }

    #[test]
    fn the_document_has_links_joints_and_shapes() {
        let text = text(&Arm::by_name("ts2-60").unwrap());
        let joints: Vec<&str> =
            text.split_inclusive("</joint>\n").filter_map(|part| part.find("<joint").map(|at| &part[at..])).collect();
        expect![[r#"
            <joint name="base_link-base" type="fixed">
                <origin xyz="0 0 0" rpy="0 0 0"/>
                <parent link="base_link"/>
                <child link="base"/>
              </joint>
            <joint name="joint1" type="revolute">
                <origin xyz="0 0 0" rpy="0 0 0"/>
                <parent link="base"/>
                <child link="link1"/>
                <axis xyz="0 0 1"/>
                <limit lower="-3.141593" upper="3.141593" velocity="9.162979" effort="0"/>
              </joint>
            <joint name="joint2" type="revolute">
                <origin xyz="0.38 0 0" rpy="0 0 0"/>
                <parent link="link1"/>
                <child link="link2"/>
                <axis xyz="0 0 1"/>
                <limit lower="-2.469641" upper="2.469641" velocity="9.162979" effort="0"/>
              </joint>
            <joint name="joint3" type="prismatic">
                <origin xyz="0.24 0 0" rpy="0 0 0"/>
                <parent link="link2"/>
                <child link="link3"/>
                <axis xyz="0 0 1"/>
                <limit lower="0.000000" upper="0.200000" velocity="2.000000" effort="0"/>
              </joint>
            <joint name="joint4" type="revolute">
                <origin xyz="0 0 0" rpy="3.141592654 0 0"/>
                <parent link="link3"/>
                <child link="link4"/>
                <axis xyz="0 0 1"/>
                <limit lower="-8.726646" upper="8.726646" velocity="41.887902" effort="0"/>
              </joint>
            <joint name="link4-flange" type="fixed">
                <origin xyz="0 0 0" rpy="0 0 0"/>
                <parent link="link4"/>
                <child link="flange"/>
              </joint>
        "#]]
        .assert_eq(&joints.concat());
        assert_eq!(text.matches("<visual>").count(), text.matches("<collision>").count());
        assert!(text.contains("<sphere") && text.contains("<cylinder"), "{text}");
    }

    #[test]
    fn names_are_escaped() {
        let file = Arm::file("ts2-60").unwrap().replacen("name = \"", "name = \"A&<", 1);
        let arm = Arm::from_toml(&file).unwrap();
        assert!(text(&arm).contains("<robot name=\"a&amp;&lt;"), "{}", text(&arm));
    }
}
