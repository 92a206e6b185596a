//! Transformations, frames and interpolation in space: lengths in mm, angles in degrees.
