//! The other places that findings point at, here and in other programs.

use val3_analysis::body::{Expr, ExprId, StmtKind};
use val3_analysis::db::FileRange;
use val3_analysis::effects::Root;
use val3_analysis::items::declarations;

use super::Program;

impl<'db> Program<'db> {
    /// Another program of the project. To look at it makes what asks depend on its code: for findings only.
    pub(crate) fn other(&self, name: &str) -> Option<Self> {
        let file = self.items.programs.get(name)?;
        Some(Self::new(self.db, self.project, *file, self.options))
    }

    /// Where an expression stands, for another file's finding.
    pub(crate) fn span(&self, id: ExprId) -> FileRange {
        FileRange { file: self.file, range: self.range(id) }
    }

    /// Where the program first calls `callee`.
    pub(crate) fn first_call_of(&self, callee: &str) -> Option<ExprId> {
        self.stmts().iter().find_map(|stmt| {
            let StmtKind::Call(call) = stmt.kind else { return None };
            let Expr::Call(called, _) = self.body.expr(call) else { return None };
            matches!(self.body.expr(*called), Expr::Name(name) if name == callee).then_some(*called)
        })
    }

    /// Where the variable is declared that `id` is or is a part of; `None` for one of a library.
    pub(crate) fn declaration(&self, id: ExprId) -> Option<FileRange> {
        match self.effects.root(id)? {
            Root::Local(name) => declarations::local(self.db, self.file, name),
            Root::Param(name) => declarations::param(self.db, self.file, name),
            Root::Data(name) => {
                let item = self.items.data.get(&name)?;
                declarations::data(self.db, item.file, name)
            }
            Root::Item(..) => None,
        }
    }
}
