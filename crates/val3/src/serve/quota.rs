//! Rate limit for commands.

use std::time::{Duration, Instant};

/// Limits of a rate.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RateLimits {
    /// Sustained number of commands per second.
    pub(crate) per_second: u16,
    /// Maximum number of commands in a burst.
    pub(crate) at_once: u16,
    /// Number of consecutive rejected commands after which the sender is disconnected.
    pub(crate) refused: u32,
}

/// Token bucket for a sender's commands.
#[derive(Debug)]
pub(crate) struct Quota {
    /// Number of commands that the sender may send immediately.
    left: f64,
    /// Time at which `left` was computed.
    at: Instant,
    /// Number of consecutive rejected commands.
    refused: u32,
    per_second: f64,
    burst: f64,
    patience: u32,
}

/// Decision on a command.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Admission {
    /// The command is passed to the run.
    Granted,
    /// The command is rejected with an error.
    Refused,
    /// The sender continues to send too many commands and is disconnected.
    Expelled,
}

impl Quota {
    /// Creates a full quota.
    pub(crate) fn new(limits: RateLimits, now: Instant) -> Self {
        let (per_second, burst) = (f64::from(limits.per_second), f64::from(limits.at_once));
        Self { left: burst, at: now, refused: 0, per_second, burst, patience: limits.refused }
    }

    /// Decides on a command that arrives now.
    pub(crate) fn admit(&mut self, now: Instant) -> Admission {
        let passed = now.saturating_duration_since(self.at);
        self.left = (self.left + passed.as_secs_f64() * self.per_second).min(self.burst);
        self.at = now;
        if passed > Duration::from_secs(1) {
            self.refused = 0;
        }
        if self.left >= 1.0 {
            self.left -= 1.0;
            return Admission::Granted;
        }
        self.refused += 1;
        if self.refused > self.patience { Admission::Expelled } else { Admission::Refused }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_flood_is_refused_and_then_ended() {
        let limits = RateLimits { per_second: 10, at_once: 20, refused: 5 };
        let start = Instant::now();
        let mut quota = Quota::new(limits, start);
        let mut at = |milliseconds: u64| quota.admit(start + Duration::from_millis(milliseconds));
        assert!((0..20).all(|_| at(0) == Admission::Granted));
        assert_eq!(at(0), Admission::Refused);
        assert_eq!(at(100), Admission::Granted);
        // After a pause of one second the full quota is available again.
        assert!((0..11).all(|_| at(1200) == Admission::Granted));
        assert!((0..5).all(|_| at(1200) == Admission::Refused));
        assert_eq!(at(1200), Admission::Expelled);
    }
}
