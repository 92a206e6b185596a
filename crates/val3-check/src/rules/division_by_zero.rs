//! V0230: a division by a constant 0.

use val3_analysis::body::Expr;
use val3_lang::operators::BinaryOp;
use val3_lang::runtime_errors::DIVISION_BY_ZERO;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::phrase::runtime_error;
use crate::rule::rule;

rule! {
    /// A number is divided by a constant that is 0.
    ///
    /// ## Why
    /// `/` and `%` by 0 are run-time error 10 (3.2.2): the line stops its task whenever it runs.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    ///
    /// nCount=nCount%(2-2)
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    ///
    /// nCount=nCount%2
    /// ```
    V0230 "division-by-zero" Error, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for (_, expr, _) in program.body.exprs() {
        let Expr::Binary(op @ (BinaryOp::Divide | BinaryOp::Remainder), _, right) = expr else { continue };
        if program.body.number(*right) == Some(0.0) {
            found.report(&RULE, program.range(*right), word(op.symbol()));
        }
    }
}

fn word(op: &str) -> Wording {
    Wording::new(format!("the right side of `{op}` is always 0"), runtime_error(DIVISION_BY_ZERO), "")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn constant_zero_divisors_are_reported() {
        expect![[r#"
            start.pgx:5 `0` the right side of `/` is always 0
              | run-time error 10: division by zero
            start.pgx:6 `(3-3)` the right side of `%` is always 0
              | run-time error 10: division by zero
        "#]]
        .assert_eq(&check(&RULE, "num n\nn=1/0\nn=n%(3-3)"));
    }

    #[test]
    fn other_divisors_are_not_reported() {
        assert_eq!(check(&RULE, "num n\nn=1/n\nn=0/2\nn=n%0.5"), "");
    }

    #[test]
    fn a_division_that_is_never_executed_is_not_reported() {
        assert_eq!(
            check(&RULE, "num n\nif false\nn=1/0\nendIf\nif n>1 and (false and 1/0==n)\nendIf\nreturn\nn=1/0"),
            ""
        );
        assert_ne!(check(&RULE, "num n\nif n>1\nn=1/0\nendIf"), "");
        assert_ne!(check(&RULE, "num n\nif true\nn=1/0\nendIf"), "");
    }
}
