//! Distances between shapes: boxes, cylinders, spheres, capsules, convex hulls, and surfaces of triangles.
//!
//! Lengths are in mm. Each shape has its own frame, and a pose places this frame in a common frame. The crate has no
//! concept of arms, files or time. Equal input yields bit-identical results on every machine: `parry3d-f64`, which
//! computes all distances except from capsules to capsules and surfaces, is built with its deterministic functions.

mod bounds;
mod capsules;
mod convert;
mod convex;
mod nearest;
mod segments;
mod shape;
mod surfaces;
#[cfg(test)]
mod testing;

pub use self::bounds::Bounds;
pub use self::nearest::{Closest, Nearness, Overlap, PlacedShape, nearest};
pub use self::shape::{Shape, ShapeError, Triangles};
