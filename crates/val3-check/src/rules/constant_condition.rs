//! V0301: a condition that is always true or always false.

use rustc_hash::FxHashSet;
use val3_analysis::body::{Constant, Expr, ExprId, Stmt, StmtKind};
use val3_analysis::flow::PointKind;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A condition has the same value each time it is evaluated.
    ///
    /// ## Why
    /// One of its branches is never taken. The condition is left over from a test, or it compares the wrong values. The
    /// endless loops `while true` and `until false` are usual and not reported. An `if true` is a switch that
    /// someone turns, and an `if false` that contains only comments disables nothing: neither is reported.
    ///
    /// ## Bad
    /// ```val3
    /// if 1==2
    ///   putln("never")
    /// endIf
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    ///
    /// if nCount==2
    ///   putln("two")
    /// endIf
    /// while true
    ///   delay(1)
    /// endWhile
    /// ```
    V0301 "constant-condition" Warning, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let idle = idle_conditions(program);
    for (_, point) in program.flow().points() {
        let PointKind::Test { condition: Some(condition), is_loop } = point.kind else { continue };
        let Some(Constant::Bool(value)) = program.body.constant(condition) else { continue };
        if !(is_loop && program.is_endless(condition) || idle.contains(&condition)) {
            found.report(&RULE, point.range, word(value));
        }
    }
}

/// Intended literal conditions: a switch `true`, and `false` before comments, which disables nothing.
fn idle_conditions(program: &ProgramView<'_>) -> FxHashSet<ExprId> {
    let arms = program.stmts().iter().flat_map(|stmt| match &stmt.kind {
        StmtKind::If { arms, .. } => arms.as_slice(),
        _ => &[],
    });
    arms.filter_map(|(condition, block)| condition.filter(|id| is_idle(program, *id, block))).collect()
}

fn is_idle(program: &ProgramView<'_>, condition: ExprId, block: &[Stmt]) -> bool {
    match program.body.expr(program.body.without_parentheses(condition)) {
        Expr::Bool(true) => true,
        Expr::Bool(false) => block.is_empty(),
        _ => false,
    }
}

fn word(value: bool) -> Wording {
    Wording::new(
        format!("this condition is always {value}"),
        format!("always {value}"),
        "compare a variable, or remove the test",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn conditions_of_literals_are_reported() {
        expect![[r#"
            start.pgx:5 `1==2` this condition is always false
              | always false
              ? compare a variable, or remove the test
            start.pgx:6 `!(2>3)` this condition is always true
              | always true
              ? compare a variable, or remove the test
            start.pgx:8 `1<2` this condition is always true
              | always true
              ? compare a variable, or remove the test
        "#]]
        .assert_eq(&check(&RULE, "if 1==2\nelseIf !(2>3)\nendIf\nwhile 1<2\nendWhile"));
    }

    fn listing(line: &str) -> String {
        format!("num n\nif n==1\nput(n)\nelseIf (false)\n// put(1)\nendIf\nif false\n{line}\nendIf")
    }

    #[test]
    fn conditions_around_comments_alone_are_not_reported() {
        assert_eq!(check(&RULE, &listing("// put(2)\n\n  // put(3)")), "");
        expect![[r#"
            start.pgx:10 `false` this condition is always false
              | always false
              ? compare a variable, or remove the test
        "#]]
        .assert_eq(&check(&RULE, &listing("// put(2)\nput(3)")));
    }

    #[test]
    fn switches_are_not_reported() {
        assert_eq!(
            check(&RULE, "num n\nif true\nput(n)\nelse\nput(1)\nendIf\nif n==1\nput(1)\nelseIf (true)\nput(2)\nendIf"),
            ""
        );
    }

    #[test]
    fn endless_loops_are_not_reported() {
        assert_eq!(check(&RULE, "while true\ndelay(1)\nendWhile"), "");
        assert_eq!(check(&RULE, "do\ndelay(1)\nuntil (false)"), "");
    }
}
