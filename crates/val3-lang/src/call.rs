//! A call of an instruction at run time: its arguments, and what it may reach.
//!
//! The handler of a form is a plain function whose parameters are the types of its syntax line ([`FromArgument`]) and whose
//! value is that of the line ([`InstructionValue`]). It reaches data through the memory and everything else through [`Ports`] and
//! [`Tasks`]. An instruction that has to wait is called again in each turn of its task until it is done.

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

/// Executes one form of an instruction.
pub type InstructionFn = fn(&mut Call<'_>) -> Result<Flow>;

/// Whether an instruction is done.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Flow<T = ()> {
    /// It is.
    Done(T),
    /// The task has to wait: the instruction is called again in its next turn.
    Wait(Wait),
}

/// The condition under which a waiting task continues.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Wait {
    /// When time ends the wait; `None` where only the doing of others does.
    pub wake: Option<Time>,
    /// Nothing but time ends it.
    pub sleeps: bool,
    /// The part of the instruction that waits, from 0 on: what is done before a later part is not done again.
    pub part: u8,
}

impl Wait {
    /// The wait for what other tasks or the outside do.
    pub const FOR_OTHERS: Self = Self { wake: None, sleeps: false, part: 0 };
}

/// The state of the instruction in which a task waits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Waiting {
    /// When the wait began.
    since: Time,
    /// The part of the instruction that waits.
    part: u8,
}

impl Waiting {
    /// The wait at the next call: the wait `before` continues, unless another part of the instruction has begun one.
    #[must_use]
    pub fn then(before: Option<Self>, wait: Wait, now: Time) -> Self {
        before.filter(|before| before.part == wait.part).unwrap_or(Self { since: now, part: wait.part })
    }
}

/// One argument as the program passes it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Argument {
    /// A value: a variable where the argument is one, else a temporary.
    Value(Place, BaseType),
    /// A value of a user type.
    UserValue(Place),
    /// A container, or an array from an index on.
    View(View),
    /// A place that need not exist.
    Slot(Slot),
    /// The library identifier before the colon, by its number in the application.
    Library(u16),
}

/// A call that is being executed.
pub struct Call<'c> {
    /// All data.
    pub memory: &'c mut Memory,
    /// Everything outside the program.
    pub ports: &'c mut dyn Ports,
    /// Tasks and libraries, as the calling task sees them.
    pub tasks: &'c mut dyn Tasks,
    /// The controller's clock.
    now: Time,
    /// The wait of the task in this instruction, if it has waited.
    waiting: Option<Waiting>,
    /// The instruction has looked at the clock: what it yields depends on the time.
    pub reads_clock: bool,
    /// The version of the application: which limits hold.
    pub version: Version,
    /// The unit of lengths in the application.
    pub unit: LengthUnit,
    /// The kind of arm that the positions of the application are for, if they are for one.
    pub arm: Option<Arm>,
    arguments: &'c [Argument],
    next: usize,
    result: Option<Place>,
}

impl<'c> Call<'c> {
    /// A call with these arguments, whose value goes to `result`.
    #[inline]
    pub fn new(
        (memory, ports, tasks): (&'c mut Memory, &'c mut dyn Ports, &'c mut dyn Tasks),
        (now, waiting): (Time, Option<Waiting>),
        (version, unit, arm): (Version, LengthUnit, Option<Arm>),
        arguments: &'c [Argument],
        result: Option<Place>,
    ) -> Self {
        Self { memory, ports, tasks, now, waiting, reads_clock: false, version, unit, arm, arguments, next: 0, result }
    }

    /// The next argument.
    ///
    /// # Errors
    /// 61 if there is none: the program was compiled wrongly.
    #[inline]
    pub fn argument(&mut self) -> Result<Argument> {
        let found = self.arguments.get(self.next).copied().ok_or(Fault::INTERPRETER)?;
        self.next += 1;
        Ok(found)
    }

    /// Where the value of the instruction goes; `None` where the program drops it.
    #[must_use]
    #[inline]
    pub fn result(&self) -> Option<Place> {
        self.result
    }

    /// Nanoseconds since the controller was started; for instructions that yield the time.
    pub fn now(&mut self) -> Time {
        self.reads_clock = true;
        self.now
    }

    /// The instruction is not called again after a wait.
    #[must_use]
    pub fn is_first(&self) -> bool {
        self.waiting.is_none()
    }

    /// The part of the instruction that has waited; 0 at first.
    #[must_use]
    pub fn part(&self) -> u8 {
        self.waiting.map_or(0, |waiting| waiting.part)
    }

    /// Nanoseconds that the task has waited in this instruction.
    #[must_use]
    pub fn waited(&self) -> Time {
        self.now.saturating_sub(self.since())
    }

    /// The wait until something happens, or `time` nanoseconds have passed since the task reached the instruction.
    #[must_use]
    pub fn wait_at_most<T>(&self, time: Time) -> Flow<T> {
        Flow::Wait(Wait { wake: Some(self.since().saturating_add(time)), sleeps: false, part: self.part() })
    }

    /// The wait until `time` nanoseconds have passed since the task reached the instruction.
    #[must_use]
    pub fn sleep<T>(&self, time: Time) -> Flow<T> {
        Flow::Wait(Wait { wake: Some(self.since().saturating_add(time)), sleeps: true, part: self.part() })
    }

    /// The wait until `time` nanoseconds have passed from now on, in a part of the instruction that begins here.
    #[must_use]
    pub fn sleep_in_part<T>(&self, part: u8, time: Time) -> Flow<T> {
        Flow::Wait(Wait { wake: Some(self.now.saturating_add(time)), sleeps: true, part })
    }

    fn since(&self) -> Time {
        self.waiting.map_or(self.now, |waiting| waiting.since)
    }
}

impl<T> Reply<T> {
    /// The value, or the wait of the task.
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
