//! V0328: a wait for a key that an earlier keystroke may end.

use val3_analysis::body::{Expr, ExprId, StmtKind};
use val3_lang::instruction::Family;
use val3_lang::instructions::{self, GET_KEY};
use val3_lang::operators::BinaryOp;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A program waits for a key with `getKey` but has not cleared an earlier keystroke.
    ///
    /// ## Why
    /// `getKey` returns the last key since its previous call, however long ago the key was pressed (4.3). A key pressed
    /// minutes ago ends the wait immediately. A line that contains only `getKey()` clears it.
    ///
    /// ## Bad
    /// ```val3
    /// putln("press a key")
    /// wait(getKey()!=-1)
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// putln("press a key")
    /// getKey()
    /// wait(getKey()!=-1)
    /// ```
    V0328 "key-not-cleared" Info, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    // After any earlier read, the key counts as cleared.
    let Some(first) = program.calls_of(GET_KEY).map(|call| call.id).min() else { return };
    for stmt in program.stmts() {
        let (condition, ends_when) = match &stmt.kind {
            StmtKind::While { condition: Some(condition), .. } => (*condition, false),
            StmtKind::Do { condition: Some(condition), .. } => (*condition, true),
            StmtKind::Expr(call) => match waited(program, *call) {
                Some(condition) => (condition, true),
                None => continue,
            },
            _ => continue,
        };
        if awaited(program, condition, ends_when) == Some(first) {
            let edit = program.site(stmt.range).line_before(&format!("{GET_KEY}()"));
            let title = format!("write `{GET_KEY}()` before");
            found.report(&RULE, program.range(condition), word()).fix(title, false, [edit]);
        }
    }
}

/// Condition of `wait(…)` or `watch(…)`.
fn waited(program: &ProgramView<'_>, call: ExprId) -> Option<ExprId> {
    let Expr::Call(callee, args) = program.body.expr(call) else { return None };
    let Expr::Name(name) = program.body.expr(*callee) else { return None };
    let instruction = instructions::find(name)?;
    let waits = instruction.family == Family::Tasks && instruction.blocking;
    args.first().copied().filter(|_| waits)
}

/// The `getKey()` that `condition` compares so that a key ends the wait. `ends_when` is the value of the condition that
/// ends it.
fn awaited(program: &ProgramView<'_>, condition: ExprId, ends_when: bool) -> Option<ExprId> {
    let Expr::Binary(op, left, right) = program.body.expr(program.body.without_parentheses(condition)) else {
        return None;
    };
    let equal = match op {
        BinaryOp::Equal => true,
        BinaryOp::NotEqual => false,
        _ => return None,
    };
    let is_no_key = program.body.number(*right)? < 0.0;
    let key = program.body.without_parentheses(*left);
    // Waiting for "no key" clears the key.
    ((equal == ends_when) != is_no_key).then_some(key)
}

fn word() -> Wording {
    Wording::new(
        "a key that was pressed earlier ends this wait immediately",
        "the earlier key is not cleared",
        format!("write `{GET_KEY}()` on a line of its own before the wait"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn waits_for_a_key_are_reported() {
        let waits = ["wait(getKey()!=-1)", "while (getKey()==-1)\ndelay(0)\nendWhile", "wait((getKey())==277)"];
        for wait in waits {
            assert!(check(&RULE, wait).contains("a key that was pressed earlier"), "{wait}");
        }
        expect![[r#"
            start.pgx:7 `getKey()==270` a key that was pressed earlier ends this wait immediately
              | the earlier key is not cleared
              ? write `getKey()` on a line of its own before the wait
              ! write `getKey()` before (unsafe)
        "#]]
        .assert_eq(&check(&RULE, "do\ndelay(0)\nuntil getKey()==270"));
    }

    #[test]
    fn waits_after_a_reading_and_for_no_key_are_not_reported() {
        let waits = [
            "getKey()\nwait(getKey()!=-1)",
            "wait(getKey()==-1)\nwait(getKey()==277)",
            "num n\nn=getKey()\nwhile getKey()!=270\ndelay(0)\nendWhile",
            "num n\ndo\nn=getKey()\nuntil n!=-1",
            "while get()!=270\nendWhile",
        ];
        for wait in waits {
            assert_eq!(check(&RULE, wait), "", "{wait}");
        }
    }
}
