//! Operands of operations that have many: instructions, calls, copies.

use std::sync::Arc;

use val3_lang::call::InstructionFn;
use val3_lang::instruction::{Instruction, Overload};
use val3_lang::memory::Kind;
use val3_lang::operators::{BinaryOp, UnaryOp, handlers};
use val3_lang::statements::PRINT;
use val3_lang::types::{Arm, BaseType};

use crate::{ContainerRef, Operand, Register, Subscript, TextOperand};

/// A value is copied, or compared with another.
#[derive(Debug, Clone, PartialEq)]
pub struct CopySite {
    /// The type of both.
    pub kind: Arc<Kind>,
    /// The one that is read.
    pub from: Operand,
    /// The one that is written or compared with.
    pub to: Operand,
}

/// An argument of an instruction or program.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ArgumentSite {
    /// A value of a built-in type.
    Value(Operand, BaseType),
    /// A value of a user type.
    UserValue(Operand),
    /// A container, an array from an index on where there is one.
    View(ContainerRef, Option<Register>),
    /// A value that need not exist.
    Slot(ContainerRef, Subscript),
    /// The library identifier.
    Library(u16),
}

/// An instruction or operator with its arguments.
#[derive(Debug, Clone, PartialEq)]
pub struct InstructionSite {
    /// The instruction or operator.
    pub callee: Callee,
    /// Its function; `None` where the controller does not have it.
    pub run: Option<Handler>,
    /// Its arguments.
    pub arguments: Vec<ArgumentSite>,
    /// Where its value goes, and its type.
    pub result: Option<(Operand, BaseType)>,
}

/// The instruction or operator of a site. Its function follows from it.
#[derive(Debug, Clone, PartialEq)]
pub enum Callee {
    /// A form of an instruction.
    Form(&'static Instruction, &'static Overload),
    /// An operator between two values of a structured type, for an arm.
    Binary(BinaryOp, BaseType, Option<Arm>),
    /// An operator before a value of a structured type.
    Unary(UnaryOp, BaseType),
    /// `to = from` with an input, an output or a line; first the type of `to`.
    Assignment(BaseType, BaseType),
    /// `?`, for an arm.
    Print(Option<Arm>),
    /// The use of an item, `library:item`, that no interface declares: error 80.
    MissingItem(String),
    /// A line that is accepted but has no meaning: error 61.
    Invalid,
    /// An instruction that only an add-on has, by its name.
    Lacking(String),
}

impl Callee {
    /// Its name, for messages.
    #[must_use]
    pub fn name(&self) -> &str {
        match self {
            Self::Form(instruction, _) => instruction.name,
            Self::Binary(op, ..) => op.symbol(),
            Self::Unary(op, _) => op.symbol(),
            Self::Assignment(..) => "=",
            Self::Print(_) => PRINT,
            Self::MissingItem(name) | Self::Lacking(name) => name,
            Self::Invalid => "line",
        }
    }

    fn run(&self) -> Option<InstructionFn> {
        match self {
            Self::Form(_, form) => form.run,
            Self::Binary(op, base, arm) => handlers::binary(*op, *base, *arm),
            Self::Unary(op, base) => handlers::unary(*op, *base),
            Self::Assignment(to, from) => handlers::assignment(*to, *from),
            Self::Print(arm) => Some(handlers::print(*arm)),
            Self::MissingItem(_) => Some(handlers::missing_item),
            Self::Invalid => Some(handlers::not_executable),
            Self::Lacking(_) => None,
        }
    }
}

/// The function that executes a [`Callee`].
#[derive(Debug, Clone, Copy)]
pub struct Handler(pub InstructionFn);

/// Functions have no identity that could be compared. Handlers of equal callees are equal.
impl PartialEq for Handler {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl InstructionSite {
    /// The call of an instruction or operator, without arguments.
    #[must_use]
    pub fn new(callee: Callee) -> Self {
        let run = callee.run().map(Handler);
        Self { callee, run, arguments: Vec::new(), result: None }
    }
}

/// A program of this application or of a library.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ProgramRef {
    /// One of this application.
    Own(u16),
    /// An import.
    Import(u16),
}

/// The call of a program.
#[derive(Debug, Clone, PartialEq)]
pub struct CallSite {
    /// The program.
    pub program: ProgramRef,
    /// One argument for each parameter.
    pub arguments: Vec<ArgumentSite>,
    /// The same in a faster form, for a program of this application with a [plain](crate::Program::is_plain) frame and
    /// without arguments that are structures or of a user type.
    pub passes: Option<Vec<Pass>>,
}

/// The transfer of one argument to its parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pass {
    /// Copies a number from the frame of the caller to that of the program.
    Number(Register, Register),
    /// Copies a text to the frame of the program.
    Text(TextOperand, Register),
    /// Lets the place with this number refer to a value of the caller.
    Reference(Operand, Register),
    /// Lets the view with this number refer to a container of the caller, an array from an index on.
    Container(ContainerRef, Option<Register>, Register),
}

/// The creation of a task (5.10).
#[derive(Debug, Clone, PartialEq)]
pub struct TaskSite {
    /// Its name.
    pub name: TextOperand,
    /// The number with its priority, or its period in seconds.
    pub rate: Register,
    /// For a synchronous task, the variable that reports overruns.
    pub overrun: Option<Operand>,
    /// The program that it executes.
    pub call: CallSite,
}
