//! Pace of a run in real time, which operators may change during the run.

use std::time::Duration;

use serde_json::{Map, Value};
use val3_lang::ports::Time;
use val3_session::{Delay, Pace};
use val3_view::wire::{Clock, Fastest, Pace as NewPace, PaceSpeed};

use crate::wall_clock::WallClock;

/// Maximum number of cycles in one command.
const MOST_CYCLES: u64 = 250;

/// Pace of a run.
#[derive(Debug)]
pub(super) struct Tempo {
    pub(super) pace: Pace,
    clock: WallClock,
    speed: f64,
    is_paused: bool,
    /// Whether a debugger has stopped the run.
    is_debugger_stop: bool,
    /// Number of cycles to execute while the run is paused.
    cycles: u64,
}

impl Tempo {
    /// Creates the pace of a run that is not paused.
    pub(super) fn new(pace: Pace, now: Time) -> Self {
        Self { pace, clock: WallClock::new(now), speed: 1.0, is_paused: false, is_debugger_stop: false, cycles: 0 }
    }

    /// Whether the run is paused before its next cycle.
    pub(super) const fn is_stopped(&self) -> bool {
        self.is_paused && self.cycles == 0
    }

    /// Counts a finished cycle.
    pub(super) const fn end_cycle(&mut self) {
        self.cycles = self.cycles.saturating_sub(1);
    }

    /// Restarts the real clock after the controller's clock was stopped.
    pub(super) fn restart_clock(&mut self, now: Time) {
        self.clock.restart(now, self.speed);
    }

    /// Remaining wait in real time.
    pub(super) fn wait_time(&self, delay: Delay) -> Duration {
        self.clock.wait_time(delay)
    }

    /// Message `clock` with the pace.
    pub(super) fn message(&self, t: f64) -> Clock {
        let speed = if self.pace.real_time { PaceSpeed::Times(self.speed) } else { PaceSpeed::Fastest(Fastest::Max) };
        Clock { t, speed, is_paused: self.is_paused, is_stopped: self.is_debugger_stop }
    }

    /// Sets whether a debugger has stopped the run.
    pub(super) const fn set_debugger_stop(&mut self, is_stopped: bool) {
        self.is_debugger_stop = is_stopped;
    }

    /// Executes the command `pace`: changes the speed, or pauses the run.
    pub(super) fn change(&mut self, pace: &NewPace, now: Time) {
        match pace.speed {
            None => {}
            Some(PaceSpeed::Fastest(_)) => self.pace.real_time = false,
            Some(PaceSpeed::Times(speed)) => (self.pace.real_time, self.speed) = (true, speed),
        }
        (self.is_paused, self.cycles) = (pace.is_paused.unwrap_or(self.is_paused), 0);
        self.restart_clock(now);
    }

    /// Executes the command `cycle`: several cycles while the run is paused.
    ///
    /// # Errors
    /// The run is not paused, or the number is invalid.
    pub(super) fn step(&mut self, arguments: &Map<String, Value>, now: Time) -> Result<(), String> {
        let cycles = arguments.get("cycles").map_or(Some(1), Value::as_u64);
        let cycles = cycles.filter(|cycles| (1..=MOST_CYCLES).contains(cycles));
        let cycles = cycles.ok_or_else(|| format!("`cycles` is a number from 1 to {MOST_CYCLES}"))?;
        if !self.is_paused {
            return Err("the run is not paused".to_owned());
        }
        self.cycles = cycles;
        self.restart_clock(now);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;
    use val3_view::wire::Arguments as _;

    use super::*;

    fn change(tempo: &mut Tempo, arguments: Value) -> Result<(), String> {
        let pace = NewPace::read(arguments.as_object().unwrap()).map_err(|error| error.to_string())?;
        tempo.change(&pace, 0);
        Ok(())
    }

    fn clock(tempo: &Tempo, t: f64) -> String {
        json!(val3_view::wire::Message::Clock(tempo.message(t))).to_string()
    }

    #[test]
    fn a_paused_run_makes_single_cycles() {
        let mut tempo = Tempo::new(Pace::default(), 0);
        assert!(tempo.step(&Map::new(), 0).unwrap_err().contains("not paused"));
        change(&mut tempo, json!({ "isPaused": true })).unwrap();
        assert!(tempo.is_stopped());
        tempo.step(json!({ "cycles": 2 }).as_object().unwrap(), 0).unwrap();
        tempo.end_cycle();
        assert!(!tempo.is_stopped());
        tempo.end_cycle();
        assert!(tempo.is_stopped());
        assert!(tempo.step(json!({ "cycles": 1e9 }).as_object().unwrap(), 0).is_err());
        change(&mut tempo, json!({ "isPaused": false })).unwrap();
        assert!(!tempo.is_stopped());
    }

    #[test]
    fn the_speed_is_a_number_or_max() {
        let mut tempo = Tempo::new(Pace { real_time: true, ..Pace::default() }, 0);
        change(&mut tempo, json!({ "speed": 0.1 })).unwrap();
        assert_eq!(clock(&tempo, 1.5), r#"{"isPaused":false,"isStopped":false,"kind":"clock","speed":0.1,"t":1.5}"#);
        change(&mut tempo, json!({ "speed": "max", "isPaused": true })).unwrap();
        tempo.set_debugger_stop(true);
        assert_eq!(clock(&tempo, 2.0), r#"{"isPaused":true,"isStopped":true,"kind":"clock","speed":"max","t":2.0}"#);
        for speed in [json!(0), json!(-1), json!(101), json!("fast"), json!(null), json!({})] {
            assert!(change(&mut tempo, json!({ "speed": speed, "isPaused": false })).is_err(), "{speed}");
        }
        assert!(tempo.is_stopped(), "a command with a fault changes nothing");
    }
}
