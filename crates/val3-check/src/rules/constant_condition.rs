//! V0301: a condition that is always true or always false.

use val3_analysis::body::Constant;
use val3_analysis::flow::PointKind;

use crate::diagnostic::Wording;
use crate::lint::{Findings, Program};
use crate::rule::rule;

rule! {
    /// A condition has the same value whenever it is asked.
    ///
    /// ## Why
    /// One of its ways is never taken, so it is either left over from a test or compares the wrong things. The
    /// endless loops `while true` and `until false` are usual and not reported.
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

fn check(program: &Program<'_>, found: &mut Findings) {
    for (_, point) in program.flow().points() {
        let PointKind::Test { condition: Some(condition), is_loop } = point.kind else { continue };
        let Some(Constant::Bool(value)) = program.body.constant(condition) else { continue };
        if !(is_loop && program.is_endless(condition)) {
            found.report(&RULE, point.range, word(value));
        }
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
    fn made_of_literals() {
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

    #[test]
    fn loops_without_end_are_meant() {
        assert_eq!(check(&RULE, "while true\ndelay(1)\nendWhile"), "");
        assert_eq!(check(&RULE, "do\ndelay(1)\nuntil (false)"), "");
    }
}
