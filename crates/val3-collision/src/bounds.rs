//! Bounding boxes with sides parallel to the axes of the common frame.

use parry3d_f64::bounding_volume::Aabb;
use val3_geometry::Vector3;

use crate::convert;

/// Bounding box of a shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Corner with the smallest coordinates.
    pub min: Vector3<f64>,
    /// Corner with the largest coordinates.
    pub max: Vector3<f64>,
}

impl Bounds {
    pub(crate) fn of(bounds: &Aabb) -> Self {
        Self { min: convert::back(bounds.mins), max: convert::back(bounds.maxs) }
    }

    /// Returns the distance to another box; 0 if they overlap. It is a lower bound of the distance between the enclosed
    /// shapes.
    #[must_use]
    pub fn distance(&self, other: &Self) -> f64 {
        let gap = (other.min - self.max).sup(&(self.min - other.max));
        gap.map(|length| length.max(0.0)).norm()
    }

    /// Returns the centre of the overlap, or of the gap between the boxes.
    #[must_use]
    pub fn between(&self, other: &Self) -> Vector3<f64> {
        (self.min.sup(&other.min) + self.max.inf(&other.max)) / 2.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bounds(min: [f64; 3], max: [f64; 3]) -> Bounds {
        Bounds { min: min.into(), max: max.into() }
    }

    #[test]
    fn boxes_are_apart_by_their_corners() {
        let unit = bounds([0.0; 3], [1.0; 3]);
        assert_eq!(unit.distance(&bounds([4.0, 5.0, 0.0], [5.0, 6.0, 1.0])), 5.0);
        assert_eq!(bounds([4.0, 5.0, 0.0], [5.0, 6.0, 1.0]).distance(&unit), 5.0);
        assert_eq!(unit.distance(&bounds([0.5; 3], [2.0; 3])), 0.0);
    }

    #[test]
    fn a_point_between_boxes_is_in_the_part_that_they_share() {
        let point = bounds([0.0; 3], [2.0; 3]).between(&bounds([1.0; 3], [5.0; 3]));
        assert_eq!(point, Vector3::new(1.5, 1.5, 1.5));
    }
}
