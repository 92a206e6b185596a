//! Guards: the conditions under which the parts of a program are evaluated.
//!
//! VAL 3 has no jump except `return`, so the blocks around a line, and the blocks before it that always leave the
//! program, determine its guards. The right side of `and` and `or` is guarded by the left side, because it is evaluated
//! only if the left side does not determine the result (3.1.2).

mod build;
mod size_tests;

use rowan::TextRange;
use val3_lang::operators::BinaryOp;

pub use self::size_tests::FixedArray;
use crate::body::{Body, Constant, Expr, ExprId, body, constant};
use crate::db::{Db, File};

/// Condition that is met whenever a part of the program is evaluated.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Guard {
    /// A condition with this value.
    Condition(ExprId, bool),
    /// A `for` loop with at least one pass.
    Loop {
        /// The counter.
        counter: Option<ExprId>,
        /// The first value, the last value and the step.
        bounds: [Option<ExprId>; 3],
    },
    /// A `switch` in which one of the values of a `case` equals the selector; without values for `default`.
    Case(ExprId, Vec<ExprId>),
    /// A line after a `return` or an endless loop.
    Never,
}

/// A guard and the guard around it.
#[derive(Debug, Clone, PartialEq)]
struct GuardNode {
    guard: Guard,
    outer: Option<GuardId>,
    /// Whether constants show that this guard or an outer guard is never met.
    is_never_met: bool,
}

/// Index of a guard.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct GuardId(u32);

/// An expression with its innermost guard. An inner expression has its own entry if it has another guard.
#[derive(Debug, Clone, Copy, PartialEq)]
struct GuardedExpr {
    first: ExprId,
    whole: ExprId,
    guard: Option<GuardId>,
}

/// Guards of all expressions of a program.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Guards {
    nodes: Vec<GuardNode>,
    /// Sorted by `whole`: inner expressions come before the expressions around them.
    exprs: Vec<GuardedExpr>,
}

/// Returns the guards of the program in `file`.
#[salsa::tracked(lru = 256, no_eq)]
pub fn guards(db: &dyn Db, file: File) -> Guards {
    build::build(body(db, file))
}

impl Guards {
    /// Whether constant conditions or an earlier `return` show that the expression is never evaluated.
    pub fn is_never_evaluated(&self, id: ExprId) -> bool {
        self.node(self.innermost(id)).is_some_and(|node| node.is_never_met)
    }

    /// Returns the source ranges of the expressions that are never evaluated.
    pub fn never_evaluated<'b>(&'b self, body: &'b Body) -> impl Iterator<Item = TextRange> + 'b {
        let never = self.exprs.iter().filter(|expr| self.node(expr.guard).is_some_and(|node| node.is_never_met));
        never.map(|expr| body.range(expr.whole))
    }

    /// Returns the guards of an expression, inner before outer ones.
    fn of(&self, id: ExprId) -> impl Iterator<Item = &Guard> {
        let innermost = self.node(self.innermost(id));
        std::iter::successors(innermost, |node| self.node(node.outer)).map(|node| &node.guard)
    }

    fn innermost(&self, id: ExprId) -> Option<GuardId> {
        let start = self.exprs.partition_point(|expr| expr.whole < id);
        self.exprs.iter().skip(start).find(|expr| expr.first <= id)?.guard
    }

    fn node(&self, id: Option<GuardId>) -> Option<&GuardNode> {
        self.nodes.get(id?.0 as usize)
    }
}

impl Guard {
    /// Returns the expressions that decide whether the guard is met.
    fn exprs(&self) -> Vec<ExprId> {
        match self {
            Self::Condition(condition, _) => vec![*condition],
            Self::Loop { bounds, .. } => bounds.iter().flatten().copied().collect(),
            Self::Case(selector, values) => std::iter::once(*selector).chain(values.iter().copied()).collect(),
            Self::Never => Vec::new(),
        }
    }

    /// Returns whether the guard is met, if constants and values that `known` returns show it.
    fn is_met(&self, body: &Body, known: KnownValues<'_>) -> Option<bool> {
        match self {
            Self::Condition(condition, expected) => match value(body, *condition, known)? {
                Constant::Bool(value) => Some(value == *expected),
                _ => None,
            },
            Self::Loop { bounds: [start, stop, step], .. } => {
                let step = if step.is_none() { 1.0 } else { number(body, *step, known)? };
                let (start, stop) = (number(body, *start, known)?, number(body, *stop, known)?);
                Some(if step < 0.0 { start >= stop } else { start <= stop })
            }
            Self::Case(_, values) if values.is_empty() => None,
            Self::Case(selector, values) => {
                let selector = value(body, *selector, known)?;
                let equal = values.iter().map(|case| Some(value(body, *case, known)? == selector));
                equal.collect::<Option<Vec<bool>>>().map(|equal| equal.contains(&true))
            }
            Self::Never => Some(false),
        }
    }
}

/// Values of expressions that are not computed from literals; `None` for an unknown value.
type KnownValues<'k> = &'k dyn Fn(ExprId) -> Option<Constant>;

/// Returns the value of an expression. One operand of `and` or `or` is sufficient if it determines the result.
fn value(body: &Body, id: ExprId, known: KnownValues<'_>) -> Option<Constant> {
    match body.expr(id) {
        Expr::Paren(inner) => value(body, *inner, known),
        Expr::Unary(op, operand) => constant::unary(*op, value(body, *operand, known)?),
        Expr::Binary(op, left, right) => {
            let (left, right) = (value(body, *left, known), value(body, *right, known));
            let decisive = decisive_operand(*op).map(Constant::Bool);
            if decisive.is_some() && (left == decisive || right == decisive) {
                return decisive;
            }
            constant::binary(*op, left?, right?)
        }
        Expr::Number(_) | Expr::String(_) | Expr::Bool(_) => body.constant(id),
        _ => known(id),
    }
}

fn number(body: &Body, id: Option<ExprId>, known: KnownValues<'_>) -> Option<f64> {
    match value(body, id?, known)? {
        Constant::Number(number) => Some(number),
        _ => None,
    }
}

/// Returns the operand value that determines the result of `and` or `or`, and equals it.
fn decisive_operand(op: BinaryOp) -> Option<bool> {
    match op {
        BinaryOp::And => Some(false),
        BinaryOp::Or => Some(true),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::body::lower_text;

    /// Source texts of the outermost expressions that are never evaluated.
    fn never_evaluated(code: &str) -> String {
        let text =
            format!("<Programs><Program name=\"a\"><Code><![CDATA[begin\n{code}\nend]]></Code></Program></Programs>");
        let body = lower_text(&text);
        let guards = build::build(&body);
        let ranges = guards.never_evaluated(&body).collect::<Vec<_>>();
        let texts = ranges.iter().map(|range| &text[usize::from(range.start())..usize::from(range.end())]);
        texts.collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn constant_conditions_guard_their_blocks() {
        expect!["a 1 bD f 6"]
            .assert_eq(&never_evaluated("if false\na=1\nelse\nb=2\nendIf\nif 1<2\nc=3\nelseIf bD\nf=6\nendIf\ng=7"));
        assert_eq!(never_evaluated("while false and bA\nput(1)\nendWhile\nput(2)"), "bA put(1)");
        assert_eq!(never_evaluated("for i=3 to 1\nput(1)\nendFor\nfor i=3 to 1 step -1\nput(2)\nendFor"), "put(1)");
        assert_eq!(never_evaluated("switch 1\ncase 2\nput(2)\nbreak\ncase 1\nput(1)\nbreak\nendSwitch"), "put(2)");
    }

    #[test]
    fn lines_after_a_block_that_leaves_the_program_are_guarded() {
        assert_eq!(never_evaluated("put(1)\nreturn\nput(2)"), "put(2)");
        assert_eq!(never_evaluated("if true\nreturn\nendIf\nput(2)"), "put(2)");
        assert_eq!(never_evaluated("if bA\nreturn\nelse\nreturn\nendIf\nput(2)"), "put(2)");
        assert_eq!(never_evaluated("while true\nput(1)\nendWhile\nput(2)"), "put(2)");
        assert_eq!(never_evaluated("do\nreturn\nuntil bA\nput(2)"), "bA put(2)");
        assert_eq!(never_evaluated("if bA\nput(1)\nelseIf false\nput(2)\nelse\nreturn\nendIf\nput(3)"), "put(2)");
        assert_eq!(never_evaluated("switch n\ncase 1\nreturn\ndefault\nreturn\nendSwitch\nput(2)"), "put(2)");
        assert_eq!(never_evaluated("switch n\ncase 1\nreturn\nendSwitch\nput(2)"), "");
    }

    #[test]
    fn the_right_side_is_guarded_by_the_left_side() {
        assert_eq!(never_evaluated("b=false and f(1)"), "f(1)");
        assert_eq!(never_evaluated("b=(bA or true) or (f(1) and bB)"), "bB (f(1) and bB)");
        assert_eq!(never_evaluated("b=bA and false and f(1)"), "f(1)");
        assert_eq!(never_evaluated("b=(false and f(1)) or f(2)"), "f(1)");
        assert_eq!(never_evaluated("b=true and f(1)"), "");
    }
}
