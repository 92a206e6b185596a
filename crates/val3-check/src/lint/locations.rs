//! Other locations of findings, in the same program and in other programs.

use val3_analysis::body::{Expr, ExprId, StmtKind};
use val3_analysis::db::FileRange;
use val3_analysis::effects::RootVariable;
use val3_analysis::items::declarations;

use super::ProgramView;

impl<'db> ProgramView<'db> {
    /// Another program of the project. The caller then depends on that program's code, so this is only for findings.
    pub(crate) fn other(&self, name: &str) -> Option<Self> {
        let file = self.items.programs.get(name)?;
        Some(Self::new(self.db, self.project, *file, self.options))
    }

    /// Expression location, for a finding in another file.
    pub(crate) fn span(&self, id: ExprId) -> FileRange {
        FileRange { file: self.file, range: self.range(id) }
    }

    /// Location of the program's first call of `callee`.
    pub(crate) fn first_call_of(&self, callee: &str) -> Option<ExprId> {
        self.stmts().iter().find_map(|stmt| {
            let StmtKind::Call(call) = stmt.kind else { return None };
            let Expr::Call(called, _) = self.body.expr(call) else { return None };
            matches!(self.body.expr(*called), Expr::Name(name) if name == callee).then_some(*called)
        })
    }

    /// Declaration location of the variable that `id` is or belongs to; `None` for a variable of a library.
    pub(crate) fn declaration(&self, id: ExprId) -> Option<FileRange> {
        match self.effects.root(id)? {
            RootVariable::Local(name) => declarations::local(self.db, self.file, name),
            RootVariable::Param(name) => declarations::param(self.db, self.file, name),
            RootVariable::Data(name) => {
                let item = self.items.data.get(&name)?;
                declarations::data(self.db, item.file, name)
            }
            RootVariable::Item(..) => None,
        }
    }
}
