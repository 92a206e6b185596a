//! Restart of a program: going back to the moment at which a task entered it.

use std::error::Error;
use std::fmt;
use std::ops::ControlFlow;

use val3_lang::ports::TaskNumber;
use val3_machine::controller::RunStatus;
use val3_vm::CycleWatch;

use crate::debugger::{Debugger, Stop};
use crate::history::Moment;

/// Reason why the run cannot go back to the beginning of a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RestartFault {
    /// There is no such task or stack frame.
    NoFrame,
    /// The history is not recorded.
    NoPast,
    /// The recorded history begins later.
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
    /// Goes back to the moment at which a task entered a program on its stack, before the program's first line. `depth`
    /// 0 is the innermost program. Data, arm, inputs and outputs are restored. The stop is [`Stop::Step`], or a stop at
    /// the breakpoints of the line.
    ///
    /// # Errors
    /// There is no such stack frame, or the moment is not in the recorded history. The run then stays at its present
    /// moment.
    pub fn restart_frame(&mut self, task: TaskNumber, depth: usize) -> Result<Stop, RestartFault> {
        let frames = self.frame_count(task).ok_or(RestartFault::NoFrame)?;
        let entered = frames.checked_sub(depth).filter(|count| *count > 0).ok_or(RestartFault::NoFrame)?;
        let first = self.first_moment().ok_or(RestartFault::NoPast)?;
        let present = Moment::of(&self.controller);
        let calls = self.controller.vm.fragments_below(task, entered);
        let contacts = self.contacts.clone();
        if self.has_just_entered(task, entered) {
            return Ok(Stop::Step { task });
        }
        let stop = self.back_to_last(
            |_| CycleWatch::Lines,
            &mut |_| ControlFlow::Continue(()),
            |debugger, replayed| {
                match replayed.status {
                    // A program is called by the task itself. Its first program is entered when another task creates the
                    // task.
                    RunStatus::Seen(seen)
                        if (seen == task || entered == 1)
                            && debugger.has_just_entered(task, entered)
                            && debugger.controller.vm.fragments_below(task, entered) == calls =>
                    {
                        Some(Stop::Step { task })
                    }
                    _ => None,
                }
            },
        );
        let stop = stop.unwrap_or(Stop::Beginning);
        if stop != Stop::Beginning || (first.time == 0 && calls == 0 && self.has_just_entered(task, entered)) {
            return Ok(if stop == Stop::Beginning { Stop::Step { task } } else { stop });
        }
        self.go_to(present);
        self.contacts = contacts;
        Err(RestartFault::OutOfReach)
    }

    fn frame_count(&self, task: TaskNumber) -> Option<usize> {
        let task = self.controller.vm.tasks().iter().find(|known| known.id == task)?;
        Some(task.thread.frames.len())
    }

    /// Whether the task has this number of stack frames, and is before the first line of the innermost program.
    fn has_just_entered(&self, task: TaskNumber, frames: usize) -> bool {
        self.frame_count(task) == Some(frames) && self.controller.vm.begins_program(task)
    }
}

#[cfg(test)]
mod tests {
    use val3_tests::running::Running;

    use super::*;
    use crate::contacts::Contact;
    use crate::debugger::AdvanceResult;
    use crate::history::PastLimits;

    #[test]
    fn a_contact_stops_the_run_also_after_a_restart_that_is_out_of_reach() {
        let listing = "num nCount\nprogram start()\nbegin\n  while true\n    nCount=nCount+1\n  endWhile\nend\n";
        let mut debugger = Debugger::new(Running::start(listing).controller);
        debugger.advance();
        debugger.record(PastLimits::default());
        debugger.advance();
        let names = ["rod", "wall"].map(str::to_owned);
        let contacts = vec![Contact { names, depth: 1.0, at_start: false, of: None }];
        debugger.contacts.clone_from(&contacts);
        let task = debugger.controller.vm.tasks()[0].id;
        assert_eq!(debugger.restart_frame(task, 0), Err(RestartFault::OutOfReach));
        assert_eq!(debugger.advance(), AdvanceResult::Stopped(Stop::Contacts(contacts)));
    }
}
