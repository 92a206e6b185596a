//! Types of a move, from the instruction that requests the move to the views that show it.
//!
//! Instructions build a [`MovePath`] with a [`Manner`], the planner follows it, and the controller, the debugger and
//! the pages show its [`PathShape`], [`BlendKind`], [`MoveStage`] and [`MotionPhase`]. The crate does not compute any
//! motion.
//!
//! Poses are in `world` and tools in `flange`, with lengths in mm. Joint positions are in degrees (linear axes: mm).

mod blend;
mod manner;
mod path;
mod stage;
mod units;

pub use self::blend::{Blend, BlendKind};
pub use self::manner::{AlterReference, Manner};
pub use self::path::{MovePath, MoveTarget, PathShape};
pub use self::stage::{MotionPhase, MoveStage};
pub use self::units::{Degrees, DegreesPerSecond, Millimetres, MillimetresPerSecond, Percent, Seconds};
