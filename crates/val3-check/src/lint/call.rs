//! Instruction calls, as used by lints.

use val3_analysis::body::ExprId;
use val3_lang::instruction::{Instruction, InstructionParam, Overload};
use val3_lang::motion::MotionRole;

/// An instruction call.
#[derive(Clone, Copy)]
pub(crate) struct Call<'db> {
    /// The entire call.
    pub(crate) id: ExprId,
    pub(crate) instruction: &'static Instruction,
    /// Form that matches the arguments.
    pub(crate) form: Option<&'static Overload>,
    /// Name of the instruction.
    pub(crate) callee: ExprId,
    pub(crate) args: &'db [ExprId],
    /// Effect on the recorded moves.
    pub(crate) role: Option<MotionRole>,
}

impl<'db> Call<'db> {
    /// Arguments with their parameters, if the form is known.
    pub(crate) fn arguments(self) -> impl Iterator<Item = (&'static InstructionParam, ExprId)> {
        let params = self.form.map_or(&[][..], |form| form.params);
        params.iter().zip(self.args.iter().copied())
    }
}
