//! V0309: an empty loop used for waiting.

use val3_analysis::body::{Expr, ExprId, Stmt, StmtKind};
use val3_analysis::db::FileEdit;
use val3_lang::instructions::WAIT;
use val3_lang::operators::{BinaryOp, UnaryOp};
use val3_syntax::TextRange;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A loop with an empty block repeats its test until something else changes the condition.
    ///
    /// ## Why
    /// The loop uses up every turn of its task, so that other tasks become slow, including the task it waits for. The
    /// instruction `wait` tests its condition once per turn and lets the other tasks run.
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

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for stmt in program.stmts() {
        let (condition, is_while) = match &stmt.kind {
            StmtKind::While { condition: Some(condition), block } if block.is_empty() => (*condition, true),
            StmtKind::Do { block, condition: Some(condition) } if block.is_empty() => (*condition, false),
            _ => continue,
        };
        if program.body.constant(condition).is_some() || !program.is_pure(condition) {
            continue;
        }
        let edits = edits(program, stmt, condition, is_while);
        found.report(&RULE, program.range(condition), word()).fix("wait for it", true, edits);
    }
}

/// Edits that replace the loop by a `wait`. Empty if they would remove a comment.
fn edits(program: &ProgramView<'_>, stmt: &Stmt, condition: ExprId, is_while: bool) -> Vec<FileEdit> {
    let condition = program.body.without_parentheses(condition);
    let negation = if is_while { negation(program, condition) } else { Negation::Of(condition) };
    let (kept, open, close) = match negation {
        Negation::Of(operand) => (program.body.without_parentheses(operand), "", ""),
        Negation::Flipped(_) => (condition, "", ""),
        Negation::Around => (condition, "!(", ")"),
    };
    let kept = program.range(kept);
    let before = TextRange::new(stmt.range.start(), kept.start());
    let behind = TextRange::new(kept.end(), stmt.range.end());
    let has_comment = [before, behind].into_iter().any(|range| program.slice(range).contains("//"));
    let flip = if let Negation::Flipped(edit) = negation { Some(edit) } else { None };
    if has_comment {
        return Vec::new();
    }
    let (open, close) = (program.write(before, &format!("{WAIT}({open}")), program.write(behind, &format!("{close})")));
    [Some(open), flip, Some(close)].into_iter().flatten().collect()
}

/// Negation of a condition.
enum Negation {
    /// Use this expression, which is the opposite.
    Of(ExprId),
    /// Replace the operator by its opposite.
    Flipped(FileEdit),
    /// Write `!` and put the condition in brackets.
    Around,
}

fn negation(program: &ProgramView<'_>, condition: ExprId) -> Negation {
    let (operator, opposite) = match program.body.expr(condition) {
        Expr::Unary(UnaryOp::Not, operand) => return Negation::Of(*operand),
        Expr::Binary(BinaryOp::Equal, left, right) => (program.operator(*left, *right, "=="), "!="),
        Expr::Binary(BinaryOp::NotEqual, left, right) => (program.operator(*left, *right, "!="), "=="),
        _ => return Negation::Around,
    };
    operator.map_or(Negation::Around, |range| Negation::Flipped(program.write(range, opposite)))
}

fn word() -> Wording {
    Wording::new(
        "this empty loop takes processor time from the task that it waits for",
        "tested again and again without a pause",
        "use `wait(…)`, or `watch(…)` with a time limit",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::fix_testing::fixed;
    use crate::lint::testing::check;

    #[test]
    fn empty_loops_are_reported() {
        expect![[r#"
            start.pgx:5 `d==false` this empty loop takes processor time from the task that it waits for
              | tested again and again without a pause
              ? use `wait(…)`, or `watch(…)` with a time limit
              ! wait for it
            start.pgx:9 `(d)` this empty loop takes processor time from the task that it waits for
              | tested again and again without a pause
              ? use `wait(…)`, or `watch(…)` with a time limit
              ! wait for it
            start.pgx:10 `!(d)` this empty loop takes processor time from the task that it waits for
              | tested again and again without a pause
              ? use `wait(…)`, or `watch(…)` with a time limit
              ! wait for it
        "#]]
        .assert_eq(&check(&RULE, "dio d\nwhile d==false\n\nendWhile\ndo\nuntil (d)\nwhile !(d)\nendWhile"));
    }

    #[test]
    fn the_fix_uses_wait() {
        expect![[r#"
            wait(d!=false)
            wait(d)
            wait(d)
            wait(!(d and d))
            put(1)
            end"#]]
        .assert_eq(&fixed(
            &RULE,
            "dio d\nwhile d==false\n\nendWhile\ndo\nuntil (d)\nwhile !(d)\nendWhile\nwhile d and d\nendWhile\nput(1)",
        ));
    }

    #[test]
    fn the_fix_keeps_a_comment() {
        expect![[r#"
            start.pgx:5 `d` this empty loop takes processor time from the task that it waits for
              | tested again and again without a pause
              ? use `wait(…)`, or `watch(…)` with a time limit
        "#]]
        .assert_eq(&check(&RULE, "dio d\nwhile d\n// until it closes\nendWhile"));
    }

    #[test]
    fn loops_with_statements_are_not_reported() {
        assert_eq!(check(&RULE, "dio d\nwhile d\ndelay(0)\nendWhile"), "");
        assert_eq!(
            check(&RULE, "while getKey()!=-1\nendWhile\nwhile watch(false,1)\nendWhile\ndo\nuntil get()==270"),
            ""
        );
    }
}
