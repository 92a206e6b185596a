//! The distance between two bodies.

use val3_collision::{Closest, Nearness, Overlap, PlacedShape, Shape, nearest};
use val3_geometry::{IsometryMatrix3, Vector3};

/// How near two bodies are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measured {
    /// Distance in mm; 0 or less if they touch: the depth of the overlap as a negative number, 0 for surfaces.
    pub distance: f64,
    /// Nearest points on both bodies in `world`; the same point twice if they touch.
    pub points: [Vector3<f64>; 2],
}

impl Measured {
    /// The distance between two bodies from the distance between their cores, whose surfaces are this deep together.
    pub(crate) fn without(self, touch: f64) -> Self {
        Self { distance: self.distance - touch, ..self }
    }
}

/// The result of a measurement with a limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Reading {
    /// The distance is at least this.
    Beyond(f64),
    /// The distance.
    Measured(Measured),
}

impl Reading {
    /// The distance, or a lower bound of it.
    pub(crate) fn at_least(&self) -> f64 {
        match self {
            Self::Beyond(bound) => *bound,
            Self::Measured(measured) => measured.distance,
        }
    }
}

/// Shapes of a body, with their poses in a frame, and the pose of this frame.
pub(crate) struct Placed<'b> {
    pub(crate) shapes: &'b [(Shape, IsometryMatrix3<f64>)],
    pub(crate) pose: IsometryMatrix3<f64>,
}

/// Measures the distance between two bodies, if it is below a limit.
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

fn between(a: PlacedShape<'_>, b: PlacedShape<'_>, limit: f64) -> Reading {
    // An overlap has no limit: its depth decides which shapes are named.
    match nearest(a, b, limit.max(0.0)) {
        Nearness::Beyond => Reading::Beyond(limit),
        Nearness::Apart(Closest { distance, points }) => Reading::Measured(Measured { distance, points }),
        Nearness::Overlap(Overlap { depth, at }) => {
            Reading::Measured(Measured { distance: -depth.unwrap_or(0.0), points: [at, at] })
        }
    }
}
