//! Iteration over the blocks of a body and over the expressions of a statement.

use super::{Body, ExprId, Stmt, StmtKind};

impl Body {
    /// Returns every list of statements: the outermost block and all inner blocks.
    pub fn blocks(&self) -> impl Iterator<Item = &[Stmt]> {
        std::iter::once(self.block.as_slice()).chain(self.stmts().into_iter().flat_map(Stmt::blocks))
    }
}

impl StmtKind {
    /// Returns the expressions of the statement, without the expressions in its blocks.
    pub fn exprs(&self) -> Vec<ExprId> {
        match self {
            Self::If { arms, .. } => arms.iter().filter_map(|(condition, _)| *condition).collect(),
            Self::While { condition, .. } | Self::Do { condition, .. } => condition.iter().copied().collect(),
            Self::For { counter, start, stop, step, .. } => {
                [counter, start, stop, step].into_iter().flatten().copied().collect()
            }
            Self::Switch { selector, cases } => {
                selector.iter().chain(cases.iter().flat_map(|(values, _)| values)).copied().collect()
            }
            Self::TaskCreate { arguments, .. } => arguments.clone(),
            Self::Assign { target, value } => vec![*target, *value],
            Self::Call(id) | Self::Print(id) | Self::Expr(id) => vec![*id],
            Self::Return | Self::Error => Vec::new(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::lower_text;

    fn body(code: &str) -> Body {
        let program = format!("<Program name=\"a\"><Code><![CDATA[begin\n{code}\nend]]></Code></Program>");
        lower_text(&format!("<Programs>{program}</Programs>"))
    }

    #[test]
    fn statements_come_in_the_order_of_the_text() {
        let body = body("a=1\nif b\n  c=1\nelse\n  while d\n    e=1\n  endWhile\nendIf\nf=1");
        let starts: Vec<_> = body.stmts().iter().map(|stmt| stmt.range.start()).collect();
        assert_eq!(starts.len(), 6);
        assert!(starts.is_sorted());
        assert_eq!(body.blocks().count(), 4);
    }

    #[test]
    fn statements_have_their_own_expressions() {
        let body = body("for a=1 to 3 step 2\n  b=f(1)\nendFor\nswitch a\ncase 1,2\nbreak\nendSwitch");
        let counts: Vec<_> = body.stmts().iter().map(|stmt| stmt.kind.exprs().len()).collect();
        assert_eq!(counts, [4, 2, 3]);
    }
}
