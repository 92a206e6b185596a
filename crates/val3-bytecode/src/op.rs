//! The operations.

use val3_lang::number_functions::NumberFunction;

use crate::{ContainerRef, TextOperand};

/// A lane of the current frame, by its number among those of its sort.
pub type Register = u16;

/// An operation in the code of a program.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Operation {
    /// The operation.
    pub op: Op,
    /// Whether an instruction line begins with it.
    pub mark: LineMark,
}

/// Whether an instruction line begins with an operation. The scheduler counts lines, and a turn ends between two of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LineMark {
    /// It belongs to the line before it.
    #[default]
    Within,
    /// A line begins with it.
    Line,
    /// A line begins with it, before which a task stops.
    Stop,
    /// The operation begins a line, which the counter of the program with this number counts.
    CountedLine(u16),
    /// The operation belongs to the line before it. It begins a side of a branch, which the counter with this number counts.
    CountedSide(u16),
}

impl LineMark {
    /// Whether a line begins with the operation.
    #[must_use]
    pub const fn begins_line(self) -> bool {
        !matches!(self, Self::Within | Self::CountedSide(_))
    }

    /// The counter of the operation, by its number among those of the program.
    #[must_use]
    pub const fn counter(self) -> Option<u16> {
        match self {
            Self::CountedLine(counter) | Self::CountedSide(counter) => Some(counter),
            Self::Within | Self::Line | Self::Stop => None,
        }
    }
}

/// One operation. Targets of jumps are indexes into the code of the program.
#[allow(missing_docs, reason = "the comment of each operation names its operands")]
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Op {
    /// Does nothing: for an [operation](Operation) that only begins an instruction line.
    Line,
    /// Jumps.
    Jump { to: u32 },
    /// Jumps if `condition` is false.
    JumpUnless { condition: Register, to: u32 },
    /// Jumps if `condition` is true.
    JumpIf { condition: Register, to: u32 },
    /// Jumps if `a < b`.
    IfLess { a: Register, b: Register, to: u32 },
    /// Jumps if `a <= b`.
    IfLessEqual { a: Register, b: Register, to: u32 },
    /// Jumps unless `a < b`, thus also if one of them is not a number.
    UnlessLess { a: Register, b: Register, to: u32 },
    /// Jumps unless `a <= b`, thus also if one of them is not a number.
    UnlessLessEqual { a: Register, b: Register, to: u32 },
    /// Jumps unless `a == b`.
    UnlessEqual { a: Register, b: Register, to: u32 },
    /// Jumps if `a == b`.
    IfEqual { a: Register, b: Register, to: u32 },

    /// `to = from`
    Move { to: Register, from: Register },
    /// `to = a + b`
    Add { to: Register, a: Register, b: Register },
    /// `to = a - b`
    Subtract { to: Register, a: Register, b: Register },
    /// `to = a * b`
    Multiply { to: Register, a: Register, b: Register },
    /// `to = a / b`; error 10 if `b` is 0.
    Divide { to: Register, a: Register, b: Register },
    /// `to = a % b`; error 10 if `b` is 0.
    Remainder { to: Register, a: Register, b: Register },
    /// `to = -a`
    Negate { to: Register, a: Register },
    /// `to = !a`
    Not { to: Register, a: Register },
    /// `to = a < b`
    Less { to: Register, a: Register, b: Register },
    /// `to = a <= b`
    LessEqual { to: Register, a: Register, b: Register },
    /// `to = a == b`
    Equal { to: Register, a: Register, b: Register },
    /// `to = a != b`, on truth values also `a xor b`
    NotEqual { to: Register, a: Register, b: Register },

    /// `to = function(a,b,c)` with the errors of the instruction. Operands that the function lacks are ignored.
    Function { function: NumberFunction, to: Register, a: Register, b: Register, c: Register },

    /// `to = from`
    TextMove { to: TextOperand, from: TextOperand },
    /// `to = a + b`
    Concatenate { to: TextOperand, a: TextOperand, b: TextOperand },
    /// `to = a == b`
    TextEqual { to: Register, a: TextOperand, b: TextOperand },
    /// Jumps if `a == b`.
    IfTextEqual { a: TextOperand, b: TextOperand, to: u32 },
    /// Jumps unless `a == b`.
    UnlessTextEqual { a: TextOperand, b: TextOperand, to: u32 },

    /// A number of the first value of a container.
    LoadFirst { to: Register, container: ContainerRef, lane: u16 },
    /// Writes a number of the first value of a container.
    StoreFirst { container: ContainerRef, lane: u16, from: Register },
    /// A number of an array.
    LoadElement { to: Register, container: ContainerRef, index: Register },
    /// Writes a number of an array.
    StoreElement { container: ContainerRef, index: Register, from: Register },
    /// A number of an array of two dimensions.
    LoadElement2 { to: Register, container: ContainerRef, i: Register, j: Register },
    /// Writes a number of an array of two dimensions.
    StoreElement2 { container: ContainerRef, i: Register, j: Register, from: Register },

    /// A number of a collection of numbers.
    LoadKey { to: Register, container: ContainerRef, key: TextOperand },
    /// Writes a number of a collection of numbers.
    StoreKey { container: ContainerRef, key: TextOperand, from: Register },

    /// The container of a field of the first value of a container, as a view.
    FirstField { to: Register, container: ContainerRef, field: u16 },
    /// The container of a field of a value of an array, as a view.
    ElementField { to: Register, container: ContainerRef, index: Register, field: u16 },
    /// The container of a field of a value at a place, as a view.
    Field { to: Register, place: Register, field: u16 },

    /// Looks up the first value of a container.
    LocateFirst { to: Register, container: ContainerRef },
    /// Looks up a value of an array.
    Locate { to: Register, container: ContainerRef, index: Register },
    /// Looks up a value of an array of two dimensions.
    Locate2 { to: Register, container: ContainerRef, i: Register, j: Register },
    /// Looks up a value of an array of three dimensions. The indexes are in three registers from `i` on.
    Locate3 { to: Register, container: ContainerRef, i: Register },
    /// Looks up the value under a key.
    LocateKey { to: Register, container: ContainerRef, key: TextOperand },
    /// A number at a place.
    Load { to: Register, place: Register, lane: u16 },
    /// Writes a number at a place.
    Store { place: Register, lane: u16, from: Register },

    /// Copies a value: [`CopySite`](crate::CopySite).
    Copy { site: u32 },
    /// Compares two values: [`CopySite`](crate::CopySite).
    Compare { to: Register, site: u32 },
    /// Executes an instruction: [`InstructionSite`](crate::InstructionSite).
    Instruction { site: u32 },
    /// Calls a program: [`CallSite`](crate::CallSite).
    Call { site: u32 },
    /// Ends the program.
    Return,
    /// Creates a task: [`TaskSite`](crate::TaskSite).
    CreateTask { site: u32 },

    /// The task waits unless `condition` is true. It resumes at `retry`, where the condition is computed again.
    WaitUntil { condition: Register, retry: u32 },
    /// `to` becomes true when `condition` is, and false when `seconds` have passed. Until then the task waits and
    /// resumes at `retry`.
    Watch { to: Register, condition: Register, seconds: Register, retry: u32 },

    /// Begins a `for`: goes to `exit` if the counter is beyond `limit`; the step is in the register after `limit`.
    ForTest { counter: Register, limit: Register, exit: u32 },
    /// The next round of a `for`, which begins a line: adds the step and goes to `body` unless the counter is beyond
    /// `limit`.
    ForNext { counter: Register, limit: Register, body: u32 },
    /// As `ForNext`, for a step that is known to be above 0.
    ForNextUp { counter: Register, limit: Register, body: u32 },
}

impl Op {
    /// The target of a jump.
    pub fn target_mut(&mut self) -> Option<&mut u32> {
        match self {
            Self::Jump { to }
            | Self::JumpUnless { to, .. }
            | Self::JumpIf { to, .. }
            | Self::IfLess { to, .. }
            | Self::IfLessEqual { to, .. }
            | Self::UnlessLess { to, .. }
            | Self::UnlessLessEqual { to, .. }
            | Self::UnlessEqual { to, .. }
            | Self::IfEqual { to, .. }
            | Self::IfTextEqual { to, .. }
            | Self::UnlessTextEqual { to, .. }
            | Self::WaitUntil { retry: to, .. }
            | Self::Watch { retry: to, .. }
            | Self::ForTest { exit: to, .. }
            | Self::ForNext { body: to, .. }
            | Self::ForNextUp { body: to, .. } => Some(to),
            _ => None,
        }
    }
}
