//! What operations with many operands refer to.

use std::borrow::Cow;
use std::sync::Arc;

use val3_lang::call::Run;
use val3_lang::instruction::{Instruction, Overload};
use val3_lang::memory::{Kind, Lanes};
use val3_lang::types::BaseType;

use crate::{Register, Whole};

/// Where a value is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Operand {
    /// On the frame.
    Frame(Lanes),
    /// Behind a place that was looked up, or a parameter by reference.
    Place(Register, Lanes),
}

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
    View(Whole, Option<Register>),
    /// A place that need not exist.
    Slot(Whole, SlotSite),
    /// The library identifier.
    Library(u16),
}

/// Index or key of a place that need not exist.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SlotSite {
    /// The whole variable.
    Whole,
    /// So many indexes, one behind the other.
    Index(Register, u8),
    /// A key.
    Key(Register),
}

/// An instruction with its arguments.
#[derive(Debug, Clone, PartialEq)]
pub struct InstructionSite {
    /// Its name, for messages.
    pub name: Cow<'static, str>,
    /// What it does; `None` where the controller does not have it.
    pub run: Option<Handler>,
    /// Its arguments.
    pub arguments: Vec<ArgumentSite>,
    /// Where its value goes, and its type.
    pub result: Option<(Operand, BaseType)>,
}

/// The function behind a form of an instruction, or behind an operator on structured values.
#[derive(Debug, Clone, Copy)]
pub struct Handler(pub Run);

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

    /// What a name of no form stands for: an operator, or an instruction that only an add-on has.
    #[must_use]
    pub fn named(name: impl Into<Cow<'static, str>>, run: Option<Run>) -> Self {
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
    /// The same, where it is quick: the program is one of this application, its frame is
    /// [plain](crate::Program::is_plain), and all arguments are numbers on the frame or references.
    pub passes: Option<Vec<Pass>>,
}

/// What a call does for one parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pass {
    /// Copies a number from the frame of the caller to that of the program.
    Number(Register, Register),
    /// Lets the place with this number refer to a value of the caller.
    Reference(Operand, u32),
}

/// The creation of a task (5.10).
#[derive(Debug, Clone, PartialEq)]
pub struct TaskSite {
    /// The text with its name.
    pub name: Register,
    /// The number with its priority, or its period in seconds.
    pub rate: Register,
    /// Of a synchronous task, the variable that tells of overruns.
    pub overrun: Option<Operand>,
    /// What it executes.
    pub call: CallSite,
}
