//! Shapes of links. URDF has no capsules: a capsule becomes a cylinder with two spheres.

use std::io;

use nalgebra::{IsometryMatrix3, Rotation3, Translation3, Vector3};
use val3_kinematics::LinkCapsule;

use super::{MILLIMETRES, origin};
use crate::format::xml::XmlWriter;

/// A shape of a link, at a pose in the frame of the link.
pub(super) struct UrdfShape {
    pose: IsometryMatrix3<f64>,
    form: UrdfForm,
}

/// Forms with their lengths in metres.
enum UrdfForm {
    Sphere { radius: f64 },
    Cylinder { radius: f64, length: f64 },
}

impl UrdfShape {
    /// Writes the shape twice: for drawing and for collisions.
    pub(super) fn write(&self, writer: &mut XmlWriter<'_>) -> io::Result<()> {
        ["visual", "collision"].into_iter().try_for_each(|use_of_shape| {
            let element = writer.create_element(use_of_shape);
            element
                .write_inner_content(|writer| {
                    origin(&self.pose, writer)?;
                    writer.create_element("geometry").write_inner_content(|writer| self.form.write(writer)).map(drop)
                })
                .map(drop)
        })
    }
}

impl UrdfForm {
    fn write(&self, writer: &mut XmlWriter<'_>) -> io::Result<()> {
        let (name, lengths) = match self {
            Self::Sphere { radius } => ("sphere", vec![("radius", *radius)]),
            Self::Cylinder { radius, length } => ("cylinder", vec![("radius", *radius), ("length", *length)]),
        };
        let lengths: Vec<(&str, String)> =
            lengths.into_iter().map(|(name, length)| (name, format!("{length:.6}"))).collect();
        let attributes = lengths.iter().map(|(name, length)| (*name, length.as_str()));
        writer.create_element(name).with_attributes(attributes).write_empty().map(drop)
    }
}

/// Returns the shapes of a capsule.
pub(super) fn shapes(LinkCapsule { from, to, radius }: &LinkCapsule) -> Vec<UrdfShape> {
    let radius = radius / MILLIMETRES;
    let (line, middle) = (to - from, (from + to) / 2.0);
    let length = line.norm();
    if length <= f64::EPSILON {
        return vec![sphere(from, radius)];
    }
    // A line against z can be turned around any axis.
    let turn = Rotation3::rotation_between(&Vector3::z(), &line);
    let turn = turn.unwrap_or_else(|| Rotation3::from_axis_angle(&Vector3::x_axis(), std::f64::consts::PI));
    let pose = IsometryMatrix3::from_parts(Translation3::from(middle), turn);
    let form = UrdfForm::Cylinder { radius, length: length / MILLIMETRES };
    vec![UrdfShape { pose, form }, sphere(from, radius), sphere(to, radius)]
}

/// Returns a sphere with its centre in mm and its radius in m.
fn sphere(centre: &Vector3<f64>, radius: f64) -> UrdfShape {
    let pose = IsometryMatrix3::from_parts(Translation3::from(*centre), Rotation3::identity());
    UrdfShape { pose, form: UrdfForm::Sphere { radius } }
}
