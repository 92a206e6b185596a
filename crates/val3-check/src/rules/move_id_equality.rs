//! V0232: a move id compared with `==` or `!=`.

use val3_analysis::body::{Expr, ExprId, StmtKind};
use val3_lang::instructions::GET_MOVE_ID;
use val3_lang::operators::BinaryOp;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// The result of `getMoveId()` is tested for equality.
    ///
    /// ## Why
    /// The move id grows with the movement and has a fraction (10.6): it may jump from 11.998 to 12.013 without being
    /// exactly 12. A `wait(getMoveId()==12)` may never end.
    ///
    /// ## Bad
    /// ```val3
    /// wait(getMoveId()==12)
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// wait(getMoveId()>=12)
    /// ```
    V0232 "move-id-equality" Warning, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for (_, expr, range) in program.body.exprs() {
        let Expr::Binary(op @ (BinaryOp::Equal | BinaryOp::NotEqual), left, right) = expr else { continue };
        if !is_move_id(program, *left) && !is_move_id(program, *right) {
            continue;
        }
        let instead = instead(*op, is_move_id(program, *left));
        let reported = found.report(&RULE, range, word(op.symbol(), instead));
        let edit = program.operator(*left, *right, op.symbol()).map(|op| program.site(op).replace(op, instead));
        reported.fix(format!("write `{instead}`"), false, edit);
    }
    for stmt in program.stmts() {
        if let StmtKind::Switch { selector: Some(selector), .. } = stmt.kind
            && is_move_id(program, selector)
        {
            found.report(&RULE, program.range(selector), word("case", ">="));
        }
    }
}

fn is_move_id(program: &ProgramView<'_>, id: ExprId) -> bool {
    match program.body.expr(program.body.without_parentheses(id)) {
        Expr::Call(callee, _) => matches!(program.body.expr(*callee), Expr::Name(name) if name == GET_MOVE_ID),
        _ => false,
    }
}

/// Operator `>=`, or `<=` if the move id is the right operand.
fn instead(op: BinaryOp, left: bool) -> &'static str {
    match (op, left) {
        (BinaryOp::Equal, true) => ">=",
        (BinaryOp::Equal, false) => "<=",
        (_, true) => "<",
        (_, false) => ">",
    }
}

fn word(op: &str, instead: &str) -> Wording {
    let holds = if op == BinaryOp::NotEqual.symbol() { "until" } else { "from the moment" };
    Wording::new(
        format!("`{op}` compares a move id, which may never be exactly this number"),
        "the id can skip whole numbers",
        format!("write `{instead}`, which holds {holds} the arm is there"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn tests_for_equality_are_reported() {
        expect![[r#"
            start.pgx:5 `getMoveId()==12` `==` compares a move id, which may never be exactly this number
              | the id can skip whole numbers
              ? write `>=`, which holds from the moment the arm is there
              ! write `>=` (unsafe)
            start.pgx:6 `n!=(getMoveId())` `!=` compares a move id, which may never be exactly this number
              | the id can skip whole numbers
              ? write `>`, which holds until the arm is there
              ! write `>` (unsafe)
            start.pgx:9 `getMoveId()` `case` compares a move id, which may never be exactly this number
              | the id can skip whole numbers
              ? write `>=`, which holds from the moment the arm is there
        "#]].assert_eq(&check(
            &RULE,
            "num n\nwait(getMoveId()==12)\nwhile n!=(getMoveId())\ndelay(0)\nendWhile\nswitch getMoveId()\ncase 1\nbreak\nendSwitch",
        ));
    }

    #[test]
    fn other_tests_are_not_reported() {
        assert_eq!(
            check(&RULE, "num n\nwait(getMoveId()>=12)\nn=getMoveId()\nif roundDown(getMoveId())==3\nput(n)\nendIf"),
            ""
        );
    }
}
