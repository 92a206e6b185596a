//! V0238: the same operand on both sides of an operator.

use val3_analysis::body::{Expr, ExprId};
use val3_lang::operators::BinaryOp;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// Both sides of an operator are the same.
    ///
    /// ## Why
    /// The result does not depend on the values: a comparison is always true or always false, `a and a` is `a`, a
    /// difference is 0. One of the operands was meant to be something else.
    ///
    /// ## Bad
    /// ```val3
    /// bool bLeft
    /// bool bRight
    ///
    /// bRight=bLeft
    /// if bLeft==true and bLeft==true
    ///   putln("both doors are closed")
    /// endIf
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// bool bLeft
    /// bool bRight
    ///
    /// if bLeft==true and bRight==true
    ///   putln("both doors are closed")
    /// endIf
    /// ```
    V0238 "same-operands" Warning, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for (_, expr, _) in program.body.exprs() {
        let Expr::Binary(op, left, right) = expr else { continue };
        let Some(outcome) = outcome(*op) else { continue };
        // The rule about constant conditions reports constants.
        let repeated = repeated(program, *op, *left, *right).filter(|first| program.body.constant(*first).is_none());
        if let Some(first) = repeated {
            let wording = word(op.symbol(), outcome, program.text(*right));
            found.report(&RULE, program.range(*right), wording).related(program.range(first), "the same");
        }
    }
}

/// Equal operand before `right`. In `a and b and a`, it may be any earlier operand.
fn repeated(program: &ProgramView<'_>, op: BinaryOp, left: ExprId, right: ExprId) -> Option<ExprId> {
    if program.is_same(left, right) {
        return Some(left);
    }
    let is_chain = matches!(op, BinaryOp::And | BinaryOp::Or);
    let before =
        std::iter::successors(Some(left), |id| match program.body.expr(program.body.without_parentheses(*id)) {
            Expr::Binary(inner, first, _) if *inner == op && is_chain => Some(*first),
            _ => None,
        });
    before.take(LONGEST_CHAIN).find_map(|id| match program.body.expr(program.body.without_parentheses(id)) {
        Expr::Binary(inner, first, second) if *inner == op && is_chain => {
            [*second, *first].into_iter().find(|side| program.is_same(*side, right))
        }
        _ => None,
    })
}

/// Maximum distance of compared operands, so that the time stays proportional to the length of the text.
const LONGEST_CHAIN: usize = 16;

/// Result of the operator for two equal operands. `None` if the comparison may be intended.
fn outcome(op: BinaryOp) -> Option<&'static str> {
    Some(match op {
        BinaryOp::Equal | BinaryOp::GreaterOrEqual | BinaryOp::LessOrEqual => "is always true",
        BinaryOp::NotEqual | BinaryOp::Greater | BinaryOp::Less | BinaryOp::Xor => "is always false",
        BinaryOp::And | BinaryOp::Or => "tests the same condition twice",
        BinaryOp::Subtract | BinaryOp::Remainder => "is always 0",
        BinaryOp::Divide => "is always 1",
        BinaryOp::Add | BinaryOp::Multiply => return None,
    })
}

fn word(op: &str, outcome: &str, operand: &str) -> Wording {
    Wording::new(format!("`{operand}` is on both sides of `{op}`"), outcome, "")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn equal_operands_are_reported() {
        expect![[r#"
            start.pgx:5 `n[0]` `n[0]` is on both sides of `==`
              | is always true
              > start.pgx:5 `n[0]` the same
            start.pgx:6 `(b)` `(b)` is on both sides of `and`
              | tests the same condition twice
              > start.pgx:6 `b` the same
            start.pgx:7 `n[1]` `n[1]` is on both sides of `-`
              | is always 0
              > start.pgx:7 `n[1]` the same
            start.pgx:8 `n[0]<1` `n[0]<1` is on both sides of `or`
              | tests the same condition twice
              > start.pgx:8 `n[0]<1` the same
        "#]]
        .assert_eq(&check(
            &RULE,
            "num n[2]\nbool b\nb=n[0]==n[0]\nb=b and (b)\nn[0]=n[1]-n[1]\nb=n[0]<1 or b or n[0]<1",
        ));
    }

    #[test]
    fn different_operands_are_not_reported() {
        assert_eq!(
            check(
                &RULE,
                "num n[2]\nbool b\nb=n[0]==n[1]\nn[0]=n[1]*n[1]\nb=clock()==clock()\nb=get()==1 or get()==1\nb=1==1"
            ),
            ""
        );
    }
}
