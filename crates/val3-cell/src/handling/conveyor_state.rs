//! State of a conveyor between two cycles.

/// Tolerance in seconds within which two times are equal.
pub(super) const SAME_TIME: f64 = 1e-9;

/// State of a conveyor.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct ConveyorState {
    /// Whether the conveyor ran at the end of the last cycle; `None` before the first cycle.
    pub(super) runs: Option<bool>,
    /// Whether the conveyor moved a part in the last cycle.
    pub(super) is_moving: bool,
    /// Arrival of the next part.
    pub(super) next: NextPart,
    /// Number of parts that have arrived.
    pub(super) fed: usize,
}

/// Arrival of the next part on a conveyor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum NextPart {
    /// After this running time in seconds; the conveyor is stopped.
    In(f64),
    /// At this time in seconds, if the conveyor keeps running.
    At(f64),
    /// As soon as the arrival pose is free.
    Blocked,
    /// All parts have arrived.
    Never,
}

impl Default for NextPart {
    fn default() -> Self {
        Self::In(0.0)
    }
}

impl NextPart {
    /// Returns the arrival after the conveyor has started or stopped at `time`.
    pub(super) fn switched(self, runs: bool, time: f64) -> Self {
        match (self, runs) {
            (Self::In(seconds), true) => Self::At(time + seconds),
            (Self::At(due), false) => Self::In((due - time).max(0.0)),
            _ => self,
        }
    }

    pub(super) fn is_due(self, time: f64) -> bool {
        match self {
            Self::In(_) | Self::Never => false,
            Self::At(due) => due <= time + SAME_TIME,
            Self::Blocked => true,
        }
    }
}

impl ConveyorState {
    /// Whether the conveyor changes nothing until its signals change: it moves no part, and no arrival is due.
    pub(super) fn is_idle(&self, runs: Option<bool>, time: f64) -> bool {
        self.runs == Some(runs.unwrap_or_default()) && !self.is_moving && !self.is_due(time)
    }

    /// Whether a part arrives at this time in seconds. A blocked arrival is not due: it waits for a moved part.
    pub(super) fn is_due(&self, time: f64) -> bool {
        matches!(self.next, NextPart::At(_)) && self.next.is_due(time)
    }

    /// Returns the time in seconds of the next change without an external cause; 0 while parts move.
    pub(super) fn next_due(&self) -> Option<f64> {
        match self.next {
            _ if self.is_moving => Some(0.0),
            NextPart::At(due) => Some(due),
            NextPart::In(_) | NextPart::Blocked | NextPart::Never => None,
        }
    }
}
