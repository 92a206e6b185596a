//! V0307: an `elseIf` that an earlier condition always covers.

use rustc_hash::FxHashMap;
use val3_analysis::body::{Body, Expr, ExprId, StmtKind};
use val3_lang::operators::BinaryOp;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// An `elseIf` only holds if an earlier condition of the same `if` holds too, so its block never runs.
    ///
    /// ## Why
    /// Only the block of the first condition that holds is executed. The condition was copied without a change, or a
    /// wider range is tested before a narrower one.
    ///
    /// ## Bad
    /// ```val3
    /// num nForce
    ///
    /// if nForce>10
    ///   putln("contact")
    /// elseIf nForce>50
    ///   putln("collision")
    /// endIf
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nForce
    ///
    /// if nForce>50
    ///   putln("collision")
    /// elseIf nForce>10
    ///   putln("contact")
    /// endIf
    /// ```
    V0307 "repeated-condition" Warning, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for stmt in program.stmts() {
        let StmtKind::If { arms, .. } = &stmt.kind else { continue };
        if arms.len() < 2 {
            continue;
        }
        let mut asked = EarlierConditions::default();
        // Another rule reports constants. A condition with side effects may have another value the next time.
        for condition in arms.iter().filter_map(|(condition, _)| *condition) {
            if program.body.constant(condition).is_some() || !program.is_pure(condition) {
                continue;
            }
            if let Some(earlier) = asked.covering(program.body, condition) {
                let word = word(program.body.is_same(condition, earlier));
                found.report(&RULE, program.range(condition), word).related(program.range(earlier), "first test");
            }
            asked.add(program.body, condition);
        }
    }
}

/// Previous conditions in an `if`.
#[derive(Default)]
struct EarlierConditions {
    /// Conditions by normal form.
    conditions: FxHashMap<String, ExprId>,
    /// Widest ranges tested so far, by the compared value: above a bound, and below a bound.
    ranges: FxHashMap<String, [Option<(NumberInterval, ExprId)>; 2]>,
}

impl EarlierConditions {
    /// Earlier condition that is true whenever `condition` is.
    fn covering(&self, body: &Body, condition: ExprId) -> Option<ExprId> {
        let same = self.conditions.get(&body.normal_form(condition)).copied();
        same.or_else(|| {
            let (value, range) = range(body, condition)?;
            let widest = self.ranges.get(&value)?.iter().flatten();
            widest.into_iter().find(|(outer, _)| range.is_within(outer)).map(|(_, earlier)| *earlier)
        })
    }

    fn add(&mut self, body: &Body, condition: ExprId) {
        self.conditions.entry(body.normal_form(condition)).or_insert(condition);
        let Some((value, range)) = range(body, condition) else { return };
        let [above, below] = self.ranges.entry(value).or_default();
        let side = match (range.low.at.is_finite(), range.high.at.is_finite()) {
            (true, false) => above,
            (false, true) => below,
            _ => return,
        };
        if side.as_ref().is_none_or(|(widest, _)| widest.is_within(&range)) {
            *side = Some((range, condition));
        }
    }
}

/// Numbers between two bounds.
struct NumberInterval {
    low: Bound,
    high: Bound,
}

/// A bound. An open bound excludes the number itself.
#[derive(Clone, Copy)]
struct Bound {
    at: f64,
    is_open: bool,
}

impl NumberInterval {
    fn is_within(&self, outer: &Self) -> bool {
        let low = self.low.at > outer.low.at || self.low.at >= outer.low.at && (self.low.is_open || !outer.low.is_open);
        let high =
            self.high.at < outer.high.at || self.high.at <= outer.high.at && (self.high.is_open || !outer.high.is_open);
        low && high
    }
}

/// Text of the value and its range, for `value > constant` and similar comparisons, with the constant on either side.
fn range(body: &Body, id: ExprId) -> Option<(String, NumberInterval)> {
    let Expr::Binary(op, left, right) = body.expr(body.without_parentheses(id)) else { return None };
    if let Some(at) = body.number(*right) {
        return Some((body.normal_form(*left), compared(*op, at)?));
    }
    let mirrored = match op {
        BinaryOp::Less => BinaryOp::Greater,
        BinaryOp::LessOrEqual => BinaryOp::GreaterOrEqual,
        BinaryOp::Greater => BinaryOp::Less,
        BinaryOp::GreaterOrEqual => BinaryOp::LessOrEqual,
        other => *other,
    };
    Some((body.normal_form(*right), compared(mirrored, body.number(*left)?)?))
}

fn compared(op: BinaryOp, at: f64) -> Option<NumberInterval> {
    let (closed, open) = (Bound { at, is_open: false }, Bound { at, is_open: true });
    let lowest = Bound { at: f64::NEG_INFINITY, is_open: false };
    let highest = Bound { at: f64::INFINITY, is_open: false };
    let (low, high) = match op {
        BinaryOp::Equal => (closed, closed),
        BinaryOp::Less => (lowest, open),
        BinaryOp::LessOrEqual => (lowest, closed),
        BinaryOp::Greater => (open, highest),
        BinaryOp::GreaterOrEqual => (closed, highest),
        _ => return None,
    };
    Some(NumberInterval { low, high })
}

fn word(is_same: bool) -> Wording {
    let message = if is_same {
        "the same condition was tested before, so this block never runs"
    } else {
        "an earlier condition holds whenever this one does, so this block never runs"
    };
    let help = if is_same { "write the condition that was meant" } else { "test the narrower range first" };
    Wording::new(message, "has no effect", help)
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn chain(conditions: [&str; 2]) -> String {
        format!("num n\nnum m\nbool b\nif {}\nput(1)\nelseIf {}\nput(2)\nendIf", conditions[0], conditions[1])
    }

    #[test]
    fn a_repeated_condition_is_reported() {
        expect![[r#"
            start.pgx:7 `(b==true)` the same condition was tested before, so this block never runs
              | has no effect
              ? write the condition that was meant
              > start.pgx:5 `b==true` first test
        "#]]
        .assert_eq(&check(&RULE, &chain(["b==true", "(b==true)"])));
    }

    #[test]
    fn a_range_within_an_earlier_one_is_reported() {
        expect![[r#"
            start.pgx:7 `2<n` an earlier condition holds whenever this one does, so this block never runs
              | has no effect
              ? test the narrower range first
              > start.pgx:5 `n>1` first test
        "#]]
        .assert_eq(&check(&RULE, &chain(["n>1", "2<n"])));
        for pair in [["n>=1", "n==1"], ["n<3", "n<=2.9"], ["n<=3", "n<3"], ["n>1", "n>1.0"]] {
            assert_ne!(check(&RULE, &chain(pair)), "", "{pair:?}");
        }
    }

    #[test]
    fn other_conditions_are_not_reported() {
        let pairs =
            [["n>2", "n>1"], ["n>1", "n>=1"], ["n==1", "n==2"], ["n>1", "m>2"], ["n>1", "n<2"], ["n!=1", "n!=2"]];
        for pair in pairs.into_iter().chain([["getKey()==1", "getKey()==1"], ["b", "!b"], ["n==1", "n>0"]]) {
            assert_eq!(check(&RULE, &chain(pair)), "", "{pair:?}");
        }
    }
}
