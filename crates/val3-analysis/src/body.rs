//! Code of a program as plain data: statements and expressions without trivia.

pub(crate) mod constant;
mod lower;
mod same;
mod walk;

pub use constant::Constant;

use rowan::TextRange;
use smol_str::SmolStr;
use val3_lang::operators::{BinaryOp, UnaryOp};

use crate::db::{Db, File};
use crate::items::parse;

/// Expression identifier in a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ExprId(u32);

/// Code of a program.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Body {
    exprs: Vec<(Expr, TextRange)>,
    /// Statements between `begin` and `end`.
    pub block: Vec<Stmt>,
}

/// A statement and its range.
#[derive(Debug, Clone, PartialEq)]
pub struct Stmt {
    /// Kind of the statement.
    pub kind: StmtKind,
    /// Range of the statement.
    pub range: TextRange,
}

impl Stmt {
    /// Returns the blocks of the statement in source order.
    pub fn blocks(&self) -> impl Iterator<Item = &[Stmt]> {
        let (arms, cases, last): (&[_], &[_], Option<&[_]>) = match &self.kind {
            StmtKind::If { arms, otherwise } => (arms, &[], otherwise.as_deref()),
            StmtKind::While { block, .. } | StmtKind::Do { block, .. } | StmtKind::For { block, .. } => {
                (&[], &[], Some(block))
            }
            StmtKind::Switch { cases, .. } => (&[], cases, None),
            _ => (&[], &[], None),
        };
        let arms = arms.iter().map(|(_, block): &(Option<ExprId>, Vec<Stmt>)| block.as_slice());
        let cases = cases.iter().map(|(_, block): &(Vec<ExprId>, Vec<Stmt>)| block.as_slice());
        arms.chain(cases).chain(last)
    }

    /// Returns the statement and all statements in its blocks, outer before inner ones, in source order.
    pub fn with_inner(&self) -> Vec<&Stmt> {
        let mut found = vec![self];
        self.blocks().for_each(|block| collect_stmts(block, &mut found));
        found
    }

    /// Whether the statement or a statement in its blocks is of this kind.
    pub fn holds(&self, kind: &StmtKind) -> bool {
        self.kind == *kind || self.blocks().flatten().any(|inner| inner.holds(kind))
    }
}

/// Kind and parts of a statement.
#[derive(Debug, Clone, PartialEq)]
pub enum StmtKind {
    /// `if` and each `elseIf` with its block, then `else`.
    If {
        /// Condition and block of `if` and each `elseIf`.
        arms: Vec<(Option<ExprId>, Vec<Stmt>)>,
        /// The block of `else`.
        otherwise: Option<Vec<Stmt>>,
    },
    /// `while`
    While {
        /// The condition.
        condition: Option<ExprId>,
        /// The block.
        block: Vec<Stmt>,
    },
    /// `do … until`
    Do {
        /// The block.
        block: Vec<Stmt>,
        /// The condition.
        condition: Option<ExprId>,
    },
    /// `for`
    For {
        /// The counter.
        counter: Option<ExprId>,
        /// The value after `=`.
        start: Option<ExprId>,
        /// The value after `to`.
        stop: Option<ExprId>,
        /// The value after `step`.
        step: Option<ExprId>,
        /// The block.
        block: Vec<Stmt>,
    },
    /// `switch`
    Switch {
        /// The value that is compared.
        selector: Option<ExprId>,
        /// Values and blocks of the `case` clauses; no values for `default`.
        cases: Vec<(Vec<ExprId>, Vec<Stmt>)>,
    },
    /// `return`
    Return,
    /// `call program(…)`
    Call(ExprId),
    /// `taskCreate` or `taskCreateSync`
    TaskCreate {
        /// Whether the keyword is `taskCreateSync`.
        synchronous: bool,
        /// The arguments after the keyword: name, priority or period, overrun flag, call.
        arguments: Vec<ExprId>,
    },
    /// `? expression`
    Print(ExprId),
    /// `target = value`; the value of a chain is an [`Expr::Assign`].
    Assign {
        /// The left side.
        target: ExprId,
        /// The right side.
        value: ExprId,
    },
    /// An expression as a statement.
    Expr(ExprId),
    /// A line with a syntax error.
    Error,
}

/// Kind of expression, with its parts.
#[derive(Debug, Clone, PartialEq)]
pub enum Expr {
    /// A missing or unreadable expression.
    Missing,
    /// A number.
    Number(f64),
    /// A string, without quotes and with entity references replaced.
    String(SmolStr),
    /// `true` or `false`
    Bool(bool),
    /// A name.
    Name(SmolStr),
    /// `library:item`
    Path {
        /// The library identifier.
        library: SmolStr,
        /// Item name.
        item: SmolStr,
    },
    /// `( … )`
    Paren(ExprId),
    /// `-x`, `!x`
    Unary(UnaryOp, ExprId),
    /// `a + b`
    Binary(BinaryOp, ExprId, ExprId),
    /// `a = b` as a value.
    Assign(ExprId, ExprId),
    /// `base[…]`
    Index(ExprId, Box<[ExprId]>),
    /// `base.field`
    Field {
        /// The expression before the dot.
        base: ExprId,
        /// The field.
        field: SmolStr,
        /// Range of the field name.
        range: TextRange,
    },
    /// `callee(…)`
    Call(ExprId, Box<[ExprId]>),
    /// `{…}`; `None` for an omitted value.
    Struct(Box<[Option<ExprId>]>),
}

impl Expr {
    /// Returns the leftmost subexpression.
    fn first_part(&self) -> Option<ExprId> {
        match self {
            Self::Paren(first) | Self::Unary(_, first) | Self::Field { base: first, .. } => Some(*first),
            Self::Binary(_, first, _) | Self::Assign(first, _) => Some(*first),
            Self::Index(first, _) | Self::Call(first, _) => Some(*first),
            Self::Struct(parts) => parts.iter().flatten().next().copied(),
            Self::Missing | Self::Number(_) | Self::String(_) | Self::Bool(_) | Self::Name(_) | Self::Path { .. } => {
                None
            }
        }
    }
}

fn collect_stmts<'b>(block: &'b [Stmt], found: &mut Vec<&'b Stmt>) {
    for stmt in block {
        found.push(stmt);
        stmt.blocks().for_each(|block| collect_stmts(block, found));
    }
}

/// Returns the code of a `.pgx` with this text.
#[cfg(test)]
pub(crate) fn lower_text(text: &str) -> Body {
    lower::lower(val3_syntax::parse(text).view())
}

/// Returns the code of the program in `file`.
#[salsa::tracked(lru = 256, no_eq)]
pub fn body(db: &dyn Db, file: File) -> Body {
    lower::lower(parse(db, file).view())
}

impl Body {
    /// Returns an expression.
    pub fn expr(&self, id: ExprId) -> &Expr {
        self.exprs.get(id.0 as usize).map_or(&Expr::Missing, |(expr, _)| expr)
    }

    /// Returns an expression's range.
    pub fn range(&self, id: ExprId) -> TextRange {
        self.exprs.get(id.0 as usize).map_or_else(TextRange::default, |(_, range)| *range)
    }

    /// Returns all expressions, inner before outer ones.
    pub fn exprs(&self) -> impl Iterator<Item = (ExprId, &Expr, TextRange)> {
        (0u32..).zip(&self.exprs).map(|(index, (expr, range))| (ExprId(index), expr, *range))
    }

    /// Returns the number of expressions.
    pub fn len(&self) -> usize {
        self.exprs.len()
    }

    /// Whether the body has no expression.
    pub fn is_empty(&self) -> bool {
        self.exprs.is_empty()
    }

    /// Returns all statements, outer before inner ones, in source order.
    pub fn stmts(&self) -> Vec<&Stmt> {
        let mut found = Vec::new();
        collect_stmts(&self.block, &mut found);
        found
    }

    /// Returns `id` and all its subexpressions, inner before outer ones, from left to right.
    pub fn within(&self, id: ExprId) -> impl DoubleEndedIterator<Item = ExprId> + use<> {
        (self.first_within(id).0..=id.0).map(ExprId)
    }

    /// Returns the leftmost innermost subexpression of `id`. Expressions are numbered in the order of lowering: the
    /// parts from left to right, then the whole.
    pub(crate) fn first_within(&self, mut id: ExprId) -> ExprId {
        while let Some(part) = self.expr(id).first_part() {
            id = part;
        }
        id
    }

    /// Returns the expression without enclosing parentheses.
    pub fn without_parentheses(&self, mut id: ExprId) -> ExprId {
        while let Expr::Paren(inner) = self.expr(id) {
            id = *inner;
        }
        id
    }
}

impl ExprId {
    /// Returns the index of the expression in [`Body::exprs`].
    pub fn index(self) -> usize {
        self.0 as usize
    }
}
