//! V0317: two comparisons that exclude or complete each other.

use rustc_hash::FxHashSet;
use val3_analysis::body::{Constant, Expr, ExprId};
use val3_lang::operators::BinaryOp;
use val3_syntax::TextRange;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// Two comparisons of the same value with constants are never both true, or one of them is always true.
    ///
    /// ## Why
    /// No number is below 0 and above 10, so a condition with both joined by `and` is always false. Each number differs
    /// from 1 or from 2, so a condition with both joined by `or` is always true. The other operator was meant, or other
    /// values.
    ///
    /// ## Bad
    /// ```val3
    /// num nLevel
    ///
    /// if nLevel<0 and nLevel>10
    ///   putln("out of range")
    /// endIf
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nLevel
    ///
    /// if nLevel<0 or nLevel>10
    ///   putln("out of range")
    /// endIf
    /// ```
    V0317 "contradiction" Warning, Program: check
}

/// Maximum number of compared operands, so that the time stays proportional to the length of the text.
const LONGEST_CHAIN: usize = 16;

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let mut inner = FxHashSet::default();
    let chains: Vec<(ExprId, BinaryOp, TextRange)> = program
        .body
        .exprs()
        .filter_map(|(id, expr, range)| match expr {
            Expr::Binary(op @ (BinaryOp::And | BinaryOp::Or), ..) => Some((id, *op, range)),
            _ => None,
        })
        .collect();
    // Outer expressions come after inner ones.
    for (id, op, range) in chains.into_iter().rev() {
        if inner.contains(&id) {
            continue;
        }
        let operands = operands(program, id, op, &mut inner);
        let comparisons: Vec<Comparison> = operands.iter().filter_map(|id| comparison(program, *id)).collect();
        if let Some((first, second)) = decisive_pair(program, &comparisons, op) {
            let wording = word(op, program.text(first.id), program.text(second.id));
            found.report(&RULE, range, wording);
        }
    }
}

/// Operands of a chain such as `a and b and c`. The parts of the chain are added to `inner`.
fn operands(program: &ProgramView<'_>, chain: ExprId, op: BinaryOp, inner: &mut FxHashSet<ExprId>) -> Vec<ExprId> {
    let (mut operands, mut open) = (Vec::new(), vec![chain]);
    while let Some(id) = open.pop() {
        let id = program.body.without_parentheses(id);
        match program.body.expr(id) {
            Expr::Binary(own, left, right) if *own == op => {
                inner.insert(id);
                open.extend([*right, *left]);
            }
            _ => operands.push(id),
        }
    }
    operands.truncate(LONGEST_CHAIN);
    operands
}

/// A comparison of a value with a constant.
struct Comparison {
    id: ExprId,
    subject: ExprId,
    op: BinaryOp,
    constant: Constant,
}

fn comparison(program: &ProgramView<'_>, id: ExprId) -> Option<Comparison> {
    let Expr::Binary(op, left, right) = program.body.expr(id) else { return None };
    let flipped = flipped(*op)?;
    let (subject, op, constant) = match (program.body.constant(*left), program.body.constant(*right)) {
        (None, Some(constant)) => (*left, *op, constant),
        (Some(constant), None) => (*right, flipped, constant),
        _ => return None,
    };
    let is_ordered = matches!(constant, Constant::Number(_));
    let is_equality = matches!(op, BinaryOp::Equal | BinaryOp::NotEqual);
    let is_text = matches!(constant, Constant::String(_)) && is_equality;
    (is_ordered || is_text).then_some(Comparison { id, subject, op, constant })
}

/// Operator of the comparison with exchanged operands; `None` for other operators.
fn flipped(op: BinaryOp) -> Option<BinaryOp> {
    Some(match op {
        BinaryOp::Less => BinaryOp::Greater,
        BinaryOp::LessOrEqual => BinaryOp::GreaterOrEqual,
        BinaryOp::Greater => BinaryOp::Less,
        BinaryOp::GreaterOrEqual => BinaryOp::LessOrEqual,
        BinaryOp::Equal | BinaryOp::NotEqual => op,
        _ => return None,
    })
}

/// First two comparisons of the same value that determine the result of the chain: no value fulfils both (`and`), or
/// each value fulfils one of them (`or`).
fn decisive_pair<'c>(
    program: &ProgramView<'_>,
    comparisons: &'c [Comparison],
    op: BinaryOp,
) -> Option<(&'c Comparison, &'c Comparison)> {
    let pairs = comparisons
        .iter()
        .enumerate()
        .flat_map(|(at, second)| comparisons.iter().take(at).map(move |first| (first, second)));
    pairs.filter(|(first, second)| is_decisive(first, second, op)).find(|(first, second)| {
        program.is_same(first.subject, second.subject)
            // V0238 reports equal comparisons.
            && !program.is_same(first.id, second.id)
    })
}

fn is_decisive(first: &Comparison, second: &Comparison, op: BinaryOp) -> bool {
    // Value that determines the result of the chain: a false operand of `and`, a true operand of `or`.
    let decides = op == BinaryOp::Or;
    match (&first.constant, &second.constant) {
        (Constant::Number(a), Constant::Number(b)) => samples(*a, *b).into_iter().all(|value| {
            [(first.op, *a), (second.op, *b)].into_iter().any(|(op, limit)| holds(op, value, limit) == decides)
        }),
        (Constant::String(a), Constant::String(b)) if a != b => match op {
            BinaryOp::And => first.op == BinaryOp::Equal && second.op == BinaryOp::Equal,
            _ => first.op == BinaryOp::NotEqual && second.op == BinaryOp::NotEqual,
        },
        _ => false,
    }
}

/// One value in each range in which both comparisons are constant.
fn samples(a: f64, b: f64) -> [f64; 5] {
    let (low, high) = (a.min(b), a.max(b));
    // Each step is as large as the numbers, so that it is not lost in rounding.
    let step = 1.0 + low.abs().max(high.abs());
    [low - step, low, low.midpoint(high), high, high + step]
}

fn holds(op: BinaryOp, value: f64, limit: f64) -> bool {
    match op {
        BinaryOp::Less => value < limit,
        BinaryOp::LessOrEqual => value <= limit,
        BinaryOp::Greater => value > limit,
        BinaryOp::GreaterOrEqual => value >= limit,
        BinaryOp::Equal => value == limit,
        _ => value != limit,
    }
}

fn word(op: BinaryOp, first: &str, second: &str) -> Wording {
    if op == BinaryOp::And {
        Wording::new(format!("`{first}` and `{second}` are never both true"), "always false", "`or` may be meant")
    } else {
        Wording::new(format!("`{first}` or `{second}` is true for each value"), "always true", "`and` may be meant")
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn conditions(conditions: &[&str]) -> String {
        let lines: String = conditions.iter().map(|condition| format!("bA={condition}\n")).collect();
        check(&RULE, &format!("num nA\nnum nB\nnum nC[3]\nstring sA\nbool bA\n{lines}"))
    }

    #[test]
    fn comparisons_that_exclude_or_complete_each_other_are_reported() {
        expect![[r#"
            start.pgx:5 `nA<0 and nA>10` `nA<0` and `nA>10` are never both true
              | always false
              ? `or` may be meant
            start.pgx:6 `nA!=1 or nA!=2` `nA!=1` or `nA!=2` is true for each value
              | always true
              ? `and` may be meant
            start.pgx:7 `(nB>1 and 5<nA) and (nA<=5)` `5<nA` and `nA<=5` are never both true
              | always false
              ? `or` may be meant
            start.pgx:8 `nC[1]==1 and nC[1]==2` `nC[1]==1` and `nC[1]==2` are never both true
              | always false
              ? `or` may be meant
            start.pgx:9 `sA=="a" and nB>1 and sA=="b"` `sA=="a"` and `sA=="b"` are never both true
              | always false
              ? `or` may be meant
            start.pgx:10 `bA or (nA<=3 or 2<nA)` `nA<=3` or `2<nA` is true for each value
              | always true
              ? `and` may be meant
            start.pgx:11 `nA==3 and nA!=3` `nA==3` and `nA!=3` are never both true
              | always false
              ? `or` may be meant
        "#]]
        .assert_eq(&conditions(&[
            "nA<0 and nA>10",
            "nA!=1 or nA!=2",
            "(nB>1 and 5<nA) and (nA<=5)",
            "nC[1]==1 and nC[1]==2",
            "sA==\"a\" and nB>1 and sA==\"b\"",
            "bA or (nA<=3 or 2<nA)",
            "nA==3 and nA!=3",
        ]));
    }

    #[test]
    fn ranges_and_other_values_are_not_reported() {
        assert_eq!(
            conditions(&[
                "nA<0 or nA>10",
                "nA!=1 and nA!=2",
                "nA>=5 and nA<=5",
                "nA<3 or nA>3",
                "nA<0 and nB>10",
                "nC[1]==1 and nC[2]==2",
                "(nA<0 and bA) or nA>10",
                "nA<0 and (bA or nA>10)",
                "round(nA)==1 and round(nA)==2",
                "nA>0.1 and nA<0.2",
                "sA!=\"a\" and sA!=\"b\"",
                "nA<1e300 and nA>-1e300",
            ]),
            ""
        );
    }
}
