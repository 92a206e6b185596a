//! Waits on the real clock.

use std::thread::sleep;
use std::time::{Duration, Instant};

use val3_session::Delay;

/// Waits. `started` is the time at which the controller's clock was 0. Without it, only durations are waited for.
pub(crate) fn wait(delay: Delay, started: Option<Instant>) {
    match (delay, started) {
        (Delay::Until(time), Some(started)) => {
            sleep((started + Duration::from_nanos(time)).saturating_duration_since(Instant::now()));
        }
        (Delay::For(duration), _) => sleep(duration),
        (Delay::None | Delay::Until(_), _) => {}
    }
}
