//! Operands of operations with many operands: instructions, calls, copies.

use std::sync::Arc;

use val3_lang::call::InstructionFn;
use val3_lang::instruction::{Instruction, Overload};
use val3_lang::memory::ValueType;
use val3_lang::operators::{BinaryOp, UnaryOp, handlers};
use val3_lang::statements::PRINT;
use val3_lang::types::{Arm, BaseType};

use crate::{ContainerRef, Operand, Register, Subscript, TextOperand};

/// Operands of a copy or comparison.
#[derive(Debug, Clone, PartialEq)]
pub struct CopySite {
    /// Type of both values.
    pub kind: Arc<ValueType>,
    /// Value that is read.
    pub from: Operand,
    /// Value that is written or compared.
    pub to: Operand,
}

/// An argument to an instruction or program.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ArgumentSite {
    /// A value of a built-in type.
    Value(Operand, BaseType),
    /// A value of a user type.
    UserValue(Operand),
    /// A container, or an array from an index on.
    View(ContainerRef, Option<Register>),
    /// A value that may not exist.
    Slot(ContainerRef, Subscript),
    /// A library identifier.
    Library(u16),
}

/// An instruction or operator with its arguments.
#[derive(Debug, Clone, PartialEq)]
pub struct InstructionSite {
    /// Instruction or operator.
    pub callee: Callee,
    /// Handler; `None` if the controller does not support the instruction.
    pub run: Option<Handler>,
    /// Arguments.
    pub arguments: Vec<ArgumentSite>,
    /// Location and type of the result.
    pub result: Option<(Operand, BaseType)>,
}

/// Instruction or operator of a site. It determines the handler.
#[derive(Debug, Clone, PartialEq)]
pub enum Callee {
    /// An instruction form.
    Form(&'static Instruction, &'static Overload),
    /// A binary operator on a structured type, for an arm.
    Binary(BinaryOp, BaseType, Option<Arm>),
    /// A unary operator on a structured type.
    Unary(UnaryOp, BaseType),
    /// `to = from` with an input, an output or a channel; the first type is the type of `to`.
    Assignment(BaseType, BaseType),
    /// `?`, for an arm.
    Print(Option<Arm>),
    /// A used item, `library:item`, that no interface declares: error 80.
    MissingItem(String),
    /// A line that is accepted but has no meaning: error 61.
    Invalid,
    /// An instruction that only an add-on provides, by name.
    Lacking(String),
}

impl Callee {
    /// Returns the name, for messages.
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

/// Handler of a [`Callee`].
#[derive(Debug, Clone, Copy)]
pub struct Handler(pub InstructionFn);

/// Always equal, because functions cannot be compared, and equal callees have equal handlers.
impl PartialEq for Handler {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl InstructionSite {
    /// Creates an instruction or operator call without arguments.
    #[must_use]
    pub fn new(callee: Callee) -> Self {
        let run = callee.run().map(Handler);
        Self { callee, run, arguments: Vec::new(), result: None }
    }
}

/// A program of this application or of a library.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ProgramRef {
    /// A program in this application, by number.
    Own(u16),
    /// An import, by number.
    Import(u16),
}

/// Call of a program.
#[derive(Debug, Clone, PartialEq)]
pub struct CallSite {
    /// Program.
    pub program: ProgramRef,
    /// Arguments, one for each parameter.
    pub arguments: Vec<ArgumentSite>,
    /// Fast form of the arguments. It exists for a program of this application with a [plain](crate::Program::is_plain)
    /// frame, if no argument is a structure or of a user type.
    pub passes: Option<Vec<Pass>>,
}

/// Passes one argument to its parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pass {
    /// Copies a number from the caller's frame to the program's frame.
    Number(Register, Register),
    /// Copies a string to the program's frame.
    Text(TextOperand, Register),
    /// Makes the place with this number refer to a value of the caller.
    Reference(Operand, Register),
    /// Makes the view with this number refer to a container of the caller, or to an array from an index on.
    Container(ContainerRef, Option<Register>, Register),
}

/// Creation of a task (5.10).
#[derive(Debug, Clone, PartialEq)]
pub struct TaskSite {
    /// Task name.
    pub name: TextOperand,
    /// Register with the priority, or with the period in s.
    pub rate: Register,
    /// Variable that reports overruns of a synchronous task.
    pub overrun: Option<Operand>,
    /// Program of the task.
    pub call: CallSite,
}

#[cfg(test)]
mod tests {
    use val3_lang::instructions;

    use super::*;

    #[test]
    fn callees_have_names_for_messages_and_handlers() {
        let print = instructions::find("sin").unwrap();
        for (callee, name, has_handler) in [
            (Callee::Form(print, &print.overloads[0]), "sin", true),
            (Callee::Binary(BinaryOp::from_symbol("*").unwrap(), BaseType::Trsf, None), "*", true),
            (Callee::Unary(UnaryOp::Not, BaseType::Trsf), "!", true),
            (Callee::Assignment(BaseType::Bool, BaseType::Dio), "=", true),
            (Callee::Print(None), "?", true),
            (Callee::MissingItem("part:gone".to_owned()), "part:gone", true),
            (Callee::Invalid, "line", true),
            (Callee::Lacking("$odd".to_owned()), "$odd", false),
        ] {
            assert_eq!(callee.name(), name);
            let site = InstructionSite::new(callee);
            assert_eq!((site.run.is_some(), site.arguments.len(), site.result), (has_handler, 0, None), "{name}");
        }
    }

    #[test]
    fn only_callees_tell_sites_apart() {
        let (missing, invalid) = (Callee::MissingItem("a".to_owned()), Callee::Invalid);
        assert_ne!(InstructionSite::new(missing.clone()), InstructionSite::new(invalid.clone()));
        assert_eq!(InstructionSite::new(missing).run, InstructionSite::new(invalid).run);
    }
}
