//! Existence of each step of a path, for `isDefined(tX[9].nV[0])`: if `tX[9]` does not exist, the result is `false`.

use val3_analysis::body::{Expr, ExprId};
use val3_bytecode::{ArgumentSite, ContainerKind, InstructionSite, Op, Register, Subscript};

use crate::code::Label;
use crate::error::Result;
use crate::expressions::Expressions;
use crate::location::ValueLocator;

/// Test of each step of a path before the next step is looked up.
#[derive(Debug, Clone)]
pub(crate) struct StepTest {
    /// The instruction that returns whether a value exists, with its result and without arguments.
    pub(crate) site: InstructionSite,
    /// Register of the result.
    pub(crate) condition: Register,
    /// End of the instruction.
    pub(crate) end: Label,
}

impl Expressions<'_, '_> {
    /// Whether the path of a value has steps before the last index or key.
    pub(crate) fn has_steps(&self, id: ExprId) -> bool {
        match self.body.expr(id) {
            Expr::Paren(of) | Expr::Index(of, _) => self.has_steps(*of),
            Expr::Field { .. } => true,
            _ => false,
        }
    }

    /// Compiles with a test of each step.
    pub(crate) fn with_steps<T>(
        &mut self,
        test: Option<StepTest>,
        compile: impl FnOnce(&mut Self) -> Result<T>,
    ) -> Result<T> {
        let before = std::mem::replace(&mut self.steps, test);
        let compiled = compile(self);
        self.steps = before;
        compiled
    }

    /// Tests whether the value exists, if the present path is tested.
    pub(crate) fn test_step(&mut self, location: ValueLocator) -> Result<()> {
        let Some(StepTest { mut site, condition, end }) = self.steps.clone() else { return Ok(()) };
        let (container, at) = match location {
            ValueLocator::Element { container, at, .. } => (container, self.slot_key(at)?),
            ValueLocator::First(container, _) if matches!(container.kind(), ContainerKind::Import(_)) => {
                (container, Subscript::Whole)
            }
            // Other values exist whenever the line is executed.
            _ => return Ok(()),
        };
        site.arguments = vec![ArgumentSite::Slot(container, at)];
        self.out.code().instruction(site);
        self.out.emit(Op::JumpUnless { condition, to: end.0 });
        Ok(())
    }
}
