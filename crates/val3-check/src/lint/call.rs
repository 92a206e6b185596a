//! The call of an instruction as lints see it.

use val3_analysis::body::ExprId;
use val3_lang::instruction::{Instruction, Overload, Param};
use val3_lang::motion::MotionRole;

/// A call of an instruction.
#[derive(Clone, Copy)]
pub(crate) struct Call<'db> {
    /// The whole call.
    pub(crate) id: ExprId,
    pub(crate) instruction: &'static Instruction,
    /// The form that matches the arguments.
    pub(crate) form: Option<&'static Overload>,
    /// The name of the instruction.
    pub(crate) callee: ExprId,
    pub(crate) args: &'db [ExprId],
    /// Its effect on the recorded moves.
    pub(crate) role: Option<MotionRole>,
}

impl<'db> Call<'db> {
    /// The arguments with their parameters, if the form is known.
    pub(crate) fn arguments(self) -> impl Iterator<Item = (&'static Param, ExprId)> {
        let params = self.form.map_or(&[][..], |form| form.params);
        params.iter().zip(self.args.iter().copied())
    }
}
