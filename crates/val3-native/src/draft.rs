//! A function in the making: its instructions so far, and its variables.

use wasm_encoder::{Encode, Function, Instruction, InstructionSink, ValType};

use crate::local::{PARAMETERS, VARIABLES};

/// A function in the making.
pub(crate) struct Draft {
    instructions: Vec<u8>,
    /// The types of its variables; their numbers follow those of its parameters.
    variables: Vec<ValType>,
}

impl Draft {
    /// A function with the variables of [`local`](crate::local), which does nothing.
    pub(crate) fn new() -> Self {
        Self { instructions: Vec::new(), variables: VARIABLES.to_vec() }
    }

    /// Behind the instructions so far.
    pub(crate) fn code(&mut self) -> InstructionSink<'_> {
        InstructionSink::new(&mut self.instructions)
    }

    /// Adds an instruction behind those so far.
    pub(crate) fn add(&mut self, instruction: &Instruction<'_>) {
        instruction.encode(&mut self.instructions);
    }

    /// A new variable.
    pub(crate) fn variable(&mut self, kind: ValType) -> u32 {
        let before = u32::try_from(self.variables.len()).unwrap_or(u32::MAX);
        self.variables.push(kind);
        before.saturating_add(PARAMETERS)
    }

    /// The function, whose last instruction is its `end`.
    pub(crate) fn finish(self) -> Function {
        let mut function = Function::new_with_locals_types(self.variables);
        function.raw(self.instructions);
        function
    }
}
