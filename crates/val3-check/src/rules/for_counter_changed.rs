//! V0305: the counter of a `for` is changed in its block.

use val3_analysis::body::{Body, ExprId, Stmt, StmtKind};

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// The block of a `for` changes the counter as well.
    ///
    /// ## Why
    /// `endFor` adds the step to the current value of the counter, so rounds are skipped or repeated. Setting the
    /// counter to a value that ends the loop is usual and not reported.
    ///
    /// ## Bad
    /// ```val3
    /// num nI
    ///
    /// for nI=0 to 9
    ///   putln(nI)
    ///   nI=nI+1
    /// endFor
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nI
    ///
    /// for nI=0 to 9 step 2
    ///   putln(nI)
    /// endFor
    /// ```
    V0305 "for-counter-changed" Info, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let body = program.body;
    for stmt in program.stmts() {
        let StmtKind::For { counter: Some(counter), block, .. } = &stmt.kind else { continue };
        let name = body.normal_form(*counter);
        for inner in block.iter().flat_map(Stmt::with_inner) {
            let StmtKind::Assign { target, value } = inner.kind else { continue };
            if body.normal_form(target) == name && reads(body, value, &name) {
                found
                    .report(&RULE, inner.range, word(program.text(*counter)))
                    .related(program.range(*counter), "counted by this `for`");
            }
        }
    }
}

fn reads(body: &Body, value: ExprId, counter: &str) -> bool {
    body.within(value).any(|id| body.normal_form(id) == counter)
}

fn word(counter: &str) -> Wording {
    Wording::new(
        format!("the counter `{counter}` is counted in the block of its own `for`"),
        "`endFor` continues counting from here",
        "use `step`, or a `while` that does all the counting itself",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn a_counter_that_the_block_counts_is_reported() {
        expect![[r#"
            start.pgx:7 `n=n+2` the counter `n` is counted in the block of its own `for`
              | `endFor` continues counting from here
              ? use `step`, or a `while` that does all the counting itself
              > start.pgx:5 `n` counted by this `for`
        "#]]
        .assert_eq(&check(&RULE, "num n\nfor n=0 to 9\nif n==3\nn=n+2\nendIf\nendFor"));
    }

    #[test]
    fn a_counter_set_to_end_the_loop_is_not_reported() {
        assert_eq!(check(&RULE, "num n\nfor n=0 to 9\nif n==3\nn=9\nendIf\nendFor\nn=n+1"), "");
    }

    #[test]
    fn another_counted_variable_is_not_reported() {
        assert_eq!(check(&RULE, "num n[2]\nfor n[0]=0 to 9\nn[1]=n[0]+n[1]\nendFor"), "");
    }
}
