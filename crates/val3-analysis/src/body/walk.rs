//! Ways through a body: its statements, and the parts of its expressions.

use super::{Body, Expr, ExprId, Stmt, StmtKind};

impl Body {
    /// Every statement in the order of the text, those of inner blocks included.
    pub fn stmts(&self) -> impl Iterator<Item = &Stmt> {
        let mut open: Vec<&[Stmt]> = vec![&self.block];
        std::iter::from_fn(move || {
            while let Some(block) = open.pop() {
                if let Some((first, rest)) = block.split_first() {
                    open.push(rest);
                    let inner = open.len();
                    open.extend(first.blocks());
                    open.get_mut(inner..).into_iter().for_each(<[_]>::reverse);
                    return Some(first);
                }
            }
            None
        })
    }

    /// Every list of statements: the program's own and those of inner blocks.
    pub fn blocks(&self) -> impl Iterator<Item = &[Stmt]> {
        std::iter::once(self.block.as_slice()).chain(self.stmts().flat_map(Stmt::blocks))
    }

    /// The parts of an expression, itself first.
    pub fn parts(&self, id: ExprId) -> impl Iterator<Item = ExprId> {
        let mut open = vec![id];
        std::iter::from_fn(move || {
            let id = open.pop()?;
            open.extend(self.expr(id).parts());
            Some(id)
        })
    }
}

impl Expr {
    /// The expressions it is made of.
    pub fn parts(&self) -> Vec<ExprId> {
        match self {
            Self::Missing | Self::Number(_) | Self::String(_) | Self::Bool(_) | Self::Name(_) | Self::Path { .. } => {
                Vec::new()
            }
            Self::Paren(inner) | Self::Unary(_, inner) | Self::Field { base: inner, .. } => vec![*inner],
            Self::Binary(_, left, right) | Self::Assign(left, right) => vec![*left, *right],
            Self::Index(base, parts) | Self::Call(base, parts) => {
                std::iter::once(*base).chain(parts.iter().copied()).collect()
            }
            Self::Struct(values) => values.iter().flatten().copied().collect(),
        }
    }
}

impl StmtKind {
    /// The expressions of the statement itself, without those of its blocks.
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
    use val3_syntax::view::View;

    use super::*;
    use crate::body::lower::lower;

    fn body(code: &str) -> Body {
        let text =
            format!("<Programs><Program name=\"a\"><Code><![CDATA[begin\n{code}\nend]]></Code></Program></Programs>");
        lower(View::root(val3_syntax::parse(&text).green()))
    }

    #[test]
    fn statements_come_in_the_order_of_the_text() {
        let body = body("a=1\nif b\n  c=1\nelse\n  while d\n    e=1\n  endWhile\nendIf\nf=1");
        let starts: Vec<_> = body.stmts().map(|stmt| stmt.range.start()).collect();
        assert_eq!(starts.len(), 6);
        assert!(starts.is_sorted());
        assert_eq!(body.blocks().count(), 4);
    }

    #[test]
    fn an_expression_is_walked_whole() {
        let body = body("a=f(b[1].x,-c)+{2,,3}");
        let StmtKind::Assign { value, .. } = body.block[0].kind else { panic!("an assignment") };
        assert_eq!(body.parts(value).count(), 12);
    }
}
