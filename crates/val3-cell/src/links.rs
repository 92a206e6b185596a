//! Meshes of links, which replace the capsules of the arm's description.

use camino::Utf8Path;
use val3_collision::Shape;

use crate::file::MeshUnit;
use crate::mesh::Mesh;
use crate::names::body_names;
use crate::solids::is_likely_length;

/// Convex hull of a link's mesh, in mm in the frame of the link.
#[derive(Debug, Clone)]
pub struct LinkHull(pub(crate) Shape);

impl LinkHull {
    /// Returns the hull of a mesh from the file at `path`: in mm from an STL file, in metres from a GLB file.
    ///
    /// # Errors
    /// The points have no volume, or their size suggests another unit. The error is a message with the path.
    pub fn new(path: &Utf8Path, mesh: Mesh) -> Result<Self, String> {
        let mesh = mesh.scaled(MeshUnit::of(path).length());
        let extent = mesh.extent();
        if !is_likely_length(extent) {
            return Err(format!("`{path}` is {extent:.2} mm long: STL files are in mm, GLB files in m"));
        }
        Shape::hull(&mesh.points).map(Self).map_err(|error| format!("`{path}` is no shape: {error}"))
    }
}

/// Returns the names of the base and the links of an arm with this number of axes.
pub fn link_names(axes: usize) -> impl Iterator<Item = String> {
    body_names(std::iter::empty(), axes)
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::contacts::Contacts;
    use crate::scene::Scene;
    use crate::testing::{arm, build};

    /// A cube around the origin with this side.
    fn cube(side: f64) -> Mesh {
        let corner =
            |number: u32| [number & 1, number >> 1 & 1, number >> 2].map(|high| (f64::from(high) - 0.5) * side).into();
        Mesh {
            points: (0..8).map(corner).collect(),
            triangles: (0..6).map(|first| [first, first + 1, first + 2]).collect(),
        }
    }

    fn hull(path: &str, side: f64) -> Result<LinkHull, String> {
        LinkHull::new(Utf8Path::new(path), cube(side))
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
        let small = |links: usize| (0..=links).map(|link| (link == 4).then(|| hull("a.stl", 10.0).unwrap())).collect();
        assert!(!names(small(6)).contains(&"link4".to_owned()));
    }

    #[test]
    fn the_format_has_a_unit() {
        assert!(hull("a.stl", 100.0).is_ok() && hull("a.GLB", 0.1).is_ok());
        let refused = hull("a.stl", 0.1).unwrap_err();
        assert_eq!(refused, "`a.stl` is 0.17 mm long: STL files are in mm, GLB files in m");
        assert!(hull("a.glb", 100.0).is_err());
    }
}
