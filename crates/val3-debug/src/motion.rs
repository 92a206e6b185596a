//! Steps of the motion (manual 10.2.2).
//!
//! In step mode the arm moves only when it is released. A line that records a move, or otherwise determines more of the
//! path (`waitEndMove`), releases it: all tasks rest until the arm is at the end of everything that is determined. While
//! the run continues, that is a stop; a step of a task continues or ends there.
//!
//! Pieces of the path that were determined before the step mode was chosen wait for [`Debugger::step_motion`], for the
//! next line that determines more, or for a task that can only continue once the arm has moved: it waits, without a time,
//! in a line with an instruction about the arm. A program that asks for the arm again and again in a loop does not
//! release it.

use val3_lang::ports::TaskNumber;
use val3_machine::arm::{ArmHold, MotionMode};
use val3_machine::controller::Outcome;

use crate::debugger::{Debugger, Progress, Stop};
use crate::history::Cause;
use crate::travel::{MotionStop, Then, Travel};

impl Debugger {
    /// The mode of the motion.
    #[must_use]
    pub const fn motion_mode(&self) -> MotionMode {
        self.mode
    }

    /// Chooses the mode of the motion, also while the arm moves. A new future begins here.
    pub fn set_motion_mode(&mut self, mode: MotionMode) {
        if std::mem::replace(&mut self.mode, mode) != mode {
            self.controller.set_motion_mode(mode);
            self.begin_new_future();
        }
    }

    /// The run has gone back: the mode is the chosen one, and in step mode the arm has no release.
    pub(crate) fn settle_motion(&mut self) {
        self.travel = None;
        self.controller.rest_tasks(false);
        self.controller.set_motion_mode(MotionMode::Continuous);
        self.controller.set_motion_mode(self.mode);
    }

    /// Lets the arm advance by one piece while all tasks rest. The run then stops with [`Stop::Motion`], also if no piece
    /// is determined or something holds the arm. An arm that moves goes to the end of its piece.
    pub fn step_motion(&mut self) {
        self.controller.step_motion();
        self.travel(Travel { task: None, then: Then::StopForMotion });
    }

    /// A part of a cycle has passed: lets the arm move where a line has released it.
    pub(crate) fn follow_motion(&mut self, revision: u64, progress: Progress) -> Progress {
        if self.mode == MotionMode::Continuous {
            return progress;
        }
        let is_more_determined = self.controller.motion_revision() != revision;
        let task = match progress {
            Progress::Ran(Outcome::Seen(task)) if is_more_determined => Some(task),
            Progress::Ran(Outcome::Busy | Outcome::Waiting(_)) => self.task_that_awaits_arm(),
            Progress::Stopped(Stop::Step { task } | Stop::Breakpoints { task, .. }) if is_more_determined => Some(task),
            _ => None,
        };
        if task.is_none() && !is_more_determined {
            return progress;
        }
        let then = match progress {
            Progress::Stopped(stop) => {
                self.pending = Some(stop);
                Then::Stop
            }
            Progress::Ran(_) if self.step.is_some() => Then::Continue,
            Progress::Ran(_) => Then::StopForMotion,
        };
        self.controller.release_motion();
        self.travel(Travel { task, then });
        match self.end_travel() {
            // The line has changed the queue without a motion.
            Some(Progress::Stopped(Stop::Motion(stop))) if then == Then::StopForMotion && stop.hold.is_none() => {
                Progress::Ran(Outcome::Busy)
            }
            end => end.unwrap_or(Progress::Ran(Outcome::Busy)),
        }
    }

    /// The task that can only continue once the arm has moved, which waits for a release.
    fn task_that_awaits_arm(&self) -> Option<TaskNumber> {
        let controller = &self.controller;
        let mut tasks = controller.vm.tasks().iter().filter(|task| !task.is_held).map(|task| task.id);
        let is_asked =
            |task: &TaskNumber| self.step.is_none_or(|step| step.task == *task) && controller.awaits_arm(*task);
        controller.motion_awaits_release().then(|| tasks.find(is_asked)).flatten()
    }

    fn travel(&mut self, travel: Travel) {
        let cause = if travel.task.is_some() { Cause::Release } else { Cause::Change };
        self.travel = Some(travel);
        self.controller.rest_tasks(true);
        self.change_future(cause);
    }

    /// Runs a cycle of a motion for which all tasks rest; none if there is no such motion.
    pub(crate) fn advance_travel(&mut self) -> Option<Progress> {
        self.travel.as_ref()?;
        if let Some(end) = self.end_travel() {
            return Some(end);
        }
        let outcome = self.controller.step();
        self.pass_cycle();
        if outcome.is_final() && outcome != Outcome::Stuck {
            self.travel = None;
            self.controller.rest_tasks(false);
            return Some(Progress::Ran(outcome));
        }
        Some(self.end_travel().unwrap_or(Progress::Ran(Outcome::Busy)))
    }

    /// Ends a motion for which all tasks rest, once the arm has arrived or does not move on.
    fn end_travel(&mut self) -> Option<Progress> {
        let hold = self.controller.motion_hold();
        if hold.is_none() && !self.controller.motion_has_arrived() {
            return None;
        }
        let Travel { task, then } = self.travel.take()?;
        self.controller.rest_tasks(false);
        self.change_future(Cause::Arrival);
        let pending = self.pending.take().filter(|_| then == Then::Stop);
        let stop = match (pending, hold) {
            (None, None) if then == Then::Continue && self.step.is_some() => {
                return Some(Progress::Ran(Outcome::Busy));
            }
            (Some(stop), None) => stop,
            (Some(stop @ Stop::Breakpoints { .. }), Some(_)) => stop,
            _ => Stop::Motion(Box::new(self.motion_stop(task, hold))),
        };
        self.abandon_step();
        Some(Progress::Stopped(stop))
    }

    fn motion_stop(&self, task: Option<TaskNumber>, hold: Option<ArmHold>) -> MotionStop {
        let status = self.controller.motion_status();
        MotionStop { task, piece: status.piece, has_next: status.next.is_some(), hold }
    }
}
