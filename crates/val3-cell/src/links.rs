//! Meshes of links, which replace the capsules of the arm's description.

use camino::Utf8Path;
use val3_collision::{Nearness, PlacedShape, Shape, nearest};
use val3_geometry::{IsometryMatrix3, Trsf};
use val3_kinematics::{Arm, LinkCapsule};

use crate::error::CellError;
use crate::file::MeshUnit;
use crate::mesh::Mesh;
use crate::names::body_names;
use crate::solids::{UnitDoubt, unit_doubt};

/// Largest plausible distance in mm between a link's mesh and the link's capsules. A mesh that is farther away has a
/// wrong `origin`.
const ASTRAY: f64 = 100.0;

/// Advice for a mesh that cannot be used.
const HELP: &str = "name a mesh of the link, or remove the setting: the capsules of the arm are then compared";

/// File with the mesh of the base or a link, as the settings describe it.
#[derive(Debug, Clone, Copy)]
pub struct LinkFile<'f> {
    /// Path for messages and for the default unit: mm for an STL file, m for a GLB file.
    pub path: &'f Utf8Path,
    /// Length of the file's unit in mm; `None` for the default.
    pub unit: Option<f64>,
    /// Origin of coordinates whose axes are parallel to `world` while all joints are 0, in mm from the mounting face;
    /// `None` for coordinates in the frame of the link.
    pub origin_at_zero: Option<[f64; 3]>,
}

/// Coordinates in the file of a link's mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinkCoordinates {
    /// Length of the file's unit, in mm.
    pub unit: f64,
    /// Pose of the file's frame in the frame of the link.
    pub pose: IsometryMatrix3<f64>,
}

impl LinkFile<'_> {
    /// Returns the coordinates for a link of the arm, or for the base if `link` is 0.
    #[must_use]
    pub fn coordinates(&self, arm: &Arm, link: usize) -> LinkCoordinates {
        let unit = self.unit.unwrap_or_else(|| MeshUnit::of(self.path).length());
        let pose = self.origin_at_zero.map_or_else(IsometryMatrix3::identity, |[x, y, z]| {
            let at_zero = arm.parts(&Default::default()).get(link).copied().unwrap_or_default();
            at_zero.inv_mul(&Trsf::new([x, y, z - arm.height()], [0.0; 3]).isometry())
        });
        LinkCoordinates { unit, pose }
    }

    /// Returns the hull of the file's mesh for a link of the arm, or for the base if `link` is 0.
    ///
    /// # Errors
    /// The points have no volume, their size suggests another unit, or the mesh is far from its link.
    pub fn hull(&self, mesh: Mesh, arm: &Arm, link: usize) -> Result<LinkHull, LinkError> {
        let path = self.path;
        let LinkCoordinates { unit, pose } = self.coordinates(arm, link);
        let mesh = mesh.scaled(unit);
        if let Some(doubt) = unit_doubt(unit, mesh.extent()) {
            let message = format!("`{path}` is {:.2} mm long", mesh.extent());
            let table = |unit: &str| format!("write `{{ file = \"{path}\", unit = \"{unit}\" }}`");
            let help = match doubt {
                UnitDoubt::Metres => format!("is it in metres? {}", table("m")),
                UnitDoubt::Millimetres => format!("is it in mm? {}", table("mm")),
                UnitDoubt::Neither => "it would be larger than any arm: export it in mm".to_owned(),
            };
            return Err(LinkError { message, help });
        }
        let hull = Shape::hull(&mesh.placed(&pose).points).map_err(|error| format!("`{path}` is no shape: {error}"))?;
        match arm.shapes().get(link).and_then(|capsules| distance(&hull, capsules)) {
            Some(distance) if distance > ASTRAY && self.origin_at_zero.is_some() => Err(LinkError {
                message: format!("`{path}` is {distance:.0} mm from its link while all joints are 0"),
                help: "set `origin` to the origin of its coordinates, in mm from the mounting face".to_owned(),
            }),
            _ => Ok(LinkHull(hull)),
        }
    }
}

/// Returns the distance in mm between a hull and the nearest capsule; `None` without capsules.
fn distance(hull: &Shape, capsules: &[LinkCapsule]) -> Option<f64> {
    let here = IsometryMatrix3::identity();
    let shapes = capsules.iter().filter_map(|capsule| Shape::capsule(capsule.from, capsule.to, capsule.radius).ok());
    let distances = shapes.map(|capsule| {
        match nearest(PlacedShape { shape: hull, pose: &here }, PlacedShape { shape: &capsule, pose: &here }, f64::MAX)
        {
            Nearness::Beyond => f64::INFINITY,
            Nearness::Apart(closest) => closest.distance,
            Nearness::Overlap(_) => 0.0,
        }
    });
    distances.reduce(f64::min)
}

/// Convex hull of a link's mesh, in mm in the frame of the link.
#[derive(Debug, Clone)]
pub struct LinkHull(pub(crate) Shape);

/// Reason why a file cannot be used as the mesh of a link.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LinkError {
    /// One sentence that describes the error.
    pub message: String,
    /// Suggested correction.
    pub help: String,
}

impl From<String> for LinkError {
    fn from(message: String) -> Self {
        Self { message, help: HELP.to_owned() }
    }
}

/// Returns the names of the base and the links for this number of axes.
pub fn link_names(axes: usize) -> impl Iterator<Item = String> {
    body_names(std::iter::empty(), axes)
}

/// Checks that an arm with this number of axes has all links that `[run] shapes` names.
///
/// # Errors
/// A name has no link; the error contains the first such name.
pub fn check_link_names<'n>(mut names: impl Iterator<Item = &'n String>, axes: usize) -> Result<(), CellError> {
    let unknown = names.find(|name| link_names(axes).all(|link| link != **name));
    unknown.map_or(Ok(()), |name| {
        let help = format!("its parts are `base` and `link1` to `link{axes}`");
        Err(CellError::new(format!("run.shapes.{name}"), format!("the arm has no `{name}`"), help))
    })
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use expect_test::expect;
    use val3_kinematics::Joints;

    use super::*;
    use crate::contacts::Contacts;
    use crate::profile::Profile;
    use crate::scene::Scene;
    use crate::testing::{arm, build, sight};

    /// A cube around the origin with this side.
    fn cube(side: f64) -> Mesh {
        let corner =
            |number: u32| [number & 1, number >> 1 & 1, number >> 2].map(|high| (f64::from(high) - 0.5) * side).into();
        Mesh {
            points: (0..8).map(corner).collect(),
            triangles: (0..6).map(|first| [first, first + 1, first + 2]).collect(),
        }
    }

    fn file(path: &str) -> LinkFile<'_> {
        LinkFile { path: Utf8Path::new(path), unit: None, origin_at_zero: None }
    }

    fn hull(file: LinkFile<'_>, side: f64) -> Result<LinkHull, String> {
        let hull = file.hull(cube(side), &arm("tx2-60l"), 4);
        hull.map_err(|LinkError { message, help }| format!("{message}: {help}"))
    }

    #[test]
    fn a_hull_replaces_the_capsule_of_its_link() {
        let arm = arm("tx2-60l");
        let post = "[[object]]\nname = \"post\"\nbox = [100, 100, 2000]\nat = [500, 0, 0]\n";
        let names = |links: Vec<Option<LinkHull>>| {
            let cell = build(post, &arm).unwrap().with_links(links);
            let scene = Scene::new(Arc::new(cell), Arc::clone(&arm));
            assert!(scene.has_link_shapes());
            let contacts = Contacts::new(Arc::new(scene), Vec::new()).at(&[0.0, 90.0, 0.0, 0.0, 0.0, 0.0]);
            contacts.into_iter().map(|contact| contact.names[0].clone()).collect::<Vec<_>>()
        };
        assert!(names(Vec::new()).contains(&"link4".to_owned()));
        let small =
            |links: usize| (0..=links).map(|link| (link == 4).then(|| hull(file("a.stl"), 10.0).unwrap())).collect();
        assert!(!names(small(6)).contains(&"link4".to_owned()));
    }

    #[test]
    fn the_length_of_a_mesh_suggests_its_unit() {
        let metres = |path| LinkFile { unit: Some(1000.0), ..file(path) };
        assert!(hull(file("a.stl"), 100.0).is_ok() && hull(file("a.GLB"), 0.1).is_ok());
        assert!(hull(metres("a.stl"), 0.1).is_ok());
        let refused = [
            hull(file("a.stl"), 0.1),
            hull(file("a.glb"), 100.0),
            hull(metres("a.stl"), 100.0),
            hull(file("a.stl"), 1e5),
        ];
        expect![[r#"
            `a.stl` is 0.17 mm long: is it in metres? write `{ file = "a.stl", unit = "m" }`
            `a.glb` is 173205.08 mm long: is it in mm? write `{ file = "a.glb", unit = "mm" }`
            `a.stl` is 173205.08 mm long: is it in mm? write `{ file = "a.stl", unit = "mm" }`
            `a.stl` is 173205.08 mm long: it would be larger than any arm: export it in mm
        "#]]
        .assert_eq(&refused.map(|refused| refused.unwrap_err() + "\n").concat());
    }

    #[test]
    fn a_mesh_far_from_its_link_has_another_origin() {
        let at = |z| LinkFile { origin_at_zero: Some([0.0, 0.0, z]), ..file("a.stl") };
        assert!(hull(at(1000.0), 50.0).is_ok());
        let refused = hull(at(0.0), 50.0).unwrap_err() + "\n";
        expect![[r#"
            `a.stl` is 833 mm from its link while all joints are 0: set `origin` to the origin of its coordinates, in mm from the mounting face
        "#]].assert_eq(&refused);
    }

    /// Returns the hulls of cubes at all links, from two kinds of files: in the link's frame, and in metres in a frame
    /// that is parallel to `world` while all joints are 0.
    fn hulls_in_both_frames(arm: &Arm) -> [Vec<Option<LinkHull>>; 2] {
        let origin = [120.0, -30.0, 410.0];
        let frame = Trsf::new([origin[0], origin[1], origin[2] - arm.height()], [0.0; 3]).isometry();
        let parts = arm.parts(&Joints::default());
        let own = |link: usize| {
            cube(150.0).placed(&Trsf::new(arm.shapes()[link][0].from.into(), [10.0, 20.0, 30.0]).isometry())
        };
        let at_zero = LinkFile { unit: Some(1000.0), origin_at_zero: Some(origin), ..file("a.stl") };
        let links = 0..parts.len();
        [
            links.clone().map(|link| file("a.stl").hull(own(link), arm, link).ok()).collect(),
            links
                .map(|link| {
                    let mesh = own(link).placed(&frame.inv_mul(&parts[link])).scaled(0.001);
                    at_zero.hull(mesh, arm, link).ok()
                })
                .collect(),
        ]
    }

    #[test]
    fn a_hull_has_equal_distances_in_both_frames() {
        let post = "[[object]]\nname = \"post\"\nsphere = { radius = 30 }\nat = [700, 200, 300]\n";
        for (name, axes) in [("tx2-60l", 6), ("rx160", 6), ("ts2-60", 4)] {
            let arm = arm(name);
            let mut profiles = hulls_in_both_frames(&arm).map(|links| {
                assert!(links.iter().flatten().count() == axes + 1);
                let cell = build(post, &arm).unwrap().with_links(links);
                Profile::new(Arc::new(Scene::new(Arc::new(cell), Arc::clone(&arm))))
            });
            let mut compared = 0;
            for cycle in 0..100 {
                let turned = f64::from(cycle);
                let joints: Joints = [turned, 80.0 - turned, turned / 2.0, turned, 30.0, turned];
                let sight = sight(&arm, joints, turned * 0.004);
                let [first, second] = profiles.each_mut().map(|profile| profile.see(&sight));
                let distances = [first, second].map(|found| found.map(|found| (found.names, found.distance)));
                match distances {
                    [Some((first, one)), Some((second, other))] => {
                        assert!(
                            first == second && (one - other).abs() < 1e-4,
                            "{name}: {first:?} {one}, {second:?} {other}"
                        );
                        compared += 1;
                    }
                    // Beyond the greatest distance of a profile.
                    [first, second] => assert_eq!((first, second), (None, None), "{name}"),
                }
            }
            assert!(compared > 30, "{name}: {compared}");
        }
    }
}
