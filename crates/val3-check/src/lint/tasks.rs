//! Calls of programs, and the statements that create tasks.

use smol_str::SmolStr;
use val3_analysis::body::{Expr, ExprId, StmtKind};
use val3_analysis::db::FileRange;
use val3_analysis::items::declarations;
use val3_analysis::items::project::{Signature, SignatureParam};

use super::ProgramView;

/// A `taskCreate` or `taskCreateSync`.
pub(crate) struct TaskCreation<'db> {
    /// Name of the task.
    pub(crate) name: ExprId,
    /// Priority, or period of a synchronous task.
    pub(crate) pace: ExprId,
    /// Variable that receives the overrun of a synchronous task.
    pub(crate) overrun: Option<ExprId>,
    /// Program of the task, and its arguments.
    pub(crate) call: ProgramCall<'db>,
}

/// A call of a program.
pub(crate) struct ProgramCall<'db> {
    /// Name of the program.
    callee: ExprId,
    /// The arguments.
    args: &'db [ExprId],
    /// Parameters, if known.
    signature: Option<&'db Signature>,
}

impl<'db> ProgramCall<'db> {
    /// Arguments with their parameters, if the parameters are known.
    pub(crate) fn arguments(&self) -> impl Iterator<Item = (&'db SignatureParam, ExprId)> {
        let params = self.signature.map_or(&[][..], |signature| &signature.params);
        params.iter().zip(self.args.iter().copied())
    }
}

impl TaskCreation<'_> {
    pub(crate) fn is_synchronous(&self) -> bool {
        self.overrun.is_some()
    }
}

impl<'db> ProgramView<'db> {
    /// All statements that create a task, in text order.
    pub(crate) fn task_creations(&self) -> impl Iterator<Item = TaskCreation<'db>> {
        let statements = self.stmts().iter().copied().filter_map(|stmt| match &stmt.kind {
            StmtKind::TaskCreate { arguments, .. } => Some(arguments.as_slice()),
            _ => None,
        });
        statements.filter_map(|arguments| self.task_creation(arguments))
    }

    fn task_creation(&self, arguments: &[ExprId]) -> Option<TaskCreation<'db>> {
        let (name, pace, overrun, call) = match *arguments {
            [name, priority, call] => (name, priority, None, call),
            [name, period, overrun, call] => (name, period, Some(overrun), call),
            _ => return None,
        };
        Some(TaskCreation { name, pace, overrun, call: self.program_call(call)? })
    }

    /// Program call in a `call` or a task statement.
    pub(crate) fn program_call(&self, call: ExprId) -> Option<ProgramCall<'db>> {
        let Expr::Call(callee, args) = self.body.expr(call) else { return None };
        Some(ProgramCall { callee: *callee, args, signature: self.effects.program(*callee) })
    }

    /// Location at which the called program declares its parameter `name`.
    pub(crate) fn parameter(&self, call: &ProgramCall<'_>, name: &SmolStr) -> Option<FileRange> {
        let (_, file) = self.effects.program_file(call.callee)?;
        declarations::param(self.db, file, name.clone())
    }
}
