//! V0309: an empty loop that waits for something.

use val3_analysis::body::{Body, Expr, ExprId, Stmt, StmtKind};
use val3_lang::operators::UnaryOp;
use val3_syntax::TextRange;

use crate::diagnostic::Wording;
use crate::lint::{Findings, Program};
use crate::rule::rule;

rule! {
    /// A loop without a line in it asks its condition over and over until something else changes it.
    ///
    /// ## Why
    /// The loop takes all the time it can get from the other tasks, among them the one it waits for. The instruction
    /// `wait` asks once a turn and lets the others run.
    ///
    /// ## Bad
    /// ```val3
    /// dio diPart
    ///
    /// while diPart==false
    /// endWhile
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// dio diPart
    ///
    /// wait(diPart==true)
    /// ```
    V0309 "busy-wait" Warning, Program: check
}

fn check(program: &Program<'_>, found: &mut Findings) {
    for stmt in program.body.stmts() {
        let (condition, is_while) = match &stmt.kind {
            StmtKind::While { condition: Some(condition), block } if block.is_empty() => (*condition, true),
            StmtKind::Do { block, condition: Some(condition) } if block.is_empty() => (*condition, false),
            _ => continue,
        };
        if program.body.constant(condition).is_some() || !program.is_pure(condition) {
            continue;
        }
        let edits = edits(program, stmt, condition, is_while);
        let reported = found.report(&RULE, program.range(condition), word());
        if let Some(edits) = edits {
            reported.fix("wait for it", true, edits);
        }
    }
}

/// What makes the loop a `wait`; nothing where a comment would be lost.
fn edits(program: &Program<'_>, stmt: &Stmt, condition: ExprId, is_while: bool) -> Option<Vec<(TextRange, String)>> {
    let negated = is_while.then(|| operand_of_not(program.body, condition));
    let asked = program.range(negated.flatten().unwrap_or(condition));
    let before = TextRange::new(stmt.range.start(), asked.start());
    let behind = TextRange::new(asked.end(), stmt.range.end());
    let has_comment = [before, behind].into_iter().any(|range| program.text_at(range).contains("//"));
    let (open, close) = if negated == Some(None) { ("wait(!(", "))") } else { ("wait(", ")") };
    (!has_comment).then(|| vec![(before, open.to_owned()), (behind, close.to_owned())])
}

/// The operand of `!x`.
fn operand_of_not(body: &Body, condition: ExprId) -> Option<ExprId> {
    match body.expr(body.peel(condition)) {
        Expr::Unary(UnaryOp::Not, operand) => Some(*operand),
        _ => None,
    }
}

fn word() -> Wording {
    Wording::new(
        "this empty loop waits, and takes time from what it waits for",
        "asked over and over",
        "use `wait(…)`, or `watch(…)` with a time limit",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn empty_loops() {
        expect![[r#"
            start.pgx:5 `d==false` this empty loop waits, and takes time from what it waits for
              | asked over and over
              ? use `wait(…)`, or `watch(…)` with a time limit
              ! wait for it
            start.pgx:9 `(d)` this empty loop waits, and takes time from what it waits for
              | asked over and over
              ? use `wait(…)`, or `watch(…)` with a time limit
              ! wait for it
            start.pgx:10 `!(d)` this empty loop waits, and takes time from what it waits for
              | asked over and over
              ? use `wait(…)`, or `watch(…)` with a time limit
              ! wait for it
        "#]].assert_eq(&check(&RULE, "dio d\nwhile d==false\n\nendWhile\ndo\nuntil (d)\nwhile !(d)\nendWhile"));
    }

    #[test]
    fn a_comment_is_kept() {
        expect![[r#"
            start.pgx:5 `d` this empty loop waits, and takes time from what it waits for
              | asked over and over
              ? use `wait(…)`, or `watch(…)` with a time limit
        "#]].assert_eq(&check(&RULE, "dio d\nwhile d\n// until it closes\nendWhile"));
    }

    #[test]
    fn loops_that_do_something() {
        assert_eq!(check(&RULE, "dio d\nwhile d\ndelay(0)\nendWhile"), "");
        assert_eq!(check(&RULE, "while getKey()!=-1\nendWhile\nwhile watch(false,1)\nendWhile\ndo\nuntil get()==270"), "");
    }
}
