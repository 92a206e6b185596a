//! A call of an instruction at run time: its arguments, and what it may reach.
//!
//! The handler of a form is a plain function whose parameters are the types of its syntax line ([`Take`]) and whose
//! value is that of the line ([`Give`]). It reaches data through the memory and everything else through [`Ports`] and
//! [`Tasks`]. An instruction that has to wait is called again in each turn of its task until it is done.

mod give;
mod take;

pub use give::{Give, Outcome, PointValue};
pub use take::{
    Any, Arr, ConfigValue, FrameRef, IoRef, LibraryRef, MdescValue, PointRef, ScreenRef, Stored, Take, ToolRef, Var,
};

use crate::fault::{Fault, Result};
use crate::memory::{Memory, Place, Slot, View};
use crate::ports::{Ports, Tasks, Time};
use crate::types::BaseType;

/// Executes one form of an instruction.
pub type Run = fn(&mut Call<'_>) -> Result<Flow>;

/// Whether an instruction is done.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Flow<T = ()> {
    /// It is.
    Done(T),
    /// The task has to wait: the instruction is called again in its next turn.
    Wait(Wait),
}

/// What a task waits for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Wait {
    /// When time alone ends the wait; `None` where only the doing of others does.
    pub wake: Option<Time>,
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
    /// When the task reached this line.
    pub since: Time,
    /// The application is of s8 or later: some limits of the manual do not hold.
    pub unlimited: bool,
    arguments: &'c [Argument],
    next: usize,
    result: Option<Place>,
}

impl<'c> Call<'c> {
    /// A call with these arguments, whose value goes to `result`.
    pub fn new(
        (memory, ports, tasks): (&'c mut Memory, &'c mut dyn Ports, &'c mut dyn Tasks),
        (since, unlimited): (Time, bool),
        arguments: &'c [Argument],
        result: Option<Place>,
    ) -> Self {
        Self { memory, ports, tasks, since, unlimited, arguments, next: 0, result }
    }

    /// The next argument.
    ///
    /// # Errors
    /// 61 if there is none: the program was compiled wrongly.
    pub fn argument(&mut self) -> Result<Argument> {
        let found = self.arguments.get(self.next).copied().ok_or(Fault::INTERPRETER)?;
        self.next += 1;
        Ok(found)
    }

    /// Where the value of the instruction goes; `None` where the program drops it.
    #[must_use]
    pub fn result(&self) -> Option<Place> {
        self.result
    }

    /// How long the task has been at this line.
    pub fn waited(&mut self) -> Time {
        self.ports.now().saturating_sub(self.since)
    }
}

impl std::fmt::Debug for Call<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Call").field("arguments", &self.arguments).finish_non_exhaustive()
    }
}
