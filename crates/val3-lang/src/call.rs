//! An instruction call at run time: its arguments, and its access to the controller.
//!
//! A form's handler is a function whose parameters have the types in its syntax line ([`FromArgument`]), and whose
//! result has the line's type ([`InstructionValue`]). It accesses data through the memory and everything else through
//! [`Ports`] and [`Tasks`]. A waiting instruction is called again in every turn of its task until it is done.

mod from_argument;
mod handler_result;
mod screen;

pub use from_argument::{
    Any, Arr, FrameRef, FromArgument, IoRef, LibraryRef, PointRef, ScreenRef, StoredValue, ToolRef, Var,
};
pub use handler_result::{HandlerResult, InstructionValue, PointValue};

use crate::fault::{Fault, Result};
use crate::memory::{Memory, Place, Slot, View};
use crate::ports::{Ports, Reply, Tasks, Time};
use crate::types::{Arm, BaseType, LengthUnit};
use crate::versions::Version;

/// Executes an instruction form.
pub type InstructionFn = fn(&mut Call<'_>) -> Result<Flow>;

/// Result of a call: done, or a wait.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Flow<T = ()> {
    /// The instruction is done.
    Done(T),
    /// The task has to wait. The instruction is called again in the task's next turn.
    Wait(Wait),
}

/// Condition for the end of a wait.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Wait {
    /// Time at which the wait ends; `None` if only an external event ends it.
    pub wake: Option<Time>,
    /// Whether only time ends the wait.
    pub sleeps: bool,
    /// Part of the instruction that waits, from 0. Preceding parts are not executed again.
    pub part: u8,
}

impl Wait {
    /// A wait for other tasks or external events.
    pub const FOR_OTHERS: Self = Self { wake: None, sleeps: false, part: 0 };
}

/// State of the instruction in which a task waits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Waiting {
    /// Start time of the wait.
    since: Time,
    /// Part of the instruction that waits.
    part: u8,
}

impl Waiting {
    /// State for the next call: the wait `before` continues, unless another part of the instruction has begun to wait.
    #[must_use]
    pub fn then(before: Option<Self>, wait: Wait, now: Time) -> Self {
        before.filter(|before| before.part == wait.part).unwrap_or(Self { since: now, part: wait.part })
    }
}

/// An argument as the program passes it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Argument {
    /// A value: the variable if the argument is one, otherwise a temporary.
    Value(Place, BaseType),
    /// A value of a user type.
    UserValue(Place),
    /// A container, or an array from an index.
    View(View),
    /// An element that need not exist.
    Slot(Slot),
    /// The library identifier before the colon, by its number in the application.
    Library(u16),
}

/// Memory and ports that an instruction can access.
pub struct Reach<'c> {
    /// All data.
    pub memory: &'c mut Memory,
    /// Access to everything outside of the program.
    pub ports: &'c mut dyn Ports,
    /// Tasks and libraries, from the calling task's point of view.
    pub tasks: &'c mut dyn Tasks,
}

/// Properties of the calling application.
#[derive(Debug, Clone, Copy)]
pub struct Caller {
    /// Version, which determines limits.
    pub version: Version,
    /// Length unit.
    pub unit: LengthUnit,
    /// Kind of arm for which its positions are, if known.
    pub arm: Option<Arm>,
}

/// An instruction call.
pub struct Call<'c> {
    /// All data.
    pub memory: &'c mut Memory,
    /// Access to everything outside of the program.
    pub ports: &'c mut dyn Ports,
    /// Tasks and libraries, from the calling task's point of view.
    pub tasks: &'c mut dyn Tasks,
    /// Controller time.
    now: Time,
    /// State of the wait, if the task has waited in this instruction.
    waiting: Option<Waiting>,
    /// Whether the instruction has read the clock, so that its result depends on the time.
    pub reads_clock: bool,
    /// Version of the application, which determines limits.
    pub version: Version,
    /// Length unit of the application.
    pub unit: LengthUnit,
    /// Kind of arm for which the application's positions are, if known.
    pub arm: Option<Arm>,
    arguments: &'c [Argument],
    next: usize,
    result: Option<Place>,
}

impl<'c> Call<'c> {
    /// Creates a call with these arguments and the destination `result` for its value.
    #[inline]
    pub fn new(
        reach: Reach<'c>,
        caller: Caller,
        now: Time,
        waiting: Option<Waiting>,
        arguments: &'c [Argument],
        result: Option<Place>,
    ) -> Self {
        let Reach { memory, ports, tasks } = reach;
        let Caller { version, unit, arm } = caller;
        Self { memory, ports, tasks, now, waiting, reads_clock: false, version, unit, arm, arguments, next: 0, result }
    }

    /// Returns the next argument.
    ///
    /// # Errors
    /// 61 without further arguments, which means that the program was compiled wrongly.
    #[inline]
    pub fn argument(&mut self) -> Result<Argument> {
        let found = self.arguments.get(self.next).copied().ok_or(Fault::INTERPRETER)?;
        self.next += 1;
        Ok(found)
    }

    /// Destination of the instruction's value; `None` if the program discards it.
    #[must_use]
    #[inline]
    pub fn result(&self) -> Option<Place> {
        self.result
    }

    /// Nanoseconds since the start of the controller, for instructions that return the time.
    pub fn now(&mut self) -> Time {
        self.reads_clock = true;
        self.now
    }

    /// Whether this is the first call, and not a call after a wait.
    #[must_use]
    pub fn is_first(&self) -> bool {
        self.waiting.is_none()
    }

    /// Part of the instruction that has waited; 0 at first.
    #[must_use]
    pub fn part(&self) -> u8 {
        self.waiting.map_or(0, |waiting| waiting.part)
    }

    /// Waiting time of the task in this instruction, in nanoseconds.
    #[must_use]
    pub fn waited(&self) -> Time {
        self.now.saturating_sub(self.since())
    }

    /// Waits for an external event, but at most until `time` nanoseconds after the task reached the instruction.
    #[must_use]
    pub fn wait_at_most<T>(&self, time: Time) -> Flow<T> {
        Flow::Wait(Wait { wake: Some(self.since().saturating_add(time)), sleeps: false, part: self.part() })
    }

    /// Waits until `time` nanoseconds after the task reached the instruction.
    #[must_use]
    pub fn sleep<T>(&self, time: Time) -> Flow<T> {
        Flow::Wait(Wait { wake: Some(self.since().saturating_add(time)), sleeps: true, part: self.part() })
    }

    /// Waits `time` nanoseconds from now, in a part of the instruction that begins here.
    #[must_use]
    pub fn sleep_in_part<T>(&self, part: u8, time: Time) -> Flow<T> {
        Flow::Wait(Wait { wake: Some(self.now.saturating_add(time)), sleeps: true, part })
    }

    fn since(&self) -> Time {
        self.waiting.map_or(self.now, |waiting| waiting.since)
    }
}

impl<T> Reply<T> {
    /// Converts the result to a value, or to a wait of the task.
    pub fn flow(self, call: &Call<'_>) -> Flow<T> {
        match self {
            Self::Done(value) => Flow::Done(value),
            Self::Wait(None) => Flow::Wait(Wait::default()),
            Self::Wait(Some(time)) => call.wait_at_most(time),
        }
    }
}

impl std::fmt::Debug for Call<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Call").field("arguments", &self.arguments).finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use super::{Wait, Waiting};

    #[test]
    fn each_part_of_a_line_has_its_own_wait() {
        let first = Waiting::then(None, Wait::FOR_OTHERS, 10);
        assert_eq!(first, Waiting { since: 10, part: 0 });
        assert_eq!(Waiting::then(Some(first), Wait::FOR_OTHERS, 20), first);
        let next = Wait { part: 1, ..Wait::FOR_OTHERS };
        assert_eq!(Waiting::then(Some(first), next, 30), Waiting { since: 30, part: 1 });
    }
}
