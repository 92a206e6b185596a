//! Moves of a program between positions that are known from the data files.

use val3_analysis::body::ExprId;
use val3_geometry::IsometryMatrix3;
use val3_kinematics::Joints;
use val3_motion::{Cause, MovePath};

/// Moves of a program between known positions, as far as they are known.
#[derive(Default)]
pub(crate) struct PlannedMoves {
    /// Moves that the project's arm cannot make.
    pub(crate) impossible: Vec<ImpossibleMove>,
    /// Moves with a known target that the arm can make, by call, in the order of the program.
    pub(crate) moves: Vec<(ExprId, PlannedMove)>,
}

/// A move with a known target that the arm can make.
pub(crate) struct PlannedMove {
    /// Possible joint positions at the end, at least one.
    pub(super) ends: Vec<Joints>,
    /// Possible ways to these ends; empty if the start is unknown.
    pub(super) ways: Vec<PossibleWay>,
    /// Tool on the flange.
    pub(super) tool: IsometryMatrix3<f64>,
    /// The previous move, if its target is known.
    pub(super) last: Option<ExprId>,
    /// Reach distance of the preceding blend in mm, 0 without a blend; `None` if it is uncertain.
    pub(super) reach: Option<f64>,
}

/// A possible way of the arm in a move.
pub(super) struct PossibleWay {
    pub(super) start: Joints,
    pub(super) path: MovePath,
    pub(super) end: Joints,
}

/// A move that the arm cannot make from any possible start.
pub(crate) struct ImpossibleMove {
    /// Target of the move.
    pub(crate) target: ExprId,
    /// Target of the previous move; `None` if the target itself is the reason.
    pub(crate) from: Option<ExprId>,
    pub(crate) shape: UnreachablePath,
    pub(crate) cause: Cause,
}

/// Path that the arm cannot follow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum UnreachablePath {
    Line,
    Circle,
    /// The blend around the target `from`, in the move to `target`.
    Blend,
}
