//! Code that is executed in the frame of a program.

use std::sync::Arc;

use val3_lang::memory::Kind;

use crate::{ArgumentSite, LineMark, Op, Operand, Program};

/// An expression or statements that see the parameters and locals of a program.
#[derive(Debug, Clone, PartialEq)]
pub struct Fragment {
    /// The code. Its variables are those of the other program, in the same order, each by reference.
    pub program: Arc<Program>,
    /// The value of an expression; `None` for statements.
    pub value: Option<FragmentValue>,
}

/// The value of an expression. It can be read while the code is at its last operation.
#[derive(Debug, Clone, PartialEq)]
pub struct FragmentValue {
    /// Where it is.
    pub site: ArgumentSite,
    /// Its type.
    pub kind: Arc<Kind>,
}

impl FragmentValue {
    /// Whether it is computed into the frame of the fragment. All variables are references to other places.
    #[must_use]
    pub fn is_result(&self) -> bool {
        matches!(self.site, ArgumentSite::Value(Operand::Frame(_), _))
    }
}

impl Fragment {
    /// Statements.
    #[must_use]
    pub fn statements(program: Program) -> Self {
        Self { program: Arc::new(program), value: None }
    }

    /// An expression. The task stops before the last operation, where the value can be read.
    #[must_use]
    pub fn expression(mut program: Program, value: FragmentValue) -> Self {
        if let Some(last) = program.code.last_mut().filter(|last| last.op == Op::Return) {
            last.mark = LineMark::Stop;
        }
        Self { program: Arc::new(program), value: Some(value) }
    }

    /// The last operation.
    #[must_use]
    pub fn end(&self) -> u32 {
        u32::try_from(self.program.code.len()).unwrap_or(u32::MAX).saturating_sub(1)
    }
}
