//! The operations.

use val3_lang::number_functions::NumberFunction;

/// A lane of the current frame, by its number among those of its sort; or a number in a table of the program.
pub type Register = u16;

/// A container that an operation works on: its kind in the upper bits, its number in the others.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Whole(u16);

impl std::fmt::Debug for Whole {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.kind().fmt(f)
    }
}

/// Where a container is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WholeKind {
    /// Global data of the application.
    Data(u16),
    /// A container of the frame: a local array or local of a user type.
    Part(u16),
    /// A container by reference.
    View(u16),
    /// Data of a library.
    Import(u16),
    /// `world` (0) or `flange` (1).
    Builtin(u16),
}

impl Whole {
    const BITS: u16 = 13;
    const MASK: u16 = (1 << Self::BITS) - 1;

    /// Packs a container; `None` where its number is beyond 8,191.
    #[must_use]
    pub fn new(kind: WholeKind) -> Option<Self> {
        let (tag, number) = match kind {
            WholeKind::Data(number) => (0, number),
            WholeKind::Part(number) => (1, number),
            WholeKind::View(number) => (2, number),
            WholeKind::Import(number) => (3, number),
            WholeKind::Builtin(number) => (4, number),
        };
        (number <= Self::MASK).then_some(Self(tag << Self::BITS | number))
    }

    /// Its number among the global data of the application, if it is one of them: what most are.
    #[inline]
    #[must_use]
    pub fn data(self) -> Option<u16> {
        // The tag of data is 0.
        (self.0 <= Self::MASK).then_some(self.0)
    }

    /// Where it is found.
    #[inline]
    #[must_use]
    pub fn kind(self) -> WholeKind {
        let number = self.0 & Self::MASK;
        match self.0 >> Self::BITS {
            0 => WholeKind::Data(number),
            1 => WholeKind::Part(number),
            2 => WholeKind::View(number),
            3 => WholeKind::Import(number),
            _ => WholeKind::Builtin(number),
        }
    }
}

/// One operation, and whether an instruction line begins with it: what the scheduler counts, and where the task stops
/// for others.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step {
    /// What it does.
    pub op: Op,
    /// A line begins.
    pub line: bool,
}

/// One operation. Targets of jumps are numbers of steps in the program.
#[allow(missing_docs, reason = "the line above each tells its operands")]
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Op {
    /// Does nothing: for a [step](Step) that does no more than begin an instruction line.
    Line,
    /// Goes on elsewhere.
    Jump { to: u32 },
    /// Goes on elsewhere if `condition` is false.
    JumpUnless { condition: Register, to: u32 },
    /// Goes on elsewhere if `condition` is true.
    JumpIf { condition: Register, to: u32 },
    /// Goes on elsewhere if `a < b`.
    IfLess { a: Register, b: Register, to: u32 },
    /// Goes on elsewhere if `a <= b`.
    IfLessEqual { a: Register, b: Register, to: u32 },
    /// Goes on elsewhere unless `a < b`; it goes there if one of them is no number.
    UnlessLess { a: Register, b: Register, to: u32 },
    /// Goes on elsewhere unless `a <= b`; it goes there if one of them is no number.
    UnlessLessEqual { a: Register, b: Register, to: u32 },
    /// Goes on elsewhere unless `a == b`.
    UnlessEqual { a: Register, b: Register, to: u32 },
    /// Goes on elsewhere if `a == b`.
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

    /// `to = function(a,b,c)`; those that the function does not have may be any. Its errors are those of the instruction.
    Function { function: NumberFunction, to: Register, a: Register, b: Register, c: Register },

    /// A text of the program's table.
    TextConstant { to: Register, constant: Register },
    /// `to = from`
    TextMove { to: Register, from: Register },
    /// `to = a + b`
    Concatenate { to: Register, a: Register, b: Register },
    /// `to = a == b`
    TextEqual { to: Register, a: Register, b: Register },

    /// A number of the first value of a container.
    LoadFirst { to: Register, whole: Whole, lane: u16 },
    /// Writes a number of the first value of a container.
    StoreFirst { whole: Whole, lane: u16, from: Register },
    /// A number of an array.
    LoadElement { to: Register, whole: Whole, index: Register },
    /// Writes a number of an array.
    StoreElement { whole: Whole, index: Register, from: Register },
    /// A number of an array of two dimensions.
    LoadElement2 { to: Register, whole: Whole, i: Register, j: Register },
    /// Writes a number of an array of two dimensions.
    StoreElement2 { whole: Whole, i: Register, j: Register, from: Register },

    /// Looks up the first value of a container.
    LocateFirst { to: Register, whole: Whole },
    /// Looks up a value of an array.
    Locate { to: Register, whole: Whole, index: Register },
    /// Looks up a value of an array of two dimensions.
    Locate2 { to: Register, whole: Whole, i: Register, j: Register },
    /// Looks up a value of an array of three dimensions; the indexes follow one another from `i` on.
    Locate3 { to: Register, whole: Whole, i: Register },
    /// Looks up the value under a key.
    LocateKey { to: Register, whole: Whole, key: Register },
    /// The container of a field of a value of a user type.
    Field { to: Register, place: Register, field: u16 },
    /// A number at a place.
    Load { to: Register, place: Register, lane: u16 },
    /// Writes a number at a place.
    Store { place: Register, lane: u16, from: Register },
    /// A text at a place.
    LoadText { to: Register, place: Register },
    /// Writes a text at a place.
    StoreText { place: Register, from: Register },

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

    /// The task waits unless `condition` is true; it goes on at `retry`, where the condition is computed anew.
    WaitUntil { condition: Register, retry: u32 },
    /// `to` becomes true when `condition` is, and false when `seconds` have passed; until then the task waits and goes
    /// on at `retry`.
    Watch { to: Register, condition: Register, seconds: Register, retry: u32 },

    /// Begins a `for`: goes to `exit` if the counter is beyond `limit`; the step is the lane behind `limit`.
    ForTest { counter: Register, limit: Register, exit: u32 },
    /// The next round of a `for`, which begins a line: adds the step and goes to `body` unless the counter is beyond
    /// `limit`.
    ForNext { counter: Register, limit: Register, body: u32 },
    /// As `ForNext`, where the step is known to be above 0.
    ForNextUp { counter: Register, limit: Register, body: u32 },
}

impl Op {
    /// Where the operation may go on instead of at the next one.
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
    use super::{Whole, WholeKind};

    #[test]
    fn containers_are_packed() {
        let last = [WholeKind::Data(8_191), WholeKind::Part(8_191), WholeKind::View(8_191), WholeKind::Import(8_191)];
        for kind in last.into_iter().chain([WholeKind::Data(0), WholeKind::Builtin(1)]) {
            assert_eq!(Whole::new(kind).map(Whole::kind), Some(kind));
            let number = if let WholeKind::Data(number) = kind { Some(number) } else { None };
            assert_eq!(Whole::new(kind).and_then(Whole::data), number);
        }
        assert_eq!(Whole::new(WholeKind::Data(8_192)), None);
    }
}
