//! Descriptions of moves.

use super::{ArmConfig, Matrix};
use crate::structure::{enumeration, structure};

structure! {
    /// Description of a move.
    MotionDescription {
        /// Tool relative to the flange.
        tool: Matrix = "tool",
        /// Frame of the destination, relative to `world`.
        frame: Matrix = "frame",
        /// Whether the destination is relative to the end of the previous move.
        kind: MoveType = "absRel",
        /// Configuration at the destination.
        config: ArmConfig = "config",
        /// Blending with the next move.
        blend: BlendType = "blendType",
        /// Distance before the destination at which blending begins, in m.
        leave: f64 = "distBlendPrev",
        /// Distance after the destination at which blending ends, in m.
        reach: f64 = "distBlendNext",
        /// Speed; 1 is the nominal speed.
        speed: f64 = "vel",
        /// Acceleration; 1 is the nominal acceleration.
        acceleration: f64 = "acc",
        /// Deceleration; 1 is the nominal deceleration.
        deceleration: f64 = "dec",
        /// Maximum speed of the tool, in m/s; 99999 is no limit.
        translation_speed: f64 = "transVel",
        /// Maximum rotation speed of the tool, in rad/s; 99999 is no limit.
        rotation_speed: f64 = "rotVel",
        /// Frequency of an unknown quantity, greater than 0.
        frequency: f64 = "freq",
    }
}

enumeration! {
    /// Reference of a destination.
    MoveType {
        /// The frame.
        Absolute = "ABSOLUTE-MOVE",
        /// The end of the previous move.
        Relative = "RELATIVE-MOVE",
    }
}

enumeration! {
    /// Blending of a move with the next move.
    BlendType {
        /// The arm stops.
        Off = "BLEND-OFF",
        /// In joint space.
        Joint = "BLEND-JOINT",
        /// In Cartesian space.
        Cartesian = "BLEND-CART",
    }
}
