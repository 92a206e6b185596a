//! V0236: a result that tells of a failure, not looked at.

use val3_analysis::body::{Expr, StmtKind};
use val3_lang::results::tells;

use crate::diagnostic::Wording;
use crate::lint::{Findings, Program};
use crate::rule::rule;

rule! {
    /// An instruction that can fail stands alone on its line, and nobody looks at its result.
    ///
    /// ## Why
    /// Instructions on libraries, frames and positions raise no run-time error when they fail: their result is the only
    /// sign (6.6, 6.7, 9.4.4, 9.6.3). A library that was not loaded shows later, as error 80 in another place; a frame
    /// or joint position that was not computed keeps its old value, and the arm goes there.
    ///
    /// ## Bad
    /// ```val3
    /// library part "Disk://part/part.pjx"
    ///
    /// part:libLoad("part")
    ///
    /// --- part
    /// public num nWeight
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// library part "Disk://part/part.pjx"
    ///
    /// if part:libLoad("part")!=0
    ///   popUpMsg("part is not loaded")
    /// endIf
    ///
    /// --- part
    /// public num nWeight
    /// ```
    V0236 "result-ignored" Info, Program: check
}

fn check(program: &Program<'_>, found: &mut Findings) {
    for stmt in program.stmts() {
        let StmtKind::Expr(call) = stmt.kind else { continue };
        let Expr::Call(callee, _) = program.body.expr(call) else { continue };
        let (Expr::Name(name) | Expr::Path { item: name, .. }) = program.body.expr(*callee) else { continue };
        if let Some(tells) = tells(name) {
            found.report(&RULE, program.range(*callee), word(name, tells));
        }
    }
}

fn word(name: &str, tells: &str) -> Wording {
    Wording::new(
        format!("nobody looks at the result of `{name}`, the only sign that it failed"),
        format!("yields {tells}"),
        "test the result, or keep it in a variable",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn results_that_are_dropped() {
        expect![[r#"
            start.pgx:5 `setFrame` nobody looks at the result of `setFrame`, the only sign that it failed
              | yields 0, or which point makes no frame
              ? test the result, or keep it in a variable
            start.pgx:6 `pointToJoint` nobody looks at the result of `pointToJoint`, the only sign that it failed
              | yields `false` if the arm cannot reach the point
              ? test the result, or keep it in a variable
        "#]]
        .assert_eq(&check(&RULE, "frame f\npoint p\njoint j\ntool t\nsetFrame(p,p,p,f)\npointToJoint(t,j,p,j)"));
    }

    #[test]
    fn saving_as_a_statement() {
        let listing = "library part \"Disk://part/part.pjx\"\nlibSave()\npart:libSave()\n--- part\npublic num nW";
        assert_eq!(check(&RULE, listing), "");
    }

    #[test]
    fn results_that_are_used() {
        assert_eq!(
            check(
                &RULE,
                "frame f\npoint p\nnum n\nn=libSave()\nif setFrame(p,p,p,f)==0\ncls()\nendIf\nmovej(p,flange,mA)\nmdesc mA"
            ),
            ""
        );
    }
}
