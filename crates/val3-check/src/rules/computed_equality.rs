//! V0233: a computed number tested for equality.

use val3_analysis::body::{Expr, ExprId, StmtKind};
use val3_lang::operators::{BinaryOp, UnaryOp};
use val3_lang::results::is_rounded;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::{Severity, rule};

rule! {
    /// A number that was computed with fractions is compared with `==` or `!=`.
    ///
    /// ## Why
    /// Numbers have about 14 digits (3.2.1). The results of divisions, roots, angles and clocks are rounded, so two
    /// computations of the same number rarely give exactly the same value. Compare within a tolerance instead. Counters
    /// and other whole numbers are exact and not reported. A variable that counts in steps such as 0.1 is reported too,
    /// as a warning: 0.1 has no exact binary form, and a loop that waits for 1 does not end.
    ///
    /// ## Bad
    /// ```val3
    /// num nAngle
    ///
    /// if cos(nAngle)==0
    ///   putln("upright")
    /// endIf
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nAngle
    ///
    /// if abs(cos(nAngle))<1e-10
    ///   putln("upright")
    /// endIf
    /// ```
    V0233 "computed-equality" Info, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for (_, expr, range) in program.body.exprs() {
        let Expr::Binary(op @ (BinaryOp::Equal | BinaryOp::NotEqual), left, right) = expr else { continue };
        let sides = [*left, *right];
        if let Some(side) = sides.into_iter().find(|side| is_inexact(program, *side)) {
            found.report(&RULE, range, word(op.symbol(), program.text(side)));
        } else if let Some((side, step)) = sides.into_iter().find_map(|side| Some((side, counted_by(program, side)?))) {
            found
                .report(&RULE, range, word_counter(op.symbol(), program.text(side), program.text(step)))
                .level(Severity::Warning)
                .related(program.range(step), "counts here");
        }
    }
}

/// Step in a line `x=x+0.1` for a variable, if the step is a fraction without an exact binary form.
fn counted_by(program: &ProgramView<'_>, variable: ExprId) -> Option<ExprId> {
    program.effects.root(variable)?;
    program.stmts().iter().find_map(|stmt| {
        let StmtKind::Assign { target, value } = stmt.kind else { return None };
        let Expr::Binary(BinaryOp::Add | BinaryOp::Subtract, before, step) =
            program.body.expr(program.body.without_parentheses(value))
        else {
            return None;
        };
        let counts = is_fraction(program, *step) && program.is_same(target, *before);
        (counts && program.is_same(target, variable)).then_some(*step)
    })
}

/// Whether the number is rounded. A number that is written in the code is exact.
fn is_inexact(program: &ProgramView<'_>, id: ExprId) -> bool {
    match program.body.expr(id) {
        _ if program.body.number(id).is_some() => false,
        Expr::Paren(inner) | Expr::Unary(UnaryOp::Negate, inner) => is_inexact(program, *inner),
        Expr::Binary(BinaryOp::Divide, _, divisor) => !halves(program, *divisor),
        Expr::Binary(BinaryOp::Add | BinaryOp::Subtract | BinaryOp::Multiply, left, right) => {
            [left, right].into_iter().any(|side| is_inexact(program, *side) || is_fraction(program, *side))
        }
        Expr::Call(callee, _) => matches!(program.body.expr(*callee), Expr::Name(name) if is_rounded(name)),
        _ => false,
    }
}

/// Whether the division is exact because the divisor is 2, 4, 8 …
fn halves(program: &ProgramView<'_>, divisor: ExprId) -> bool {
    program.body.number(divisor).is_some_and(|number| number.abs() >= 1.0 && number.abs().log2().fract() == 0.0)
}

/// Whether the constant has no exact binary form, for example 0.1.
fn is_fraction(program: &ProgramView<'_>, id: ExprId) -> bool {
    const BINARY_PLACES: f64 = 1024.0;
    program.body.number(id).is_some_and(|number| (number * BINARY_PLACES).fract() != 0.0)
}

fn word_counter(op: &str, side: &str, step: &str) -> Wording {
    Wording::new(
        format!("`{op}` compares `{side}`, which counts in steps of {step}"),
        "sums of fractions are rarely exactly equal",
        "count in whole numbers, or compare with `<` or `>`",
    )
}

fn word(op: &str, side: &str) -> Wording {
    Wording::new(
        format!("`{op}` compares `{side}`, which is rounded"),
        "rounded numbers are rarely exactly equal",
        "compare the difference: `abs(…-…)<1e-6`",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn rounded_numbers_are_reported() {
        expect![[r#"
            start.pgx:5 `n/3==1` `==` compares `n/3`, which is rounded
              | rounded numbers are rarely exactly equal
              ? compare the difference: `abs(…-…)<1e-6`
            start.pgx:6 `sqrt(n)!=2` `!=` compares `sqrt(n)`, which is rounded
              | rounded numbers are rarely exactly equal
              ? compare the difference: `abs(…-…)<1e-6`
            start.pgx:7 `1==(n*0.1)` `==` compares `(n*0.1)`, which is rounded
              | rounded numbers are rarely exactly equal
              ? compare the difference: `abs(…-…)<1e-6`
            start.pgx:8 `clock()-n==2` `==` compares `clock()-n`, which is rounded
              | rounded numbers are rarely exactly equal
              ? compare the difference: `abs(…-…)<1e-6`
        "#]]
        .assert_eq(&check(&RULE, "num n\nbool b\nb=n/3==1\nb=sqrt(n)!=2\nb=1==(n*0.1)\nb=clock()-n==2"));
    }

    #[test]
    fn exact_numbers_are_not_reported() {
        assert_eq!(
            check(&RULE, "num n\nbool b\nb=n==0.1\nb=n%2==1\nb=n/2==4\nb=n+1!=3\nb=round(n/3)==1\nb=n*0.5==1\nb=n/3>1"),
            ""
        );
    }

    #[test]
    fn counters_in_steps_of_fractions_are_reported() {
        expect![[r#"
            start.pgx:8 `nA==1` `==` compares `nA`, which counts in steps of 0.1
              | sums of fractions are rarely exactly equal
              ? count in whole numbers, or compare with `<` or `>`
              > start.pgx:6 `0.1` counts here
        "#]]
        .assert_eq(&check(&RULE, "num nA\nnum nB\ndo\nnA=nA+0.1\nnB=nB+0.5\nuntil nA==1 or nB==1"));
        assert_eq!(check(&RULE, "num nA\nnA=0.3\nif nA==0.3\nput(nA)\nendIf"), "");
    }
}
