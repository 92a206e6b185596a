//! The code of one program.

use std::sync::Arc;

use val3_lang::memory::{Kind, Lanes, PartInit};
use val3_lang::types::Container;
use val3_lang::values::Text;

use crate::{CallSite, CopySite, Counters, InstructionSite, Op, Operation, TaskSite};

/// A program, ready to run.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Program {
    /// Its name.
    pub name: String,
    /// Whether other applications may call it.
    pub public: bool,
    /// Its file, by its number in [`Image::files`](crate::Image::files).
    pub file: u32,
    /// Its parameters.
    pub params: Vec<Param>,
    /// The names of its parameters and locals with their places, for debuggers.
    pub variables: Vec<Variable>,
    /// The lanes of a frame.
    pub frame: FrameSize,
    /// Bytes that a call takes from the stack that the project declares (2.1.4.2): the return, the parameters and the
    /// locals.
    pub stack_bytes: u32,
    /// The numbers of a new frame: defaults of locals, constants, and 0 for all others.
    pub nums: Vec<f64>,
    /// The containers of a new frame: local arrays, and values of user types.
    pub parts: Vec<PartInit>,
    /// Its operations.
    pub code: Vec<Operation>,
    /// Instruction lines in the order of the text.
    pub lines: Vec<SourceLine>,
    /// Text constants.
    pub texts: Vec<Text>,
    /// Copies and comparisons.
    pub copies: Vec<CopySite>,
    /// Instructions and operators.
    pub instructions: Vec<InstructionSite>,
    /// Calls.
    pub calls: Vec<CallSite>,
    /// Creations of tasks.
    pub tasks: Vec<TaskSite>,
    /// Counters of executed lines and sides of branches, if the program was compiled with them.
    pub counters: Counters,
}

/// How many lanes a frame has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct FrameSize {
    /// Numbers, texts, links and containers.
    pub lanes: Lanes,
    /// Places.
    pub places: u32,
    /// Views.
    pub views: u32,
}

/// A parameter or local.
#[derive(Debug, Clone, PartialEq)]
pub struct Variable {
    /// Its name.
    pub name: String,
    /// Its type.
    pub kind: Arc<Kind>,
    /// An element, array or collection.
    pub container: Container,
    /// Where it is in the frame.
    pub storage: Storage,
}

/// Where a parameter or local is in the frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Storage {
    /// One value of a built-in type, whose lanes begin here.
    Value(Lanes),
    /// The container with this number.
    Part(u16),
    /// A reference to a value: the place with this number.
    Place(u16),
    /// A reference to a container: the view with this number.
    View(u16),
}

/// A parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct Param {
    /// Its name.
    pub name: String,
    /// Its type.
    pub kind: Arc<Kind>,
    /// An element, array or collection.
    pub container: Container,
    /// Where it is in the frame.
    pub storage: Storage,
}

/// Bytes of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct SourceRange {
    /// The first byte.
    pub start: u32,
    /// The byte after the last.
    pub end: u32,
}

/// An instruction line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SourceLine {
    /// Its first operation.
    pub op: u32,
    /// Its range in the file.
    pub range: SourceRange,
    /// The line of the file, from 1.
    pub row: u32,
}

impl Program {
    /// Whether its frame has neither links nor containers, so that nothing has to be dropped when the program ends.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        let Lanes { link, part, .. } = self.frame.lanes;
        [link, part] == [0; 2]
    }

    /// The first line at a row of the file or after it, by its number in [`lines`](Self::lines).
    #[must_use]
    pub fn line_from(&self, row: u32) -> Option<usize> {
        let lines = self.lines.iter().enumerate().filter(|(_, line)| line.row >= row);
        lines.min_by_key(|(_, line)| (line.row, line.op)).map(|(number, _)| number)
    }

    /// The operation that begins the first line to be executed. In a program that begins with a loop, a jump leads there.
    #[must_use]
    pub fn entry(&self) -> Option<u32> {
        self.lines.first().map(|line| line.op)
    }

    /// The line that an operation belongs to, by its number in [`lines`](Self::lines).
    ///
    /// The next round of a `for` belongs to the line with its head. An operation before all lines belongs to the first one.
    #[must_use]
    pub fn line_of(&self, op: u32) -> Option<usize> {
        let op = match self.code.get(op as usize).map(|step| &step.op) {
            Some(Op::ForNext { body, .. } | Op::ForNextUp { body, .. }) => body.saturating_sub(1),
            _ => op,
        };
        let before = |(_, line): &(usize, &SourceLine)| line.op <= op;
        let last = self.lines.iter().enumerate().filter(before).max_by_key(|(_, line)| line.op);
        last.map(|(number, _)| number).or((!self.lines.is_empty()).then_some(0))
    }
}
