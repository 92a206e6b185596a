//! Waits in real time.

use std::time::{Duration, Instant};

use val3_lang::ports::Time;
use val3_session::Delay;

/// Relation between the real clock and a controller's clock.
#[derive(Debug, Clone, Copy)]
pub(crate) struct WallClock {
    /// Reference instant on the real clock; `time` is the controller's time at this instant.
    moment: Instant,
    time: Time,
    /// Controller seconds per real second.
    speed: f64,
}

impl WallClock {
    /// Creates the clock of a controller whose time is `now`.
    pub(crate) fn new(now: Time) -> Self {
        Self { moment: Instant::now(), time: now, speed: 1.0 }
    }

    /// Restarts the clock after the controller's clock was stopped, or changes the speed.
    pub(crate) fn restart(&mut self, now: Time, speed: f64) {
        *self = Self { speed, ..Self::new(now) };
    }

    /// Remaining wait in real time.
    pub(crate) fn wait_time(&self, delay: Delay) -> Duration {
        match delay {
            Delay::Until(time) => {
                let ahead = Duration::from_nanos(time.saturating_sub(self.time)).div_f64(self.speed);
                (self.moment + ahead).saturating_duration_since(Instant::now())
            }
            delay => duration(delay),
        }
    }
}

/// Wait for a controller whose clock does not follow the real clock.
pub(crate) const fn duration(delay: Delay) -> Duration {
    match delay {
        Delay::For(duration) => duration,
        Delay::None | Delay::Until(_) => Duration::ZERO,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_speed_divides_the_wait() {
        let mut clock = WallClock::new(0);
        let wait =
            |clock: &WallClock, seconds: u64| clock.wait_time(Delay::Until(seconds * 1_000_000_000)).as_secs_f64();
        assert!((wait(&clock, 100) - 100.0).abs() < 1.0);
        clock.restart(100_000_000_000, 0.1);
        assert!((wait(&clock, 101) - 10.0).abs() < 1.0);
        clock.restart(0, 100.0);
        assert!((wait(&clock, 500) - 5.0).abs() < 1.0);
        assert_eq!(clock.wait_time(Delay::None), Duration::ZERO);
    }
}
