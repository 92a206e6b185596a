//! Waits on the real clock.

use std::time::{Duration, Instant};

use val3_session::Delay;

/// The time to wait on the real clock. `started` is the time at which the controller's clock was 0. Without it, only
/// durations are waited for.
pub(crate) fn wait_time(delay: Delay, started: Option<Instant>) -> Duration {
    match (delay, started) {
        (Delay::Until(time), Some(started)) => {
            (started + Duration::from_nanos(time)).saturating_duration_since(Instant::now())
        }
        (Delay::For(duration), _) => duration,
        (Delay::None | Delay::Until(_), _) => Duration::ZERO,
    }
}
