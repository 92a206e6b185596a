//! Adds a wait for the arm after a move.

use val3_analysis::body::{Body, Expr, ExprId, Stmt, StmtKind};
use val3_lang::instruction::{Family, Instruction};
use val3_lang::instructions::WAIT_END_MOVE;
use val3_lang::types::BaseType;
use val3_syntax::TextRange;
use val3_syntax::ast::AstNode as _;

use super::context::Context;
use super::{AssistKind, Assists};
use crate::edit::SourceChange;

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    context.code()?;
    let (stmts, range) = context.stmts()?;
    let own = stmts.last()?.syntax().text_range();
    let block = context.body().blocks().find(|block| block.iter().any(|stmt| stmt.range == own))?;
    let at = block.iter().position(|stmt| stmt.range == own)?;
    if !moves(context, block.get(at)?) || block.get(at + 1).is_some_and(|next| waits(context.body(), next)) {
        return None;
    }
    let title = format!("Add `{WAIT_END_MOVE}()` after the move");
    assists.add("wait-for-arm", AssistKind::Rewrite, title, || {
        let line = format!("{}{}{WAIT_END_MOVE}()", context.line_end(), context.indentation(range.start()));
        Some(SourceChange::of([context.replace(TextRange::empty(own.end()), line)]))
    });
    Some(())
}

/// Whether the statement records a move with a movement description.
fn moves(context: &Context<'_>, stmt: &Stmt) -> bool {
    let call = match stmt.kind {
        StmtKind::Expr(id) | StmtKind::Assign { value: id, .. } => id,
        _ => return false,
    };
    context.inference().call(context.body().without_parentheses(call)).is_some_and(|call| is_move(call.instruction))
}

/// Whether the instruction records a move: it has a tool and a movement description as parameters.
fn is_move(instruction: &Instruction) -> bool {
    let accepts = |ty| instruction.overloads.iter().any(|form| form.params.iter().any(|param| param.ty == Some(ty)));
    instruction.family == Family::Motion && accepts(BaseType::Mdesc) && accepts(BaseType::Tool)
}

fn waits(body: &Body, stmt: &Stmt) -> bool {
    let callee = |id: ExprId| if let Expr::Call(callee, _) = body.expr(id) { Some(*callee) } else { None };
    let StmtKind::Expr(id) = stmt.kind else { return false };
    callee(id).is_some_and(|callee| matches!(body.expr(callee), Expr::Name(name) if name == WAIT_END_MOVE))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::assists::testing::{check, offered};

    const ID: &str = "wait-for-arm";
    const DATA: &str = "point pA\ntool tA\nmdesc mA\nnum nId\n";

    #[test]
    fn a_wait_is_added_after_a_move() {
        check(
            ID,
            &format!("{DATA}if nId==1\n  mo$0vel(pA,tA,mA)\n  nId=2\nendIf"),
            expect![[r#"
            usrapp/main/start.pgx
            +  waitEndMove()
        "#]],
        );
        check(
            ID,
            &format!("{DATA}nId=mo$0vel(pA,tA,mA)"),
            expect![[r#"
            usrapp/main/start.pgx
            +waitEndMove()
        "#]],
        );
    }

    #[test]
    fn other_lines_and_moves_with_a_wait_are_not_offered() {
        for line in ["mo$0vel(pA,tA,mA)\nwaitEndMove()", "n$0Id=1", "re$0setMotion()"] {
            assert_eq!(offered(&format!("{DATA}{line}"), ID), None, "{line}");
        }
    }
}
