//! V0236: an ignored result that reports failures.

use val3_analysis::body::{Expr, StmtKind};
use val3_lang::results::result_meaning;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// An instruction that can fail is called on a line of its own, and its result is ignored.
    ///
    /// ## Why
    /// Instructions on libraries, frames and positions raise no run-time error when they fail: only the result reports
    /// it (6.6, 6.7, 9.4.4, 9.6.3). A library that was not loaded causes error 80 later and in another place. A frame
    /// or joint position that was not computed keeps its old value, and the arm moves there.
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

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for stmt in program.stmts() {
        let StmtKind::Expr(call) = stmt.kind else { continue };
        let Expr::Call(callee, _) = program.body.expr(call) else { continue };
        let (Expr::Name(name) | Expr::Path { item: name, .. }) = program.body.expr(*callee) else { continue };
        if let Some(result_meaning) = result_meaning(name) {
            found.report(&RULE, program.range(*callee), word(name, result_meaning));
        }
    }
}

fn word(name: &str, result_meaning: &str) -> Wording {
    Wording::new(
        format!("the result of `{name}` is ignored, and only it reports a failure"),
        format!("yields {result_meaning}"),
        "test the result, or store it in a variable",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn ignored_results_are_reported() {
        expect![[r#"
            start.pgx:5 `setFrame` the result of `setFrame` is ignored, and only it reports a failure
              | yields 0, or which point makes no frame
              ? test the result, or store it in a variable
            start.pgx:6 `pointToJoint` the result of `pointToJoint` is ignored, and only it reports a failure
              | yields `false` if the arm cannot reach the point
              ? test the result, or store it in a variable
        "#]]
        .assert_eq(&check(&RULE, "frame f\npoint p\njoint j\ntool t\nsetFrame(p,p,p,f)\npointToJoint(t,j,p,j)"));
    }

    #[test]
    fn saving_a_library_as_a_statement_is_not_reported() {
        let listing = "library part \"Disk://part/part.pjx\"\nlibSave()\npart:libSave()\n--- part\npublic num nW";
        assert_eq!(check(&RULE, listing), "");
    }

    #[test]
    fn used_results_are_not_reported() {
        assert_eq!(
            check(
                &RULE,
                "frame f\npoint p\nnum n\nn=libSave()\nif setFrame(p,p,p,f)==0\ncls()\nendIf\nmovej(p,flange,mA)\nmdesc mA"
            ),
            ""
        );
    }
}
