//! Controller time.

/// Time in nanoseconds since the controller's start.
pub type Time = u64;

/// Nanoseconds in a second.
pub const SECOND: Time = 1_000_000_000;

/// Converts seconds to nanoseconds; negative values to 0.
#[must_use]
pub fn nanoseconds(seconds: f64) -> Time {
    // The cast saturates at both bounds and converts NaN to 0.
    (seconds * SECOND as f64).round() as Time
}
