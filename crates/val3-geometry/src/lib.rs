//! Geometry of VAL 3 that needs no arm (manual 3.2, 9.3 to 9.6): lengths in mm, angles in degrees.
//!
//! The same input yields the same bits on every machine: functions that IEEE 754 does not define exactly are called
//! from the `libm` crate and never from the platform. For the same reason only products, sums and roots of nalgebra are
//! used, not its functions for angles.

mod align;
mod angles;
mod arc;
pub mod chain;
mod circle;
pub mod degrees;
mod frame;
mod interpolate;
pub mod rotation;
mod sine;
#[cfg(test)]
mod testing;
mod tool_centre;
mod trsf;

pub use nalgebra::{IsometryMatrix3, Rotation3, Vector3};

pub use self::align::align;
pub use self::arc::{Arc, ArcError};
pub use self::frame::{FrameError, set_frame};
pub use self::interpolate::{InterpolationError, LinePath, interpolate_c, interpolate_l};
pub use self::tool_centre::{ToolCentre, ToolCentreError, tool_centre};
pub use self::trsf::Trsf;
