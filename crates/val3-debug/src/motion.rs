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
use val3_machine::controller::{MotionPiece, Outcome};

use crate::debugger::{Debugger, Progress, Stop};
use crate::history::Cause;

/// The end of a motion for which all tasks have rested.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionStop {
    /// The task whose line has released the arm; none after [`Debugger::step_motion`].
    pub task: Option<TaskNumber>,
    /// The piece at whose end the arm is, or in which it does not move on. None if it has begun none.
    pub piece: Option<MotionPiece>,
    /// Whether another piece is determined.
    pub has_next: bool,
    /// Why the arm does not move, where it has not arrived.
    pub hold: Option<ArmHold>,
}

/// A motion for which all tasks rest.
#[derive(Debug, Clone)]
pub(crate) struct Travel {
    /// The task whose line has released the arm.
    task: Option<TaskNumber>,
    then: Then,
}

/// What follows a motion.
#[derive(Debug, Clone)]
enum Then {
    /// The run stops for this.
    Stop(Stop),
    /// The run stops for the motion.
    StopForMotion,
    /// A step that is not done continues.
    Continue,
}

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
            Progress::Stopped(stop) => Then::Stop(stop),
            Progress::Ran(_) if self.step.is_some() => Then::Continue,
            Progress::Ran(_) => Then::StopForMotion,
        };
        self.controller.release_motion();
        self.travel(Travel { task, then });
        self.end_travel().unwrap_or(Progress::Ran(Outcome::Busy))
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
        let stop = match (then, hold) {
            (Then::Continue, None) if self.step.is_some() => return Some(Progress::Ran(Outcome::Busy)),
            (Then::Stop(stop), None) => stop,
            (Then::Stop(stop @ Stop::Breakpoints { .. }), Some(_)) => stop,
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
