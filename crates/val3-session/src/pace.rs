//! Pace of a run: waits for the real clock, and idle time that the controller skips.

use std::time::Duration;

use val3_lang::ports::{SECOND, Time};
use val3_machine::controller::Controller;
use val3_vm::CYCLE;

/// Minimum real time per cycle while a line has a peer, or a program waits for an operator or for the first client of a
/// server. Without it, external data could not arrive in time.
const LISTENING: Duration = Duration::from_nanos(CYCLE);

/// Longest wait in real time, in nanoseconds of controller time. The caller checks for interrupts between waits.
const LONGEST_WAIT: Time = SECOND / 10;

/// Pace of a run. The default is virtual time, without an end and without an operator.
#[derive(Debug, Clone, Default)]
pub struct Pace {
    /// Whether the controller's clock follows the real clock.
    pub real_time: bool,
    /// Controller time at which the run ends, in nanoseconds.
    pub until: Option<Time>,
    /// Whether an operator may act at any time.
    pub attended: bool,
}

/// A wait in real time. The caller performs it, because no crate below the binaries uses the real clock.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Delay {
    /// No wait.
    None,
    /// Until the real clock has reached this controller time, in nanoseconds since the start.
    Until(Time),
    /// For this duration.
    For(Duration),
}

impl Pace {
    /// Whether events must be displayed during the run, because real time passes.
    pub fn keeps_time(&self, controller: &Controller) -> bool {
        let lines = &controller.devices.lines;
        self.real_time || lines.have_outside_peer() || self.until.is_none() && lines.reach_outside()
    }

    /// Wait after a cycle with busy tasks.
    pub fn follow(&self, controller: &Controller) -> Delay {
        match self.real_time {
            true => Delay::Until(controller.now()),
            false if controller.devices.lines.have_outside_peer() => Delay::For(LISTENING),
            false => Delay::None,
        }
    }

    /// Advances the clock while all tasks wait until `wake` or for external events. `None` if nothing can happen any
    /// more.
    pub fn wait(&self, controller: &mut Controller, wake: Option<Time>) -> Option<Delay> {
        if self.attended && self.real_time || controller.devices.lines.are_in_use() {
            // External events arrive in real time, so the clock advances cycle by cycle. Before a peer is connected, no
            // real time passes, unless only a peer can end the wait.
            let awaits_peer = self.until.is_none() && wake.is_none() && controller.next_due().is_none();
            return Some(match self.follow(controller) {
                Delay::None if awaits_peer => Delay::For(LISTENING),
                Delay::None => {
                    self.skip_unconnected(controller, wake);
                    Delay::None
                }
                delay => delay,
            });
        }
        let next = wake.into_iter().chain(controller.next_due()).min();
        if self.attended && next.is_none() {
            // Without a wait, the controller time would advance by hours until the operator acts.
            return Some(Delay::For(LISTENING));
        }
        self.jump(controller, next.into_iter().chain(self.until).min())
    }

    /// Advances the clock of a run with an end while no line has a peer. Peers can still connect, because lines are
    /// read between the jumps. A replay repeats the same jumps, because it depends on the same states.
    fn skip_unconnected(&self, controller: &mut Controller, wake: Option<Time>) {
        if let Some(until) = self.until
            && !self.attended
            && !controller.devices.lines.have_peer()
        {
            let latest = until.min(controller.now().saturating_add(LONGEST_WAIT));
            controller.jump(wake.into_iter().chain(controller.next_due()).fold(latest, Time::min));
        }
    }

    /// Advances the clock while no task can continue. Lines have no effect then, but an operator or a script may stop
    /// the application. `None` without an operator or script.
    pub fn wait_for_operator(&self, controller: &mut Controller) -> Option<Delay> {
        if self.attended {
            return Some(if self.real_time { self.follow(controller) } else { Delay::For(LISTENING) });
        }
        let next = controller.next_action().map(|due| self.until.map_or(due, |until| due.min(until)));
        self.jump(controller, next)
    }

    fn jump(&self, controller: &mut Controller, next: Option<Time>) -> Option<Delay> {
        let next = next?;
        controller.jump(if self.real_time { next.min(controller.now() + LONGEST_WAIT) } else { next });
        Some(self.follow(controller))
    }
}
