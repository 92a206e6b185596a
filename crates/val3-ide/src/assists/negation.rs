//! Negation of a condition in its simplest form.

use val3_analysis::body::{Expr, ExprId};
use val3_lang::operators::{BinaryOp, UnaryOp};
use val3_lang::types::BaseType;
use val3_syntax::TextRange;

use super::context::Context;

/// Negates the condition `id`, as source text. Negating twice yields the original text, except that `!(…)` loses its
/// parentheses.
pub(super) fn negated(context: &Context<'_>, id: ExprId) -> String {
    let body = context.body();
    match body.expr(id) {
        Expr::Paren(inner) => {
            let (whole, part) = (body.range(id), body.range(*inner));
            let open = context.slice(TextRange::new(whole.start(), part.start()));
            let close = context.slice(TextRange::new(part.end(), whole.end()));
            format!("{open}{}{close}", negated(context, *inner))
        }
        Expr::Unary(UnaryOp::Not, operand) => context.slice(body.range(body.without_parentheses(*operand))).to_owned(),
        Expr::Bool(value) => (!value).to_string(),
        Expr::Binary(op, left, right) => {
            let contrary = contrary(context, *op, *left, *right);
            contrary.unwrap_or_else(|| format!("!({})", context.slice(body.range(id))))
        }
        _ => format!("!{}", context.slice(body.range(id))),
    }
}

/// Negates an operation without a surrounding `!`; `None` if the operator cannot be negated.
fn contrary(context: &Context<'_>, op: BinaryOp, left: ExprId, right: ExprId) -> Option<String> {
    let body = context.body();
    let other = other_operator(context, op, left)?;
    let (before, after) = match is_junction(op) {
        true => (operand(context, op, left)?, operand(context, op, right)?),
        false => (context.slice(body.range(left)).to_owned(), context.slice(body.range(right)).to_owned()),
    };
    let between = context.slice(TextRange::new(body.range(left).end(), body.range(right).start()));
    let operator = between.trim();
    let text = format!("{before}{}{after}", between.replacen(operator, &context.written(other.symbol()), 1));
    // `]]>` would end the CDATA section.
    (context.is_escaped() || !text.contains("]]>")).then_some(text)
}

fn other_operator(context: &Context<'_>, op: BinaryOp, left: ExprId) -> Option<BinaryOp> {
    // Joints are compared axis by axis, so `!(a<b)` is not the same as `a>=b`.
    let is_number = context.inference().ty(left).base.builtin() == Some(BaseType::Num);
    match op {
        BinaryOp::And => Some(BinaryOp::Or),
        BinaryOp::Or => Some(BinaryOp::And),
        BinaryOp::Equal => Some(BinaryOp::NotEqual),
        BinaryOp::NotEqual => Some(BinaryOp::Equal),
        BinaryOp::Less if is_number => Some(BinaryOp::GreaterOrEqual),
        BinaryOp::GreaterOrEqual if is_number => Some(BinaryOp::Less),
        BinaryOp::Greater if is_number => Some(BinaryOp::LessOrEqual),
        BinaryOp::LessOrEqual if is_number => Some(BinaryOp::Greater),
        _ => None,
    }
}

/// Negates one side of `and` or `or`; `None` if the result would need additional parentheses.
fn operand(context: &Context<'_>, op: BinaryOp, id: ExprId) -> Option<String> {
    let body = context.body();
    match body.expr(id) {
        Expr::Binary(own, left, right) if is_junction(*own) && *own == op => contrary(context, op, *left, *right),
        Expr::Binary(own, ..) if is_junction(*own) => None,
        Expr::Unary(UnaryOp::Not, inner) => match body.expr(body.without_parentheses(*inner)) {
            Expr::Binary(own, ..) if is_junction(*own) => Some(context.slice(body.range(*inner)).to_owned()),
            _ => Some(negated(context, id)),
        },
        _ => Some(negated(context, id)),
    }
}

fn is_junction(op: BinaryOp) -> bool {
    matches!(op, BinaryOp::And | BinaryOp::Or)
}
