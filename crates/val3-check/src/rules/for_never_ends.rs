//! V0304: a `for` with a step of 0.

use val3_analysis::body::{ExprId, StmtKind};

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// The step of a `for` is 0, so the counter never reaches its limit.
    ///
    /// ## Why
    /// The loop ends when the counter has passed the limit. With `step 0` the counter never changes, and the loop never
    /// ends.
    ///
    /// ## Bad
    /// ```val3
    /// num nI
    ///
    /// for nI=0 to 9 step 0
    ///   putln(nI)
    /// endFor
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nI
    ///
    /// for nI=0 to 9 step 1
    ///   putln(nI)
    /// endFor
    /// ```
    V0304 "for-never-ends" Warning, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for stmt in program.stmts() {
        let StmtKind::For { start, stop, step: Some(step), .. } = stmt.kind else { continue };
        if program.body.number(step) == Some(0.0) && !is_past_its_limit(program, start, stop) {
            found.report(&RULE, program.range(step), word());
        }
    }
}

/// Whether the loop never runs, because its first value is beyond its last one. V0303 reports it.
fn is_past_its_limit(program: &ProgramView<'_>, start: Option<ExprId>, stop: Option<ExprId>) -> bool {
    let number = |id: Option<ExprId>| program.body.number(id?);
    number(start).zip(number(stop)).is_some_and(|(start, stop)| start > stop)
}

fn word() -> Wording {
    Wording::new(
        "this `for` never ends: it counts by 0",
        "the counter stays where it starts",
        "count by a number other than 0; for a loop without end write `while true`",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn a_step_of_zero_is_reported() {
        expect![[r#"
            start.pgx:5 `1-1` this `for` never ends: it counts by 0
              | the counter stays where it starts
              ? count by a number other than 0; for a loop without end write `while true`
        "#]]
        .assert_eq(&check(&RULE, "num n\nfor n=0 to 3 step 1-1\ndelay(1)\nendFor"));
        assert_eq!(check(&RULE, "num n\nfor n=3 to 0 step 0\ndelay(1)\nendFor"), "");
        for step in ["", "step 1", "step -1", "step 0.1", "step n"] {
            assert_eq!(check(&RULE, &format!("num n\nnum m\nfor m=0 to 3 {step}\nput(m)\nendFor")), "", "{step}");
        }
    }
}
