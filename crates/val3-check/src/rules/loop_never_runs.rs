//! V0303: a loop whose block never runs.

use val3_analysis::body::{Constant, ExprId, StmtKind};
use val3_lang::values::printed::num;
use val3_syntax::TextRange;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// The bounds of a `for`, or the condition of a `while`, prevent the loop from ever running.
    ///
    /// ## Why
    /// `for` counts upwards unless a negative `step` is given, so `for nI=9 to 0` does nothing.
    ///
    /// ## Bad
    /// ```val3
    /// num nI
    ///
    /// for nI=9 to 0
    ///   putln(nI)
    /// endFor
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nI
    ///
    /// for nI=9 to 0 step -1
    ///   putln(nI)
    /// endFor
    /// ```
    V0303 "loop-never-runs" Warning, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for stmt in program.stmts() {
        match &stmt.kind {
            StmtKind::For { start: Some(start), stop: Some(stop), step, .. } => {
                check_for(program, [*start, *stop], *step, found);
            }
            StmtKind::While { condition: Some(condition), .. } if is_literally_false(program, *condition) => {
                found.report(&RULE, program.range(*condition), word_while());
            }
            _ => {}
        }
    }
}

fn check_for(program: &ProgramView<'_>, [first, last]: [ExprId; 2], step: Option<ExprId>, found: &mut Findings) {
    let number = |id| program.body.number(id);
    let (Some(start), Some(stop)) = (number(first), number(last)) else { return };
    let Some(by) = step.map_or(Some(1.0), number) else { return };
    if !(by >= 0.0 && start > stop || by < 0.0 && start < stop) {
        return;
    }
    let range = program.range(first).cover(program.range(step.unwrap_or(last)));
    let reported = found.report(&RULE, range, word_for(start, stop, step.map(|_| by)));
    if step.is_none() {
        let end = TextRange::empty(program.range(last).end());
        reported.fix("count downwards", false, [program.write(end, " step -1")]);
    }
}

/// Whether the condition is a literal. Other conditions that are always false are reported as constant conditions.
fn is_literally_false(program: &ProgramView<'_>, condition: ExprId) -> bool {
    program.is_endless(condition) && program.body.constant(condition) == Some(Constant::Bool(false))
}

fn word_for(start: f64, stop: f64, step: Option<f64>) -> Wording {
    let (direction, help) = match step {
        None => ("upwards", "to count downwards, add `step -1`"),
        Some(0.0..) => ("upwards", "to count downwards, make the step negative"),
        Some(_) => ("downwards", "to count upwards, leave `step` out or make it positive"),
    };
    Wording::new(
        format!("this `for` never runs: it counts {direction} from {} to {}", num(start), num(stop)),
        "already past its limit",
        help,
    )
}

fn word_while() -> Wording {
    Wording::new("this `while` never runs", "always false", "remove the loop, or write its condition")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::fix_testing::fixed;
    use crate::lint::testing::check;

    #[test]
    fn reversed_bounds_are_reported() {
        expect![[r#"
            start.pgx:5 `9 to 0` this `for` never runs: it counts upwards from 9 to 0
              | already past its limit
              ? to count downwards, add `step -1`
              ! count downwards (unsafe)
            start.pgx:7 `-1 to -(2+1) step 2` this `for` never runs: it counts upwards from -1 to -3
              | already past its limit
              ? to count downwards, make the step negative
            start.pgx:9 `0 to 9 step -1` this `for` never runs: it counts downwards from 0 to 9
              | already past its limit
              ? to count upwards, leave `step` out or make it positive
        "#]]
        .assert_eq(&check(
            &RULE,
            "num n\nfor n=9 to 0\nendFor\nfor n=-1 to -(2+1) step 2\nendFor\nfor n=0 to 9 step -1\nendFor",
        ));
    }

    #[test]
    fn the_fix_counts_downwards() {
        expect![[r#"
            for n=(9) to 0 step -1
            put(n)
            endFor
            end"#]]
        .assert_eq(&fixed(&RULE, "num n\nfor n=(9) to 0\nput(n)\nendFor"));
    }

    #[test]
    fn other_bounds_are_not_reported() {
        let bounds = ["0 to 0", "9 to 9 step -1", "9 to 0 step -1", "0 to n", "n to 0", "0 to 9", "9 to 0 step n"];
        for bounds in bounds {
            assert_eq!(check(&RULE, &format!("num n\nnum m\nfor m={bounds}\nput(m)\nendFor")), "", "{bounds}");
        }
    }

    #[test]
    fn while_false_is_reported() {
        expect![[r#"
            start.pgx:5 `(false)` this `while` never runs
              | always false
              ? remove the loop, or write its condition
        "#]]
        .assert_eq(&check(&RULE, "while (false)\nput(1)\nendWhile"));
        assert_eq!(check(&RULE, "while true\ndelay(1)\nendWhile\ndo\nput(1)\nuntil true\nwhile 1==2\nendWhile"), "");
    }
}
