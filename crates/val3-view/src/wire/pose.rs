//! Poses.

/// x, y, z in mm, rx, ry, rz in degrees.
pub type Pose = [f64; 6];
