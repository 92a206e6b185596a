//! Operations.

use val3_lang::number_functions::NumberFunction;

use crate::{ContainerRef, TextOperand};

/// Number of a lane in the current frame, within the lanes of the same kind.
pub type Register = u16;

/// An operation in the code of a program.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Opcode {
    /// Operation.
    pub op: Op,
    /// Whether an instruction line begins here.
    pub mark: LineMark,
}

/// Whether an instruction line begins with an operation. The scheduler counts lines, and a turn ends between two lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LineMark {
    /// The operation belongs to the previous line.
    #[default]
    Within,
    /// The operation begins a line.
    Line,
    /// The operation begins a line before which tasks stop.
    Stop,
    /// The operation belongs to the previous line, and tasks stop before it.
    StopWithin,
    /// The operation begins a line, which is counted by the program's counter with this number.
    CountedLine(u16),
    /// The operation belongs to the previous line and begins a branch side, which is counted by the counter with this
    /// number.
    CountedSide(u16),
}

impl LineMark {
    /// Whether a line begins with the operation.
    #[must_use]
    pub const fn begins_line(self) -> bool {
        !matches!(self, Self::Within | Self::StopWithin | Self::CountedSide(_))
    }

    /// Whether a task before the operation is within a line.
    #[must_use]
    pub const fn is_within_line(self) -> bool {
        matches!(self, Self::Within | Self::CountedSide(_))
    }

    /// Whether tasks stop before the operation.
    #[must_use]
    pub const fn is_stop(self) -> bool {
        matches!(self, Self::Stop | Self::StopWithin)
    }

    /// Returns the number of the operation's counter in the program.
    #[must_use]
    pub const fn counter(self) -> Option<u16> {
        match self {
            Self::CountedLine(counter) | Self::CountedSide(counter) => Some(counter),
            Self::Within | Self::Line | Self::Stop | Self::StopWithin => None,
        }
    }
}

/// An operation. Jump targets are indexes into the program's code.
#[allow(missing_docs, reason = "the comment of each operation names its operands")]
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Op {
    /// Does nothing: for an [operation](Opcode) that only begins an instruction line.
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
    /// Jumps unless `a < b`, thus also if one operand is not a number.
    UnlessLess { a: Register, b: Register, to: u32 },
    /// Jumps unless `a <= b`, thus also if one operand is not a number.
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
    /// `to = a != b`; for truth values also `a xor b`
    NotEqual { to: Register, a: Register, b: Register },

    /// `to = function(a,b,c)`, with the errors of the instruction. Surplus operands are ignored.
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

    /// Loads a number from the first value of a container.
    LoadFirst { to: Register, container: ContainerRef, lane: u16 },
    /// Stores a number in the first value of a container.
    StoreFirst { container: ContainerRef, lane: u16, from: Register },
    /// Loads a number from an array.
    LoadElement { to: Register, container: ContainerRef, index: Register },
    /// Stores a number in an array.
    StoreElement { container: ContainerRef, index: Register, from: Register },
    /// Loads a number from a two-dimensional array.
    LoadElement2 { to: Register, container: ContainerRef, i: Register, j: Register },
    /// Stores a number in a two-dimensional array.
    StoreElement2 { container: ContainerRef, i: Register, j: Register, from: Register },

    /// Loads a number from a collection of numbers, by key.
    LoadKey { to: Register, container: ContainerRef, key: TextOperand },
    /// Stores a number in a collection of numbers, by key.
    StoreKey { container: ContainerRef, key: TextOperand, from: Register },

    /// Creates a view of a field's container, for the first value of a container.
    FirstField { to: Register, container: ContainerRef, field: u16 },
    /// Creates a view of a field's container, for an array element.
    ElementField { to: Register, container: ContainerRef, index: Register, field: u16 },
    /// Creates a view of a field's container, for the value at a place.
    Field { to: Register, place: Register, field: u16 },

    /// Looks up the first value of a container.
    LocateFirst { to: Register, container: ContainerRef },
    /// Looks up an array element.
    Locate { to: Register, container: ContainerRef, index: Register },
    /// Looks up an element in a two-dimensional array.
    Locate2 { to: Register, container: ContainerRef, i: Register, j: Register },
    /// Looks up an element in a three-dimensional array. The indexes are in three registers from `i` on.
    Locate3 { to: Register, container: ContainerRef, i: Register },
    /// Looks up the value under a key.
    LocateKey { to: Register, container: ContainerRef, key: TextOperand },
    /// Loads a number from a place.
    Load { to: Register, place: Register, lane: u16 },
    /// Stores a number at a place.
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

    /// Lets the task wait unless `condition` is true. It resumes at `retry`, where the condition is computed again.
    WaitUntil { condition: Register, retry: u32 },
    /// Sets `to` to true if `condition` is true, or to false after `seconds`. Before that the task waits and resumes at
    /// `retry`.
    Watch { to: Register, condition: Register, seconds: Register, retry: u32 },

    /// Begins a `for`: jumps to `exit` if the counter is beyond `limit`. The step is in the register after `limit`.
    ForTest { counter: Register, limit: Register, exit: u32 },
    /// Begins the next iteration of a `for`, which is also the beginning of a line: adds the step, and jumps to `body`
    /// unless the counter is beyond `limit`.
    ForNext { counter: Register, limit: Register, body: u32 },
    /// Like `ForNext`, for a step that is known to be positive.
    ForNextUp { counter: Register, limit: Register, body: u32 },
}

impl Op {
    /// Returns the target of a jump.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{assemble, disassemble};

    #[test]
    fn marks_begin_lines_and_have_counters() {
        let marks = [
            (LineMark::Within, false, None),
            (LineMark::Line, true, None),
            (LineMark::Stop, true, None),
            (LineMark::StopWithin, false, None),
            (LineMark::CountedLine(3), true, Some(3)),
            (LineMark::CountedSide(4), false, Some(4)),
        ];
        for (mark, begins_line, counter) in marks {
            assert_eq!((mark.begins_line(), mark.counter()), (begins_line, counter), "{mark:?}");
        }
    }

    /// Jumps refer to labels in the text form; an operation without a target would keep the number of the label.
    #[test]
    fn every_operation_with_a_label_has_a_target() {
        let jumps = "\
Jump far
JumpUnless n0 far
JumpIf n0 far
IfLess n0 n0 far
IfLessEqual n0 n0 far
UnlessLess n0 n0 far
UnlessLessEqual n0 n0 far
UnlessEqual n0 n0 far
IfEqual n0 n0 far
IfTextEqual t0 t0 far
UnlessTextEqual t0 t0 far
WaitUntil n0 far
Watch n0 n0 n0 far
ForTest n0 n0 far
ForNext n0 n0 far
ForNextUp n0 n0 far
";
        let mut image = assemble(&format!("program start\nframe n1/t1\n{jumps}far: Return\nend")).unwrap();
        let text = disassemble(&image);
        assert_eq!(text.matches(" L16").count(), jumps.lines().count(), "{text}");
        let (last, rest) = image.programs[0].code.split_last_mut().unwrap();
        assert_eq!(last.op.target_mut(), None);
        assert!(rest.iter_mut().all(|step| step.op.target_mut() == Some(&mut 16)), "{text}");
    }
}
