//! Step mode of the motion (10.2.2).
//!
//! In step mode the arm moves only after a release. A line that records a move, or otherwise determines more of the
//! path (`waitEndMove`), releases the arm: all tasks rest until the arm is at the end of the determined path. If the
//! run continues, it stops there; a step of a task continues or ends there.
//!
//! Pieces of the path that were determined before the change to step mode are released by [`Debugger::step_motion`], by
//! the next line that determines more of the path, or by a task that can continue only after the arm has moved: a task
//! that waits, without a timeout, in a line with an instruction about the arm. A loop that polls the arm does not
//! release it.

use val3_lang::ports::TaskNumber;
use val3_machine::arm::{ArmHold, MotionMode};
use val3_machine::controller::RunStatus;

use crate::debugger::{AdvanceResult, Debugger, Stop};
use crate::history::SnapshotReason;
use crate::travel::{MotionStop, Then, Travel};

impl Debugger {
    /// Returns the chosen motion mode.
    #[must_use]
    pub const fn motion_mode(&self) -> MotionMode {
        self.mode
    }

    /// Sets the motion mode, also while the arm moves. Discards the recorded future.
    pub fn set_motion_mode(&mut self, mode: MotionMode) {
        if std::mem::replace(&mut self.mode, mode) != mode {
            self.controller.arm_mut().set_mode(mode);
            self.begin_new_future();
        }
    }

    /// Sets the chosen motion mode after the run has gone back. In step mode the arm has no release afterwards.
    pub(crate) fn settle_motion(&mut self) {
        self.travel = None;
        self.controller.rest_tasks(false);
        self.controller.arm_mut().set_mode(MotionMode::Continuous);
        self.controller.arm_mut().set_mode(self.mode);
    }

    /// Releases one piece of the path while all tasks rest. The run then stops with [`Stop::Motion`], also if no piece
    /// is determined or the arm is held. A moving arm continues to the end of the piece.
    pub fn step_motion(&mut self) {
        self.controller.arm_mut().release_piece();
        self.travel(Travel { task: None, then: Then::StopForMotion });
    }

    /// Starts the motion that the last part of a cycle has released.
    pub(crate) fn follow_motion(&mut self, revision: u64, progress: AdvanceResult) -> AdvanceResult {
        if self.mode == MotionMode::Continuous {
            return progress;
        }
        let is_more_determined = self.controller.arm().motion().revision() != revision;
        let task = match progress {
            AdvanceResult::Ran(RunStatus::Seen(task)) if is_more_determined => Some(task),
            AdvanceResult::Ran(RunStatus::Busy | RunStatus::Waiting(_)) => self.task_that_awaits_arm(),
            AdvanceResult::Stopped(Stop::Step { task } | Stop::Breakpoints { task, .. }) if is_more_determined => {
                Some(task)
            }
            _ => None,
        };
        if task.is_none() && !is_more_determined {
            return progress;
        }
        let then = match progress {
            AdvanceResult::Stopped(stop) => {
                self.pending = Some(stop);
                Then::Stop
            }
            AdvanceResult::Ran(_) if self.step.is_some() => Then::Continue,
            AdvanceResult::Ran(_) => Then::StopForMotion,
        };
        self.controller.arm_mut().release_determined();
        self.travel(Travel { task, then });
        match self.end_travel() {
            // The line has changed the queue without a motion.
            Some(AdvanceResult::Stopped(Stop::Motion(stop))) if then == Then::StopForMotion && stop.hold.is_none() => {
                AdvanceResult::Ran(RunStatus::Busy)
            }
            end => end.unwrap_or(AdvanceResult::Ran(RunStatus::Busy)),
        }
    }

    /// Returns the task that can continue only after the arm has moved, if the arm waits for a release.
    fn task_that_awaits_arm(&self) -> Option<TaskNumber> {
        let controller = &self.controller;
        if !controller.arm().motion().waits_for_release() {
            return None;
        }
        let tasks = controller.vm.tasks().iter().filter(|task| !task.is_held).map(|task| task.id);
        let mut tasks = tasks.filter(|task| self.step.is_none_or(|step| step.task == *task));
        tasks.find(|task| controller.awaits_arm(*task))
    }

    fn travel(&mut self, travel: Travel) {
        let cause = if travel.task.is_some() { SnapshotReason::Release } else { SnapshotReason::Change };
        self.travel = Some(travel);
        self.controller.rest_tasks(true);
        self.change_future(cause);
    }

    /// Runs one cycle of a motion during which all tasks rest; `None` if there is no such motion.
    pub(crate) fn advance_travel(&mut self) -> Option<AdvanceResult> {
        self.travel.as_ref()?;
        if let Some(end) = self.end_travel() {
            return Some(end);
        }
        let status = self.controller.step();
        self.pass_cycle();
        if status.is_final() && status != RunStatus::Stuck {
            self.travel = None;
            self.controller.rest_tasks(false);
            return Some(AdvanceResult::Ran(status));
        }
        Some(self.end_travel().unwrap_or(AdvanceResult::Ran(RunStatus::Busy)))
    }

    /// Ends a motion during which all tasks rest, if the arm has arrived or does not continue.
    fn end_travel(&mut self) -> Option<AdvanceResult> {
        let hold = self.controller.devices.state.arm_standstill();
        if hold.is_none() && !self.controller.arm().motion().has_arrived() {
            return None;
        }
        let Travel { task, then } = self.travel.take()?;
        self.controller.rest_tasks(false);
        self.change_future(SnapshotReason::Arrival);
        let pending = self.pending.take().filter(|_| then == Then::Stop);
        let stop = match (pending, hold) {
            (None, None) if then == Then::Continue && self.step.is_some() => {
                return Some(AdvanceResult::Ran(RunStatus::Busy));
            }
            (Some(stop), None) => stop,
            (Some(stop @ Stop::Breakpoints { .. }), Some(_)) => stop,
            _ => Stop::Motion(Box::new(self.motion_stop(task, hold))),
        };
        self.abandon_step();
        Some(AdvanceResult::Stopped(stop))
    }

    fn motion_stop(&self, task: Option<TaskNumber>, hold: Option<ArmHold>) -> MotionStop {
        let status = self.controller.motion_status();
        MotionStop { task, piece: status.piece, has_next: status.next.is_some(), hold }
    }
}
