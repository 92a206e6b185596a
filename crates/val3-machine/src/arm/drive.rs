//! Conditions under which the arm moves, and reasons why it rests.

use val3_motion::{MillimetresPerSecond, Percent};

/// Conditions under which the arm moves in a cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drive {
    /// Whether the arm has power and is not held.
    pub may_move: bool,
    /// Whether an operator holds the key that moves the arm, as in every working mode except remote.
    pub is_attended: bool,
    /// The monitor speed.
    pub speed: Percent,
    /// Maximum speed of the tool centre point and of the flange; `None` without a limit.
    pub tool_speed: Option<MillimetresPerSecond>,
}

/// Reason why an arm with recorded moves does not move.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ArmHold {
    /// The arm has no power.
    NoPower,
    /// The working mode or the operator holds the arm.
    Held,
    /// The monitor speed is 0.
    NoSpeed,
    /// `stopMove`.
    Stopped,
    /// A client has stopped its moves.
    StoppedByClient,
    /// The arm is away from its path.
    Away,
    /// In step mode the arm waits for a release.
    Step,
    /// The force in a compliant move does not move the arm.
    NoForce,
    /// The arm rests before a path that it cannot follow.
    Fault,
}

impl ArmHold {
    /// Sentences for the operator: the reason, and the action that moves the arm.
    #[must_use]
    pub const fn operator_text(self) -> &'static str {
        match self {
            Self::NoPower => "The arm has no power. Switch the power on.",
            Self::Held => "The arm is held. Press Move, or choose the remote mode.",
            Self::NoSpeed => "The monitor speed is 0 %. Increase it.",
            Self::Stopped => "The program has stopped the motion with stopMove, and has not restarted it.",
            Self::StoppedByClient => "A client of the controller has stopped its moves, and has not restarted them.",
            Self::Away => "The arm is away from its path. Press Move to connect it.",
            Self::Step => "The motion is stepped. Step it, or choose the continuous mode.",
            Self::NoForce => "The force of the compliant move does not move the arm.",
            Self::Fault => "The arm rests before a path that it cannot follow.",
        }
    }

    /// The reason in a few words, for lists of tasks.
    #[must_use]
    pub const fn cause(self) -> &'static str {
        match self {
            Self::NoPower => "no power",
            Self::Held => "held",
            Self::NoSpeed => "monitor speed 0 %",
            Self::Stopped => "stopped by stopMove",
            Self::StoppedByClient => "stopped by a client",
            Self::Away => "away from its path",
            Self::Step => "step mode",
            Self::NoForce => "no force",
            Self::Fault => "a path that it cannot follow",
        }
    }

    /// Remainder of a sentence about the arm.
    #[must_use]
    pub const fn text(self) -> &'static str {
        match self {
            Self::NoPower => "which has no power: call enablePower(), or switch it on in a script (power = true)",
            Self::Held => {
                "which is held: programs move it in remote mode, or while the operator lets them (move = true in a script)"
            }
            Self::NoSpeed => "which stands still because the monitor speed is 0",
            Self::Stopped => "which stopMove holds: call restartMove() or resetMotion()",
            Self::StoppedByClient => "which a client of the controller has stopped: restart or reset its moves",
            Self::Away => {
                "which is away from its path: call autoConnectMove(true), or connect it in a script (connect = true)"
            }
            Self::Step => "which waits in step mode: step the motion, or choose the continuous mode",
            Self::NoForce => "which the force of its compliant move does not move",
            Self::Fault => "which rests before a path that it cannot follow",
        }
    }
}
