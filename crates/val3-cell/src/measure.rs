//! Distance measurement between two bodies.

use val3_collision::{Closest, Nearness, Overlap, PlacedShape, Shape, nearest};
use val3_geometry::{IsometryMatrix3, Vector3};

/// Measured distance between two bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measured {
    /// Distance in mm; 0 or less if the bodies touch: the negative depth of the overlap, 0 for surfaces.
    pub distance: f64,
    /// Nearest points on both bodies in `world`; the same point twice if they touch.
    pub points: [Vector3<f64>; 2],
}

impl Measured {
    /// Converts the distance between cores to the distance between the bodies. `touch` is the sum of the depths in mm
    /// by which both cores are smaller.
    pub(crate) fn without(self, touch: f64) -> Self {
        Self { distance: self.distance - touch, ..self }
    }
}

/// Result of a measurement with a distance limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Reading {
    /// Lower bound of a distance that exceeds the limit, in mm.
    Beyond(f64),
    /// The measured distance.
    Measured(Measured),
}

impl Reading {
    /// Returns the distance or its lower bound, in mm.
    pub(crate) fn at_least(&self) -> f64 {
        match self {
            Self::Beyond(bound) => *bound,
            Self::Measured(measured) => measured.distance,
        }
    }
}

/// Shapes of a body with their poses in the body's frame, and the pose of this frame.
pub(crate) struct Placed<'b> {
    pub(crate) shapes: &'b [(Shape, IsometryMatrix3<f64>)],
    pub(crate) pose: IsometryMatrix3<f64>,
}

/// Measures the distance between two bodies; [`Reading::Beyond`] if it exceeds the limit.
pub(crate) fn measure(a: &Placed<'_>, b: &Placed<'_>, limit: f64) -> Reading {
    let mut reading = Reading::Beyond(f64::INFINITY);
    for (first, in_first) in a.shapes {
        let first_pose = a.pose * in_first;
        let bounds = first.bounds(&first_pose);
        for (second, in_second) in b.shapes {
            let second_pose = b.pose * in_second;
            let bound = bounds.distance(&second.bounds(&second_pose));
            let limit = limit.min(reading.at_least());
            let next = if bound > limit {
                Reading::Beyond(bound)
            } else {
                between(
                    PlacedShape { shape: first, pose: &first_pose },
                    PlacedShape { shape: second, pose: &second_pose },
                    limit,
                )
            };
            if next.at_least() < reading.at_least() {
                reading = next;
            }
        }
    }
    reading
}

/// Measures the distance between two shapes.
fn between(a: PlacedShape<'_>, b: PlacedShape<'_>, limit: f64) -> Reading {
    // Overlaps are measured even if the limit is negative: the deepest overlap is the result.
    match nearest(a, b, limit.max(0.0)) {
        Nearness::Beyond => Reading::Beyond(limit),
        Nearness::Apart(Closest { distance, points }) => Reading::Measured(Measured { distance, points }),
        Nearness::Overlap(Overlap { depth, at }) => {
            Reading::Measured(Measured { distance: -depth.unwrap_or(0.0), points: [at, at] })
        }
    }
}
