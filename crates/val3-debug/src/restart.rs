//! Restarts of programs: going back to the moment at which a task entered one.

use std::error::Error;
use std::fmt;
use std::ops::ControlFlow;

use val3_lang::ports::TaskNumber;
use val3_machine::controller::Outcome;
use val3_vm::Watch;

use crate::debugger::{Debugger, Stop};
use crate::history::Moment;

/// Why the run cannot go back to a beginning.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RestartFault {
    /// There is no such task or frame.
    NoFrame,
    /// The past is not recorded.
    NoPast,
    /// The past that is kept begins later.
    OutOfReach,
}

impl fmt::Display for RestartFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NoFrame => "the task is no longer in this program",
            Self::NoPast => "the run is not recorded",
            Self::OutOfReach => "the moment is further back than the recorded past reaches",
        })
    }
}

impl Error for RestartFault {}

impl Debugger {
    /// Goes back to the moment at which a program that a task is in was entered, before its first line; 0 is the innermost
    /// one. Data, arm, inputs and outputs are as they were then. The stop is [`Stop::Step`], or the one at the breakpoints of
    /// the line.
    ///
    /// # Errors
    /// There is no such frame, or the moment is out of reach. The run stays where it is.
    pub fn restart_frame(&mut self, task: TaskNumber, depth: usize) -> Result<Stop, RestartFault> {
        let frames = self.frame_count(task).ok_or(RestartFault::NoFrame)?;
        let entered = frames.checked_sub(depth).filter(|count| *count > 0).ok_or(RestartFault::NoFrame)?;
        let first = self.first_moment().ok_or(RestartFault::NoPast)?;
        let present = Moment::of(&self.controller);
        if self.has_just_entered(task, entered) {
            return Ok(Stop::Step { task });
        }
        let stop = self.back_to_last(Watch::Lines, &mut |_| ControlFlow::Continue(()), |debugger, replayed| {
            match replayed.outcome {
                // The task itself calls a program. Its first one is entered when another task has created it.
                Outcome::Seen(seen) if (seen == task || entered == 1) && debugger.has_just_entered(task, entered) => {
                    Some(Stop::Step { task })
                }
                _ => None,
            }
        });
        let stop = stop.unwrap_or(Stop::Beginning);
        if stop != Stop::Beginning || (first.time == 0 && self.has_just_entered(task, entered)) {
            return Ok(if stop == Stop::Beginning { Stop::Step { task } } else { stop });
        }
        self.go_to(present);
        Err(RestartFault::OutOfReach)
    }

    fn frame_count(&self, task: TaskNumber) -> Option<usize> {
        let task = self.controller.vm.tasks().iter().find(|known| known.id == task)?;
        Some(task.thread.frames.len())
    }

    /// Whether a task with this number of frames is before the first line of the innermost program.
    fn has_just_entered(&self, task: TaskNumber, frames: usize) -> bool {
        self.frame_count(task) == Some(frames) && self.controller.vm.begins_program(task)
    }
}
