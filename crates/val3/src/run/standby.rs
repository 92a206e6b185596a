//! Controller after the end of its application: the operator still switches the power and moves the arm by hand.

use std::time::Duration;

use serde_json::{Map, Value};
use val3_lang::ports::{SECOND, Time};
use val3_machine::controller::{Controller, RunStatus};

use super::end::End;
use super::guide::ATTENTION;
use super::tempo::Tempo;
use super::viewers::Viewers;

/// Controller time after a command of the operator within which its effects begin.
const EFFECT: Time = SECOND / 5;

/// Reason why commands are not executed after the end of a run.
pub(super) const ENDED: &str = "the run has ended; Run starts the application again";

/// Reason why the arm is not moved if the run has ended before its application.
const INTERRUPTED: &str = "the run has ended while the application was running, so the arm is not moved; Run starts \
                           the application again";

/// Controller of an ended run. Its clock only advances while something happens.
pub(super) struct Standby {
    pub(super) controller: Controller,
    tempo: Tempo,
    /// Whether no task remains that could continue.
    is_idle: bool,
    /// Time up to which the clock advances in any case.
    until: Time,
    /// Whether the clock has advanced in the last turn.
    is_advancing: bool,
}

impl Standby {
    /// Takes the controller of a run with this end. Moves that the application has recorded are discarded.
    pub(super) fn new(mut controller: Controller, tempo: Tempo, end: End) -> Self {
        let is_idle = matches!(end, End::Controller(RunStatus::Finished | RunStatus::Stopped));
        if is_idle {
            controller.set_limit(None);
            controller.discard_moves();
            // They belong to no cycle, and viewers have already received the moves that were not executed.
            controller.devices.take_events();
        }
        let until = controller.now();
        Self { controller, tempo, is_idle, until, is_advancing: false }
    }

    /// Checks whether the operator may execute a command `operate`, and lets the clock advance for its effects.
    ///
    /// # Errors
    /// The reason for the operator.
    pub(super) fn prepare(&mut self, arguments: &Map<String, Value>) -> Result<(), String> {
        if !self.is_idle {
            return Err(INTERRUPTED.to_owned());
        }
        if arguments.get("keys").and_then(|keys| keys.get("stop")).is_some() {
            return Err(ENDED.to_owned());
        }
        self.until = self.controller.now().saturating_add(EFFECT);
        Ok(())
    }

    /// Real time until the next cycle, or until signals are polled again.
    pub(super) fn wait_time(&self) -> Duration {
        if self.is_advancing { self.tempo.wait_time(self.tempo.pace.follow(&self.controller)) } else { ATTENTION }
    }

    /// Runs a cycle if the arm moves, the power changes, or the operator has executed a command.
    pub(super) fn advance(&mut self, viewers: &mut Viewers) {
        let is_busy = self.is_busy();
        if is_busy && !self.is_advancing {
            self.tempo.restart_clock(self.controller.now());
        }
        let was_advancing = std::mem::replace(&mut self.is_advancing, is_busy);
        if !is_busy {
            if was_advancing {
                viewers.see_rest(&self.controller);
            }
            return;
        }
        let start = self.controller.now();
        self.controller.step_tasks();
        let events = self.controller.devices.take_events();
        viewers.see_standby(start, &events, &self.controller);
    }

    fn is_busy(&self) -> bool {
        let state = &self.controller.devices.state;
        let is_moving = !state.arm.is_settled() || state.robot.next_due().is_some();
        self.is_idle && (is_moving || self.controller.now() < self.until)
    }
}
