//! Code that is executed in the stack frame of a program.

use std::sync::Arc;

use val3_lang::memory::ValueType;

use crate::{ArgumentSite, LineMark, Op, Operand, Program};

/// An expression or statements that can use the parameters and locals of a program.
#[derive(Debug, Clone, PartialEq)]
pub struct Fragment {
    /// Code. Its variables are the variables of the other program, in the same order, all by reference.
    pub program: Arc<Program>,
    /// Value if the fragment is an expression; `None` for statements.
    pub value: Option<FragmentValue>,
}

/// An expression's value. It can be read while the code is at the last operation.
#[derive(Debug, Clone, PartialEq)]
pub struct FragmentValue {
    /// Operand with the value.
    pub site: ArgumentSite,
    /// Type.
    pub kind: Arc<ValueType>,
}

impl FragmentValue {
    /// Whether the value is computed into the fragment's frame. All variables are references to other places.
    #[must_use]
    pub fn is_result(&self) -> bool {
        matches!(self.site, ArgumentSite::Value(Operand::Frame(_), _))
    }
}

impl Fragment {
    /// Creates a fragment of statements.
    #[must_use]
    pub fn statements(program: Program) -> Self {
        Self { program: Arc::new(program), value: None }
    }

    /// Creates a fragment for an expression. The task stops before the last operation, where the value can be read.
    #[must_use]
    pub fn expression(mut program: Program, value: FragmentValue) -> Self {
        if let Some(last) = program.code.last_mut().filter(|last| last.op == Op::Return) {
            last.mark = LineMark::Stop;
        }
        Self { program: Arc::new(program), value: Some(value) }
    }

    /// Returns the last operation.
    #[must_use]
    pub fn end(&self) -> u32 {
        u32::try_from(self.program.code.len()).unwrap_or(u32::MAX).saturating_sub(1)
    }
}
