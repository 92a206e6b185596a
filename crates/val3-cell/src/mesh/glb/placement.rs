//! Placement of nodes: a linear map and a translation.

use val3_geometry::Vector3;

use super::document::GltfNode;

/// A linear map, stored as the images of the axes, and a translation.
#[derive(Clone, Copy)]
pub(super) struct Placement {
    axes: [Vector3<f64>; 3],
    shift: Vector3<f64>,
}

impl Placement {
    pub(super) fn identity() -> Self {
        Self { axes: [Vector3::x(), Vector3::y(), Vector3::z()], shift: Vector3::zeros() }
    }

    /// Returns the placement of a node relative to its parent.
    pub(super) fn of(node: &GltfNode) -> Self {
        if let Some([a, b, c, _, d, e, f, _, g, h, i, _, x, y, z, _]) = node.matrix {
            return Self { axes: [[a, b, c].into(), [d, e, f].into(), [g, h, i].into()], shift: [x, y, z].into() };
        }
        let [x, y, z] = turn(node.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]));
        let [along_x, along_y, along_z] = node.scale.unwrap_or([1.0; 3]);
        let shift = node.translation.unwrap_or_default().into();
        Self { axes: [x * along_x, y * along_y, z * along_z], shift }
    }

    /// Returns the placement that first applies `inner`, then this placement.
    pub(super) fn then(&self, inner: &Self) -> Self {
        Self { axes: inner.axes.map(|axis| self.direction(&axis)), shift: self.point(&inner.shift) }
    }

    fn direction(&self, direction: &Vector3<f64>) -> Vector3<f64> {
        let [x, y, z] = self.axes;
        x * direction.x + y * direction.y + z * direction.z
    }

    pub(super) fn point(&self, point: &Vector3<f64>) -> Vector3<f64> {
        self.direction(point) + self.shift
    }
}

/// Images of the axes under the rotation by a unit quaternion.
fn turn([x, y, z, w]: [f64; 4]) -> [Vector3<f64>; 3] {
    [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + z * w), 2.0 * (x * z - y * w)].into(),
        [2.0 * (x * y - z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + x * w)].into(),
        [2.0 * (x * z + y * w), 2.0 * (y * z - x * w), 1.0 - 2.0 * (x * x + y * y)].into(),
    ]
}
