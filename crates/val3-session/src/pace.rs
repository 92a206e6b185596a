//! The pace of a run: when the controller waits for the real clock, and which idle time it skips.

use std::time::Duration;

use val3_lang::ports::{SECOND, Time};
use val3_machine::controller::Controller;
use val3_vm::CYCLE;

/// The least real time for the outside in each cycle while a line has a peer, or a program waits for an operator or for
/// the first caller of a server. Without it, an answer could not arrive in time.
const LISTENING: Duration = Duration::from_nanos(CYCLE);

/// The longest wait in real time, in nanoseconds of the controller: the caller checks for interrupts in between.
const LONGEST_WAIT: Time = SECOND / 10;

/// The pace of a run. By default virtual time, without an end and without an operator.
#[derive(Debug, Clone, Default)]
pub struct Pace {
    /// The controller's clock follows the real one.
    pub real_time: bool,
    /// The time of the controller's clock at which the run ends, in nanoseconds.
    pub until: Option<Time>,
    /// An operator may act at any time.
    pub attended: bool,
}

/// A wait in real time. The caller performs it: below the binaries nothing knows the real clock.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Delay {
    /// No wait.
    None,
    /// Until the real clock has reached this time of the controller's clock, in nanoseconds since the start.
    Until(Time),
    /// For this time.
    For(Duration),
}

impl Pace {
    /// Whether events must be shown during the run, because real time passes.
    pub fn keeps_time(&self, controller: &Controller) -> bool {
        let lines = &controller.devices.lines;
        self.real_time || lines.have_outside_peer() || self.until.is_none() && lines.reach_outside()
    }

    /// The wait after a cycle in which tasks were busy.
    pub fn follow(&self, controller: &Controller) -> Delay {
        match self.real_time {
            true => Delay::Until(controller.now()),
            false if controller.devices.lines.have_outside_peer() => Delay::For(LISTENING),
            false => Delay::None,
        }
    }

    /// Advances the clock while all tasks wait until `wake`, or for the outside. `None` if nothing can happen any more.
    pub fn wait(&self, controller: &mut Controller, wake: Option<Time>) -> Option<Delay> {
        if self.attended && self.real_time || controller.hears_outside() {
            // Events from outside come in real time: one cycle after the other. No time passes on the wall before a peer
            // is connected, unless only a peer can end the wait.
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
            // Without a wait the clock would run for hours until the operator acts.
            return Some(Delay::For(LISTENING));
        }
        self.jump(controller, next.into_iter().chain(self.until).min())
    }

    /// Advances the clock of a run with an end while no line has a peer. Peers can still connect, because lines are read
    /// between the jumps. A replay of the run jumps alike, because it depends on the same states.
    fn skip_unconnected(&self, controller: &mut Controller, wake: Option<Time>) {
        if let Some(until) = self.until
            && !self.attended
            && !controller.devices.lines.have_peer()
        {
            let latest = until.min(controller.now().saturating_add(LONGEST_WAIT));
            controller.jump(wake.into_iter().chain(controller.next_due()).fold(latest, Time::min));
        }
    }

    /// Advances the clock while no task can continue. Lines cannot help then, but an operator or a script may stop the
    /// application. `None` if there is neither.
    pub fn wait_for_operator(&self, controller: &mut Controller) -> Option<Delay> {
        if self.attended {
            return Some(if self.real_time { self.follow(controller) } else { Delay::For(LISTENING) });
        }
        let next = controller.next_scripted().map(|due| self.until.map_or(due, |until| due.min(until)));
        self.jump(controller, next)
    }

    fn jump(&self, controller: &mut Controller, next: Option<Time>) -> Option<Delay> {
        let next = next?;
        controller.jump(if self.real_time { next.min(controller.now() + LONGEST_WAIT) } else { next });
        Some(self.follow(controller))
    }
}
