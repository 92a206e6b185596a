//! V0315: a nested `for` with the same counter.

use val3_analysis::body::{Stmt, StmtKind};

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A `for` inside another `for` uses the same counter.
    ///
    /// ## Why
    /// When the inner loop has ended, the counter is past the inner limit, and the outer loop continues from that
    /// value: it ends early or never ends.
    ///
    /// ## Bad
    /// ```val3
    /// num nI
    /// num nGrid[3,3]
    ///
    /// for nI=0 to 2
    ///   for nI=0 to 2
    ///     nGrid[nI,nI]=0
    ///   endFor
    /// endFor
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nI
    /// num nJ
    /// num nGrid[3,3]
    ///
    /// for nI=0 to 2
    ///   for nJ=0 to 2
    ///     nGrid[nI,nJ]=0
    ///   endFor
    /// endFor
    /// ```
    V0315 "for-counter-reused" Warning, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for stmt in program.stmts() {
        let StmtKind::For { counter: Some(outer), block, .. } = &stmt.kind else { continue };
        for inside in block.iter().flat_map(Stmt::with_inner) {
            let StmtKind::For { counter: Some(inner), .. } = inside.kind else { continue };
            if program.body.is_same(*outer, inner) {
                found
                    .report(&RULE, program.range(inner), word(program.text(inner)))
                    .related(program.range(*outer), "the outer `for` counts with it");
            }
        }
    }
}

fn word(counter: &str) -> Wording {
    Wording::new(
        format!("`{counter}` already counts the `for` around this one"),
        "counted twice",
        "use a different counter for each loop",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn a_nested_loop_with_the_same_counter_is_reported() {
        expect![[r#"
            start.pgx:7 `n` `n` already counts the `for` around this one
              | counted twice
              ? use a different counter for each loop
              > start.pgx:5 `n` the outer `for` counts with it
        "#]]
        .assert_eq(&check(&RULE, "num n\nfor n=0 to 2\nif n==1\nfor n=0 to 3\nput(n)\nendFor\nendIf\nendFor"));
    }

    #[test]
    fn consecutive_loops_may_share_a_counter() {
        assert_eq!(check(&RULE, "num n\nfor n=0 to 2\nput(n)\nendFor\nfor n=0 to 3\nput(n)\nendFor"), "");
    }
}
