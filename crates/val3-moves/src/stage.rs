//! Stages of recorded moves, and motion phases.

/// Execution stage of a recorded move, in chronological order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum MoveStage {
    /// The move is recorded, and the arm executes earlier moves.
    Recorded,
    /// The arm follows the nominal path, or waits at its end.
    Started,
    /// The arm has left the nominal path and follows the blend around the destination.
    Blending,
}

impl MoveStage {
    /// Name in the move queue of the debugger and the pages.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Recorded => "waiting",
            Self::Started => "nominal",
            Self::Blending => "blend",
        }
    }
}

/// Motion phase in a cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MotionPhase {
    /// The arm follows the nominal path of a move.
    Nominal,
    /// The arm follows a blend.
    Blend,
    /// The arm deviates from an alterable path.
    Alter,
    /// The arm returns to the position at which it left its path.
    Connection,
    /// A force moves the arm along its path.
    Compliant,
    /// The arm brakes on its path.
    Stopping,
    /// The arm rests because no further path is determined or because it is stopped.
    Waiting,
}

impl MotionPhase {
    /// All phases.
    pub const ALL: [Self; 7] =
        [Self::Nominal, Self::Blend, Self::Alter, Self::Connection, Self::Compliant, Self::Stopping, Self::Waiting];

    /// Name in traces.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Nominal => "nominal",
            Self::Blend => "blend",
            Self::Alter => "alter",
            Self::Connection => "connection",
            Self::Compliant => "compliant",
            Self::Stopping => "stopping",
            Self::Waiting => "waiting",
        }
    }
}
