//! Operands of operations that have many: instructions, calls, copies.

use std::borrow::Cow;
use std::sync::Arc;

use val3_lang::call::InstructionFn;
use val3_lang::instruction::{Instruction, Overload};
use val3_lang::memory::Kind;
use val3_lang::types::BaseType;

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

/// An instruction with its arguments.
#[derive(Debug, Clone, PartialEq)]
pub struct InstructionSite {
    /// Its name, for messages.
    pub name: Cow<'static, str>,
    /// Its function; `None` where the controller does not have it.
    pub run: Option<Handler>,
    /// Its arguments.
    pub arguments: Vec<ArgumentSite>,
    /// Where its value goes, and its type.
    pub result: Option<(Operand, BaseType)>,
}

/// The function that executes a form of an instruction, or an operator on structured values.
#[derive(Debug, Clone, Copy)]
pub struct Handler(pub InstructionFn);

/// Functions have no identity that could be compared: sites with handlers count as equal.
impl PartialEq for Handler {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl InstructionSite {
    /// The call of a form.
    #[must_use]
    pub fn new(instruction: &'static Instruction, form: &'static Overload) -> Self {
        Self { name: instruction.name.into(), run: form.run.map(Handler), arguments: Vec::new(), result: None }
    }

    /// The call of a name without a form: an operator, or an instruction that only an add-on has.
    #[must_use]
    pub fn named(name: impl Into<Cow<'static, str>>, run: Option<InstructionFn>) -> Self {
        Self { name: name.into(), run: run.map(Handler), arguments: Vec::new(), result: None }
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
