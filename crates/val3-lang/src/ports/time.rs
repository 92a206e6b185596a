//! Time of the controller.

/// Nanoseconds since the controller was started.
pub type Time = u64;

/// Nanoseconds of a second.
pub const SECOND: Time = 1_000_000_000;

/// Seconds in nanoseconds; 0 below zero.
#[must_use]
pub fn nanoseconds(seconds: f64) -> Time {
    // The cast ends at both bounds of the range, and makes 0 of what is no number.
    (seconds * SECOND as f64).round() as Time
}
