//! Robot motion: moves in, one sample every 4 ms out (chapter 10 of the manual). The types of a move are defined in
//! `val3-moves` and re-exported here.
//!
//! `Move -> Segment -> Span -> Sample` are separate types. The path is pure geometry and depends only on the moves.
//! Speeds are planned along the path afterwards, and an executor follows the plan.
//!
//! ```
//! use std::sync::Arc;
//! use val3_geometry::IsometryMatrix3;
//! use val3_kinematics::Arm;
//! use val3_motion::{Blend, DegreesPerSecond, Manner, MillimetresPerSecond, Seconds, SpeedLimits};
//! use val3_motion::{Motion, Move, MovePath};
//!
//! let arm = Arm::by_name("TX2-90").unwrap();
//! let axes = [0, 1, 2, 3, 4, 5];
//! let limits = SpeedLimits {
//!     speed: axes.map(|axis| arm.nominal_speed(axis)),
//!     acceleration: axes.map(|axis| arm.nominal_acceleration(axis)),
//!     deceleration: axes.map(|axis| arm.nominal_deceleration(axis)),
//!     translation: MillimetresPerSecond(250.0),
//!     rotation: DegreesPerSecond(100.0),
//! };
//! let mut motion = Motion::new(Arc::new(arm), [0.0, 0.0, 90.0, 0.0, 90.0, 0.0]);
//! let path = MovePath::Joint([30.0, 0.0, 90.0, 0.0, 90.0, 0.0]);
//! let tool = IsometryMatrix3::identity();
//! motion.record(&Move { path, tool, limits, blend: Blend::Off, id: 0.0, manner: Manner::Rigid }).unwrap();
//! while !motion.is_empty() {
//!     let sample = motion.advance(Seconds(0.004));
//!     assert!(sample.speed <= MillimetresPerSecond(250.0));
//! }
//! assert_eq!(motion.joints()[0], 30.0);
//! ```

mod alteration;
mod biarc;
mod blend;
mod blend_fault;
mod bounds;
mod branches;
mod compliant;
mod deferred;
mod departure;
mod derivatives;
mod emergency;
mod executor;
mod fault;
mod gates;
mod hull;
mod model;
mod motion;
mod path;
mod plan;
mod queue;
mod quintic;
mod request;
mod segment;
mod span;
mod speed_limit;
mod speed_limits;
mod timeline;

pub use self::alteration::AlterStatus;
pub use self::blend_fault::blend_fault;
pub use self::compliant::ExternalForce;
pub use self::departure::Connection;
pub use self::fault::{Cause, PathFault};
pub use self::motion::{Jog, Motion, MotionMode, PathPiece, PieceAhead, PieceEnd, PieceKind, Sample};
pub use self::queue::{BlendCorner, MoveEvent, MoveEventKind, QueuedMove, Shortening};
pub use self::request::{Move, SpeedLimits};
pub use self::speed_limit::SpeedLimit;
pub use val3_moves::{
    AlterReference, Blend, BlendKind, Degrees, DegreesPerSecond, Manner, Millimetres, MillimetresPerSecond,
    MotionPhase, MovePath, MoveStage, MoveTarget, PathShape, Percent, Seconds,
};
