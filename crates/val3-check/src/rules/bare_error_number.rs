//! V0720: a run-time error as a number.

use val3_analysis::body::{Expr, ExprId};
use val3_lang::instructions::TASK_STATUS;
use val3_lang::operators::BinaryOp;
use val3_lang::runtime_errors::{RUNTIME_ERRORS, RuntimeError};

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// The number of a run-time error is written in the code.
    ///
    /// ## Why
    /// Few readers know that 20 means an index that is too large. A constant with a name explains it wherever it is
    /// used. The rule only examines comparisons with the status of a task; -1, 0 and 1 are not errors. The rule is off
    /// by default, because it enforces a convention that not every shop has.
    ///
    /// ## Bad
    /// ```val3
    /// if taskStatus("robot")==20
    ///   putln("index")
    /// endIf
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nErrIndex = 20
    ///
    /// if taskStatus("robot")==nErrIndex
    ///   putln("index")
    /// endIf
    /// ```
    V0720 "bare-error-number" Info off, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for (_, expr, _) in program.body.exprs() {
        let Expr::Binary(BinaryOp::Equal | BinaryOp::NotEqual, left, right) = expr else { continue };
        if let Some(error) = error(program, *right).filter(|_| is_status(program, *left)) {
            found.report(&RULE, program.range(*right), word(error));
        }
    }
}

fn is_status(program: &ProgramView<'_>, id: ExprId) -> bool {
    let Expr::Call(callee, _) = program.body.expr(program.body.without_parentheses(id)) else { return false };
    matches!(program.body.expr(*callee), Expr::Name(name) if name == TASK_STATUS)
}

fn error(program: &ProgramView<'_>, id: ExprId) -> Option<&'static RuntimeError> {
    let number = program.body.number(id)?;
    RUNTIME_ERRORS.iter().find(|row| f64::from(row.number) == number)
}

fn word(error: &RuntimeError) -> Wording {
    Wording::new(
        format!("{} is a run-time error: {}", error.number, error.short),
        error.short,
        "declare data with a name for this number, and compare with that",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn error_numbers_compared_with_a_status_are_reported() {
        expect![[r#"
            start.pgx:5 `20` 20 is a run-time error: index too large
              | index too large
              ? declare data with a name for this number, and compare with that
            start.pgx:6 `30` 30 is a run-time error: no such task
              | no such task
              ? declare data with a name for this number, and compare with that
        "#]]
        .assert_eq(&check(&RULE, "if taskStatus(\"a\")==20\nelseIf (taskStatus(\"a\"))!=30\nendIf"));
    }

    #[test]
    fn states_and_other_numbers_are_not_reported() {
        assert_eq!(check(&RULE, "num nA\nif taskStatus(\"a\")==-1 or taskStatus(\"a\")==1 or nA==20\nendIf"), "");
    }
}
