//! Boxes in space, and distances to them.

use val3_geometry::{IsometryMatrix3, Vector3};

/// A box whose faces are parallel to the axes of a frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Zone {
    /// Corner with the smallest coordinates, in mm.
    min: Vector3<f64>,
    /// Corner with the largest coordinates, in mm.
    max: Vector3<f64>,
    /// Transformation from world to the frame.
    to_frame: IsometryMatrix3<f64>,
}

/// Point of a path that is nearest to a box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Nearest {
    /// Distance in mm; 0 inside the box.
    pub(crate) distance: f64,
    /// Point, as a share of the path.
    pub(crate) share: f64,
}

impl Zone {
    /// Creates a box between two corners in a frame, whose pose in world is given; lengths in mm.
    #[must_use]
    pub fn new(min: [f64; 3], max: [f64; 3], frame: &IsometryMatrix3<f64>) -> Self {
        Self { min: min.into(), max: max.into(), to_frame: frame.inverse() }
    }

    /// Returns the distance between a point in world and the box, in mm; 0 inside.
    pub(crate) fn distance(&self, place: &Vector3<f64>) -> f64 {
        self.outside(&self.in_frame(place)).norm()
    }

    fn in_frame(&self, place: &Vector3<f64>) -> Vector3<f64> {
        self.to_frame.rotation * place + self.to_frame.translation.vector
    }

    /// Returns the vector from the nearest point of the box to a point in its frame.
    fn outside(&self, place: &Vector3<f64>) -> Vector3<f64> {
        place - place.sup(&self.min).inf(&self.max)
    }

    /// Returns the nearest point on the straight line between two points in world.
    pub(crate) fn nearest(&self, from: &Vector3<f64>, to: &Vector3<f64>) -> Nearest {
        let (from, way) = (self.in_frame(from), self.in_frame(to) - self.in_frame(from));
        let shares = self.crossings(&from, &way);
        let pieces = shares.windows(2).filter_map(|pair| match pair {
            [start, end] => Some([*start, *end]),
            _ => None,
        });
        let nearest = pieces.map(|[start, end]| {
            // Between two plane crossings, the vector from the box changes linearly.
            let [first, last] = [start, end].map(|share| self.outside(&(from + way * share)));
            let on_piece = share_nearest_to_origin(&first, &(last - first));
            let distance = (first + (last - first) * on_piece).norm();
            Nearest { distance, share: start + (end - start) * on_piece }
        });
        let first = Nearest { distance: self.outside(&from).norm(), share: 0.0 };
        nearest.fold(first, |best, next| if next.distance < best.distance { next } else { best })
    }

    /// Returns the shares at which a path begins, ends, or crosses the plane of a face, in order.
    fn crossings(&self, from: &Vector3<f64>, way: &Vector3<f64>) -> Vec<f64> {
        let planes = [self.min, self.max];
        let crossings = planes.iter().flat_map(|plane| <[f64; 3]>::from((plane - from).component_div(way)));
        let mut shares: Vec<f64> =
            [0.0, 1.0].into_iter().chain(crossings.filter(|share| (0.0..1.0).contains(share))).collect();
        shares.sort_by(f64::total_cmp);
        shares
    }
}

/// Returns the share of a path at which it is nearest to the origin; 0 for a path of length 0.
fn share_nearest_to_origin(from: &Vector3<f64>, way: &Vector3<f64>) -> f64 {
    (-from.dot(way) / way.norm_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use val3_geometry::Trsf;

    use super::*;

    fn zone() -> Zone {
        Zone::new([0.0, 0.0, 0.0], [10.0, 20.0, 30.0], &IsometryMatrix3::identity())
    }

    fn nearest(from: [f64; 3], to: [f64; 3]) -> (f64, f64) {
        let Nearest { distance, share } = zone().nearest(&from.into(), &to.into());
        (distance, share)
    }

    #[test]
    fn distances_of_places() {
        let distance = |place: [f64; 3]| zone().distance(&place.into());
        assert_eq!([distance([5.0, 5.0, 5.0]), distance([10.0, 20.0, 30.0]), distance([0.0; 3])], [0.0; 3]);
        assert_eq!([distance([-3.0, 5.0, 34.0]), distance([13.0, 24.0, 30.0])], [5.0, 5.0]);
    }

    #[test]
    fn the_nearest_place_may_be_between_the_ends() {
        assert_eq!(nearest([-10.0, 5.0, 5.0], [30.0, 5.0, 5.0]), (0.0, 0.25));
        assert_eq!(nearest([0.0, -10.0, 35.0], [0.0, 30.0, 35.0]), (5.0, 0.25));
        assert_eq!(nearest([-10.0, 0.0, 5.0], [0.0, -10.0, 5.0]), (50.0_f64.sqrt(), 0.5));
        assert_eq!(nearest([20.0, 5.0, 5.0], [30.0, 5.0, 5.0]), (10.0, 0.0));
        assert_eq!(nearest([30.0, 5.0, 5.0], [20.0, 5.0, 5.0]), (10.0, 1.0));
        assert_eq!(nearest([5.0, 5.0, 5.0], [50.0, 5.0, 5.0]), (0.0, 0.0));
        assert_eq!(nearest([-3.0, 5.0, 34.0], [-3.0, 5.0, 34.0]), (5.0, 0.0));
    }

    #[test]
    fn a_box_in_a_frame() {
        let frame = Trsf::new([100.0, 0.0, 0.0], [0.0, 0.0, 90.0]).isometry();
        let zone = Zone::new([0.0; 3], [10.0, 20.0, 30.0], &frame);
        // The y axis of the frame is opposite to the x axis of world.
        assert!((zone.distance(&Vector3::new(77.0, 5.0, 5.0)) - 3.0).abs() < 1e-12);
        assert_eq!(zone.distance(&Vector3::new(90.0, 5.0, 5.0)), 0.0);
    }

    proptest! {
        #[test]
        fn no_place_of_a_way_is_nearer(
            from in [-40.0..60.0_f64, -40.0..60.0_f64, -40.0..60.0_f64],
            to in [-40.0..60.0_f64, -40.0..60.0_f64, -40.0..60.0_f64],
        ) {
            let (from, to) = (Vector3::from(from), Vector3::from(to));
            let Nearest { distance, share } = zone().nearest(&from, &to);
            let at = |share: f64| zone().distance(&(from + (to - from) * share));
            prop_assert!((0.0..=1.0).contains(&share) && (at(share) - distance).abs() < 1e-9);
            for step in 0..=200 {
                prop_assert!(at(f64::from(step) / 200.0) >= distance - 1e-9);
            }
        }
    }
}
