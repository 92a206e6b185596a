//! Equal expressions with the same value within one block.

use std::cmp::Reverse;

use val3_analysis::body::{Body, ExprId, Stmt};
use val3_syntax::{TextRange, TextSize};

use super::super::context::Context;
use super::super::evaluation::Evaluation;
use super::super::stability::Dependencies;
use super::apart;

/// Uses of the same value.
pub(super) struct Occurrences {
    /// Start of the statement before which the value is computed.
    pub(super) before: TextSize,
    /// Ranges of the expressions, in the order of the text.
    pub(super) ranges: Vec<TextRange>,
}

impl Occurrences {
    /// Only the expression itself.
    pub(super) fn single(body: &Body, id: ExprId, stmt: &Stmt) -> Self {
        Self { before: stmt.range.start(), ranges: vec![body.range(id)] }
    }

    /// All uses of `id`'s value in its block; `None` if it is the only use.
    pub(super) fn of<'db>(context: &Context<'db>, evaluation: &Evaluation<'db>, id: ExprId) -> Option<Self> {
        let dependencies = Dependencies::of(context, evaluation, id)?;
        let (block, at) = evaluation.stmt(id)?;
        let equal = equal(evaluation, id);
        let (mut first, mut last) = (at, at);
        if !dependencies.survive_reads_of(block.get(at)?) {
            return None;
        }
        let survives = |index: usize| block.get(index).is_some_and(|it| dependencies.survive(std::slice::from_ref(it)));
        while survives(last) && block.get(last + 1).is_some_and(|next| dependencies.survive_reads_of(next)) {
            last += 1;
        }
        while first.checked_sub(1).is_some_and(survives) {
            first -= 1;
        }
        let stmts = block.get(first..=last)?;
        // The value is computed at its first evaluation, so that a run-time error occurs at the same point.
        let start = stmts.iter().position(|stmt| equal.iter().any(|id| is_computed_at(evaluation, *id, stmt)))?;
        let stmts = stmts.get(start..)?;
        let ranges = equal.iter().map(|id| evaluation.body.range(apart(context, *id)));
        let ranges = ranges.filter(|range| stmts.iter().any(|stmt| stmt.range.contains_range(*range)));
        let found = Self { before: stmts.first()?.range.start(), ranges: ranges.collect() };
        (found.ranges.len() > 1 && context.starts_no_line(found.before).is_none()).then_some(found)
    }
}

/// Expressions with the same source as `id` that are used as values, in the order of the text.
fn equal(evaluation: &Evaluation<'_>, id: ExprId) -> Vec<ExprId> {
    let body = evaluation.body;
    let form = body.written_form(id);
    let ids = body.exprs().map(|(other, ..)| other);
    let mut found: Vec<ExprId> =
        ids.filter(|other| body.written_form(*other) == form && evaluation.is_value(*other)).collect();
    found.sort_by_key(|id| (body.range(*id).start(), Reverse(body.range(*id).end())));
    // An expression in parentheses has the same normalised source as the expression itself. The outermost range is
    // kept.
    found.dedup_by(|inner, outer| body.range(*outer).contains_range(body.range(*inner)));
    found
}

/// Whether the statement itself, not a nested block, always evaluates the expression.
fn is_computed_at(evaluation: &Evaluation<'_>, id: ExprId, stmt: &Stmt) -> bool {
    let own = evaluation.stmt(id).and_then(|(block, at)| block.get(at));
    own.is_some_and(|own| own.range == stmt.range) && evaluation.movable(id).is_ok()
}
