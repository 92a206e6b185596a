//! How the controller's clock follows the one on the wall, and where time is left out.

use std::thread::sleep;
use std::time::{Duration, Instant};

use val3_lang::ports::{SECOND, Time};
use val3_machine::controller::Controller;
use val3_vm::CYCLE;

/// How long the outside is given to do something in each cycle while a program talks to it: a cycle, as long as it
/// takes.
const LISTENING: Duration = Duration::from_nanos(CYCLE);

/// The longest sleep.
const NAP: Time = SECOND / 10;

/// The pace of a run: by itself that of virtual time, without an end and without an operator.
#[derive(Debug, Default)]
pub(crate) struct Pace {
    /// When the controller's clock was 0, where it follows the one on the wall.
    pub(crate) started: Option<Instant>,
    pub(crate) until: Option<Time>,
    /// An operator may do something at any time.
    pub(crate) attended: bool,
}

impl Pace {
    /// The clock on the wall counts, and others may follow what happens.
    pub(crate) fn keeps_time(&self, controller: &Controller) -> bool {
        self.started.is_some() || controller.devices.lines.reach_outside()
    }

    /// Waits until the clock on the wall has come as far. In virtual time it counts while a program uses a line to the
    /// outside, which could not answer in time otherwise.
    pub(crate) fn follow(&self, controller: &Controller) {
        match self.started {
            Some(started) => {
                sleep((started + Duration::from_nanos(controller.now())).saturating_duration_since(Instant::now()));
            }
            None if controller.devices.lines.reach_outside() => sleep(LISTENING),
            None => {}
        }
    }

    /// All tasks wait until `wake`, or for the outside. Whether something can still happen.
    pub(crate) fn wait(&self, controller: &mut Controller, wake: Option<Time>) -> bool {
        if self.attended || controller.hears_outside() {
            // What comes from outside comes at its own time: the clock on the wall decides, cycle by cycle.
            self.follow(controller);
            return true;
        }
        let next = [wake, controller.next_due(), self.until].into_iter().flatten().min();
        self.jump(controller, next)
    }

    /// No task can go on: what comes over lines is of no use, but the operator may stop the application. Whether there
    /// is one, or a script says what one does.
    pub(crate) fn wait_for_operator(&self, controller: &mut Controller) -> bool {
        if self.attended {
            self.follow(controller);
            return true;
        }
        let next = controller.next_scripted().map(|due| self.until.map_or(due, |until| due.min(until)));
        self.jump(controller, next)
    }

    fn jump(&self, controller: &mut Controller, next: Option<Time>) -> bool {
        let Some(next) = next else { return false };
        // The clock on the wall may be interrupted.
        controller.jump(if self.started.is_some() { next.min(controller.now() + NAP) } else { next });
        self.follow(controller);
        true
    }
}
