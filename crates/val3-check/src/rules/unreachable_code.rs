//! V0302: unreachable code.

use rustc_hash::FxHashSet;
use val3_analysis::body::{ExprId, StmtKind};
use val3_analysis::flow::{FlowNode, PointKind};
use val3_syntax::{TextRange, TextSize};

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A line can never run: it follows `return` or an endless loop.
    ///
    /// ## Why
    /// The line was meant to run. Usually the `return` is one line too early or outside its `if`, or an endless loop
    /// precedes the lines that clean up. Only the first of several unreachable lines is marked.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    ///
    /// if nCount>3
    ///   return
    ///   nCount=0
    /// endIf
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    ///
    /// if nCount>3
    ///   nCount=0
    ///   return
    /// endIf
    /// ```
    V0302 "unreachable-code" Warning, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let flow = program.flow();
    let endless: FxHashSet<ExprId> =
        program.stmts().iter().copied().filter_map(|stmt| program.endless_condition(stmt)).collect();
    // A block with another constant condition is reported at the condition.
    let reached = flow.reachable(|point, branch| !is_test_of(point, &endless) || program.is_taken(point, branch));
    let mut is_stretch = false;
    for (id, point) in flow.points().skip(2).filter(|(_, point)| point.kind != PointKind::Empty) {
        let is_dead = !reached.get(id.index()).copied().unwrap_or(true);
        if is_dead && !is_stretch {
            let reported = found.report(&RULE, point.range, word());
            if let Some((range, what)) = barrier(program, point.range.start()) {
                reported.related(range, what);
            }
        }
        is_stretch = is_dead;
    }
}

/// Whether the flow node tests one of the conditions.
fn is_test_of(point: &FlowNode, conditions: &FxHashSet<ExprId>) -> bool {
    matches!(point.kind, PointKind::Test { condition: Some(condition), .. } if conditions.contains(&condition))
}

/// Last `return` or endless loop before a position that is never reached.
fn barrier(program: &ProgramView<'_>, dead: TextSize) -> Option<(TextRange, &'static str)> {
    let before = program.stmts().iter().filter(|stmt| stmt.range.end() <= dead);
    let barriers = before.filter_map(|stmt| match (program.endless_condition(stmt), &stmt.kind) {
        (Some(condition), _) => Some((stmt.range.end(), program.range(condition), "this loop never ends")),
        (None, StmtKind::Return) => Some((stmt.range.end(), stmt.range, "the program is left here")),
        _ => None,
    });
    barriers.max_by_key(|(end, ..)| *end).map(|(_, range, what)| (range, what))
}

fn word() -> Wording {
    Wording::new(
        "this line is never reached",
        "unreachable",
        "remove it, or move it before the `return` or the loop that keeps the program from it",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn code_after_return_is_reported() {
        expect![[r#"
            start.pgx:7 `n=2` this line is never reached
              | unreachable
              ? remove it, or move it before the `return` or the loop that keeps the program from it
              > start.pgx:6 `return` the program is left here
            start.pgx:12 `for n=1 to 3` this line is never reached
              | unreachable
              ? remove it, or move it before the `return` or the loop that keeps the program from it
              > start.pgx:10 `return` the program is left here
        "#]]
        .assert_eq(&check(
            &RULE,
            "num n\nif n==1\nreturn\nn=2\nn=3\nelse\nreturn\nendIf\nfor n=1 to 3\nput(n)\nendFor",
        ));
    }

    #[test]
    fn code_after_an_endless_loop_is_reported() {
        expect![[r#"
            start.pgx:8 `put(1)` this line is never reached
              | unreachable
              ? remove it, or move it before the `return` or the loop that keeps the program from it
              > start.pgx:5 `true` this loop never ends
        "#]]
        .assert_eq(&check(&RULE, "while true\ndelay(1)\nendWhile\nput(1)\nput(2)"));
        expect![[r#"
            start.pgx:8 `put(1)` this line is never reached
              | unreachable
              ? remove it, or move it before the `return` or the loop that keeps the program from it
              > start.pgx:7 `false` this loop never ends
        "#]]
        .assert_eq(&check(&RULE, "do\ndelay(1)\nuntil false\nput(1)"));
    }

    #[test]
    fn code_after_a_loop_that_ends_is_not_reported() {
        assert_eq!(check(&RULE, "num n\nwhile true\nif n==1\nreturn\nendIf\ndelay(1)\nendWhile"), "");
        assert_eq!(check(&RULE, "num n\nwhile n<3\nn=n+1\nendWhile\nput(n)"), "");
        assert_eq!(check(&RULE, "return"), "");
        assert_eq!(check(&RULE, "while false\nput(1)\nendWhile\nif 1==2\nput(1)\nendIf"), "");
    }

    #[test]
    fn the_condition_of_a_loop_that_never_repeats_is_reported() {
        expect![[r#"
            start.pgx:8 `n==3` this line is never reached
              | unreachable
              ? remove it, or move it before the `return` or the loop that keeps the program from it
              > start.pgx:7 `return` the program is left here
        "#]]
        .assert_eq(&check(&RULE, "num n\ndo\nput(n)\nreturn\nuntil n==3"));
    }
}
