//! V0313: a program with too many paths.

use val3_analysis::body::{Expr, ExprId};
use val3_analysis::flow::PointKind;
use val3_analysis::items::declarations;
use val3_lang::operators::BinaryOp;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// The cyclomatic complexity of a program, the number of its decisions plus one, is above
    /// the option `complexity` (20).
    ///
    /// ## Why
    /// Every decision can double the number of paths that must be understood and tested. Move parts of the program into
    /// separate programs. A decision is an `if`, `elseIf`, `while`, `until`, `for` or `case`, and an `and` or `or` in a
    /// condition.
    ///
    /// ## Bad
    /// ```val3
    /// bool bA[22]
    ///
    /// if bA[0] or bA[1] or bA[2] or bA[3] or bA[4] or bA[5] or bA[6] or bA[7] or bA[8] or bA[9] or bA[10]
    ///   putln("first half")
    /// elseIf bA[11] or bA[12] or bA[13] or bA[14] or bA[15] or bA[16] or bA[17] or bA[18] or bA[19] or bA[20]
    ///   putln("second half")
    /// endIf
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// bool bA[22]
    /// num nI
    ///
    /// for nI=0 to 20
    ///   if bA[nI]
    ///     putln(nI)
    ///   endIf
    /// endFor
    /// ```
    V0313 "complexity" Info off, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let decisions: usize = program.flow().points().map(|(_, point)| decisions(program, &point.kind)).sum();
    let limit = program.options.complexity;
    if decisions + 1 > limit
        && let Some(place) = declarations::program(program.db, program.file)
    {
        found.report(&RULE, place.range, word(program.name(), decisions + 1, limit));
    }
}

fn decisions(program: &ProgramView<'_>, kind: &PointKind) -> usize {
    match kind {
        PointKind::Test { condition, .. } => 1 + condition.map_or(0, |condition| combinations(program, condition)),
        PointKind::ForTest { .. } => 1,
        PointKind::Switch { values, .. } => values.len(),
        _ => 0,
    }
}

/// Number of `and` and `or` in a condition.
fn combinations(program: &ProgramView<'_>, condition: ExprId) -> usize {
    let parts = program.body.within(condition);
    parts.filter(|id| matches!(program.body.expr(*id), Expr::Binary(BinaryOp::And | BinaryOp::Or, ..))).count()
}

fn word(program: &str, complexity: usize, limit: usize) -> Wording {
    Wording::new(
        format!("the program `{program}` has a complexity of {complexity}, more than {limit}"),
        "many decisions",
        "move parts of it into programs of their own",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn ifs(count: usize) -> String {
        format!("bool b\n{}", "if b and b\nput(1)\nendIf\n".repeat(count))
    }

    fn switch_with_cases(count: usize) -> String {
        let values: Vec<String> = (0..count).map(|value| value.to_string()).collect();
        format!("num n\nswitch n\ncase {}\nput(1)\nbreak\nendSwitch", values.join(","))
    }

    #[test]
    fn decisions_are_counted() {
        assert_eq!(check(&RULE, &format!("{}do\nuntil b", ifs(9))), "");
        expect![[r#"
            start.pgx:3 `start` the program `start` has a complexity of 22, more than 20
              | many decisions
              ? move parts of it into programs of their own
        "#]]
        .assert_eq(&check(&RULE, &format!("{}do\nuntil b", ifs(10))));
        assert_eq!(check(&RULE, &switch_with_cases(19)), "");
        assert_ne!(check(&RULE, &switch_with_cases(20)), "");
    }
}
