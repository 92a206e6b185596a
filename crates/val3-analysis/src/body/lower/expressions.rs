//! Lowering of expressions.

use rowan::{NodeOrToken, TextRange};
use smallvec::smallvec;
use smol_str::SmolStr;
use val3_lang::operators::{BinaryOp, UnaryOp};
use val3_syntax::SyntaxKind::{self, *};
use val3_syntax::decode_entities;
use val3_syntax::view::{TokenView, View};

use super::{Lowering, ShortList};
use crate::body::{Expr, ExprId};

impl Lowering {
    /// Returns the two operands of a node; a missing operand becomes [`Expr::Missing`].
    fn pair(&mut self, view: View<'_>) -> (ExprId, ExprId) {
        let mut parts = view.children();
        let missing = TextRange::empty(view.range().end());
        let first = parts.find_map(|part| self.expr(part));
        let first = first.unwrap_or_else(|| self.push(Expr::Missing, missing));
        let second = parts.find_map(|part| self.expr(part));
        (first, second.unwrap_or_else(|| self.push(Expr::Missing, missing)))
    }

    fn only(&mut self, view: View<'_>) -> ExprId {
        self.first_expr(view).unwrap_or_else(|| self.push(Expr::Missing, TextRange::empty(view.range().end())))
    }

    fn push(&mut self, expr: Expr, range: TextRange) -> ExprId {
        let id = ExprId(u32::try_from(self.exprs.len()).unwrap_or(u32::MAX));
        self.exprs.push((expr, range));
        id
    }

    /// Lowers an expression; `None` if the node is no expression.
    pub(super) fn expr(&mut self, view: View<'_>) -> Option<ExprId> {
        let expr = match view.kind() {
            LITERAL => self.literal(view),
            NAME_REF => Expr::Name(name(view)),
            LIBRARY_PATH => path(view),
            PAREN_EXPR => Expr::Paren(self.only(view)),
            PREFIX_EXPR => {
                let op = if view.token(BANG).is_some() { UnaryOp::Not } else { UnaryOp::Negate };
                // `not x` was reported as a syntax error; its operand is the last expression.
                let operands = self.exprs_of(view);
                let operand = operands.last().copied().unwrap_or_else(|| self.only(view));
                Expr::Unary(op, operand)
            }
            BIN_EXPR => self.binary(view),
            ASSIGN_EXPR => {
                let (target, value) = self.pair(view);
                Expr::Assign(target, value)
            }
            INDEX_EXPR => {
                let mut parts = view.children();
                let base = parts.find_map(|part| self.expr(part));
                let base = base.unwrap_or_else(|| self.push(Expr::Missing, view.range()));
                let keys: ShortList<ExprId> = parts.filter_map(|part| self.expr(part)).collect();
                Expr::Index(base, Box::from(&*keys))
            }
            FIELD_EXPR => self.field(view),
            CALL_EXPR => self.call(view),
            STRUCT_LITERAL => self.structure(view),
            _ => return None,
        };
        Some(self.push(expr, view.range()))
    }

    fn literal(&self, view: View<'_>) -> Expr {
        let Some(token) = view.tokens().next() else { return Expr::Missing };
        match token.kind() {
            NUMBER => token.text().parse().map_or(Expr::Missing, Expr::Number),
            TRUE_KW => Expr::Bool(true),
            FALSE_KW => Expr::Bool(false),
            _ => Expr::String(string_text(token.text(), self.escaped)),
        }
    }

    fn binary(&mut self, view: View<'_>) -> Expr {
        let (left, right) = self.pair(view);
        let operator = view.tokens().next().and_then(operator);
        operator.map_or(Expr::Missing, |op| Expr::Binary(op, left, right))
    }

    fn field(&mut self, view: View<'_>) -> Expr {
        let mut nodes = view.children();
        let base = nodes.next().and_then(|base| self.expr(base));
        let field = nodes.find(|node| node.kind() == NAME_REF);
        match (base, field) {
            (Some(base), Some(field)) => Expr::Field { base, field: name(field), range: field.range() },
            _ => Expr::Missing,
        }
    }

    fn call(&mut self, view: View<'_>) -> Expr {
        let callee = self.only(view);
        let args = view.child(ARG_LIST).map(|list| self.exprs_of(list)).unwrap_or_default();
        Expr::Call(callee, Box::from(&*args))
    }

    /// Lowers comma-separated values; `{}` has none.
    fn structure(&mut self, view: View<'_>) -> Expr {
        let mut values: ShortList<Option<ExprId>> = smallvec![None];
        for child in view.children_with_tokens() {
            match child {
                NodeOrToken::Token(token) if token.kind() == COMMA => values.push(None),
                NodeOrToken::Token(_) => {}
                NodeOrToken::Node(node) => {
                    let value = self.expr(node);
                    if let Some(last) = values.last_mut() {
                        *last = value;
                    }
                }
            }
        }
        if values.as_slice() == [None] {
            values.clear();
        }
        Expr::Struct(Box::from(&*values))
    }
}

/// Whether a node of this kind becomes an expression; names in paths and after dots do not.
pub(super) fn is_expr(kind: SyntaxKind) -> bool {
    matches!(
        kind,
        LITERAL
            | NAME_REF
            | LIBRARY_PATH
            | PAREN_EXPR
            | PREFIX_EXPR
            | BIN_EXPR
            | ASSIGN_EXPR
            | INDEX_EXPR
            | FIELD_EXPR
            | CALL_EXPR
            | STRUCT_LITERAL
    )
}

fn name(view: View<'_>) -> SmolStr {
    view.token(IDENT).map(|token| SmolStr::from(token.text())).unwrap_or_default()
}

fn path(view: View<'_>) -> Expr {
    let mut names = view.children().filter(|node| node.kind() == NAME_REF).map(name);
    match (names.next(), names.next()) {
        (Some(library), Some(item)) => Expr::Path { library, item },
        _ => Expr::Missing,
    }
}

fn string_text(text: &str, escaped: bool) -> SmolStr {
    let text = if escaped { decode_entities(text) } else { text.into() };
    let inner = text.strip_prefix('"').unwrap_or(&text);
    SmolStr::from(inner.strip_suffix('"').unwrap_or(inner))
}

fn operator(token: TokenView<'_>) -> Option<BinaryOp> {
    Some(match token.kind() {
        OR_KW => BinaryOp::Or,
        AND_KW => BinaryOp::And,
        XOR_KW => BinaryOp::Xor,
        EQ2 => BinaryOp::Equal,
        NEQ => BinaryOp::NotEqual,
        LT => BinaryOp::Less,
        LE => BinaryOp::LessOrEqual,
        GT => BinaryOp::Greater,
        GE => BinaryOp::GreaterOrEqual,
        PLUS => BinaryOp::Add,
        MINUS => BinaryOp::Subtract,
        STAR => BinaryOp::Multiply,
        SLASH => BinaryOp::Divide,
        PERCENT => BinaryOp::Remainder,
        _ => return None,
    })
}
