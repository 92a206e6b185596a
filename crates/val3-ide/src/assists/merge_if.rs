//! Merges two `if`: nested statements with `and`, an `if` in an `else` to `elseIf`.

use val3_analysis::body::{Expr, ExprId};
use val3_lang::operators::BinaryOp;
use val3_syntax::TextRange;
use val3_syntax::ast::{AstNode, ElseClause, IfStmt};

use super::context::Context;
use super::if_to_switch::is_at_head;
use super::lines::end_of_line;
use super::nested_if::{IfLines, if_in_else, is_simple, only_if, shallower, step};
use super::{AssistKind, Assists};
use crate::edit::{FileEdit, SourceChange};

const ID: &str = "merge-if";

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    let chain = context.node::<IfStmt>().filter(|chain| is_at_head(context, chain))?;
    if context.is_broken(chain.syntax().text_range()) {
        return None;
    }
    let (title, edits) = at_else(context, &chain).or_else(|| nested(context, &chain)).or_else(|| {
        let outer = chain.syntax().ancestors().skip(1).find_map(IfStmt::cast)?;
        let in_clause = |clause: &_| if_in_else(clause).is_some_and(|(inner, _)| inner.syntax() == chain.syntax());
        match outer.else_clause().filter(in_clause) {
            Some(clause) => in_else(context, &outer, &clause),
            None if only_if(outer.block())?.syntax() == chain.syntax() => nested(context, &outer),
            None => None,
        }
    })?;
    assists.add(ID, AssistKind::Rewrite, title, || Some(SourceChange::of(edits)));
    Some(())
}

type MergedCondition = (&'static str, Vec<FileEdit>);

/// Merges an `else` with the `if` inside it, if the cursor is on the line of `else`.
fn at_else(context: &Context<'_>, chain: &IfStmt) -> Option<MergedCondition> {
    let clause = chain.else_clause()?;
    let at = context.range.start();
    let line = end_of_line(context, clause.syntax().first_token()?.text_range().end())?;
    (clause.syntax().text_range().start() <= at && at < line).then(|| in_else(context, chain, &clause)).flatten()
}

/// Merges `else` and the `if` inside it to `elseIf`.
fn in_else(context: &Context<'_>, outer: &IfStmt, clause: &ElseClause) -> Option<MergedCondition> {
    let (inner, keyword) = if_in_else(clause)?;
    let lines = IfLines::of(context, &inner)?;
    let end = IfLines::of(context, outer)?.last.start();
    let start = inner.syntax().text_range().start();
    let level = step(context, keyword.start(), start);
    let word = inner.syntax().first_token()?.text_range();
    let head = context.slice(TextRange::new(word.end(), lines.inner.start()));
    let before = comments(context, TextRange::new(end_of_line(context, keyword.end())?, start));
    let after = context.slice(TextRange::new(lines.last.end(), end));
    let text = format!("elseIf{head}{before}{}{after}", shallower(context.slice(lines.inner), level));
    let edit = context.replace(TextRange::new(keyword.start(), end), text);
    Some(("Merge `else` and `if` into `elseIf`", vec![edit]))
}

/// Merges an `if` with the only `if` inside it by joining their conditions. `and` evaluates its right side only if the
/// left side is true, like the nested `if`.
fn nested(context: &Context<'_>, outer: &IfStmt) -> Option<MergedCondition> {
    let inner = only_if(outer.block()).filter(|inner| is_simple(inner) && is_simple(outer))?;
    let (whole, part) = (IfLines::of(context, outer)?, IfLines::of(context, &inner)?);
    let condition = whole.condition.syntax().text_range();
    let left = context.expr_at(condition)?;
    let right = context.expr_at(part.condition.syntax().text_range())?;
    let joined = format!("{} and {}", side(context, left, true), side(context, right, false));
    let start = inner.syntax().text_range().start();
    let level = step(context, outer.syntax().text_range().start(), start);
    let before = comments(context, TextRange::new(whole.inner.start(), start));
    let after = context.slice(TextRange::new(part.last.end(), whole.last.start()));
    let lines = format!("{before}{}{after}", shallower(context.slice(part.inner), level));
    let edits = vec![context.replace(condition, joined), context.replace(whole.inner, lines)];
    Some(("Merge with the nested `if`", edits))
}

/// Lines before a statement, without its indentation.
fn comments<'db>(context: &Context<'db>, range: TextRange) -> &'db str {
    context.slice(range).trim_end_matches([' ', '\t'])
}

/// A condition as one side of `and`, with parentheses if necessary.
fn side(context: &Context<'_>, id: ExprId, is_left: bool) -> String {
    let text = context.slice(context.body().range(id));
    match context.body().expr(id) {
        Expr::Binary(BinaryOp::Or, ..) => format!("({text})"),
        Expr::Binary(BinaryOp::And, ..) if !is_left => format!("({text})"),
        _ => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::assists::testing::{check, done, offered};

    const ID: &str = "merge-if";

    #[test]
    fn nested_conditions_are_joined() {
        check(
            ID,
            "num nA\nbool bA\nbool bB\n  i$0f bA or bB\n    // why\n    if nA==1 and bB\n      // first\n      nA=2\n\n    endIf\n    // last\n  endIf",
            expect![[r#"
                usrapp/main/start.pgx
                -  if bA or bB
                -    // why
                -    if nA==1 and bB
                -      // first
                -      nA=2
                -
                -    endIf
                +  if (bA or bB) and (nA==1 and bB)
                +    // why
                +    // first
                +    nA=2
                +
            "#]],
        );
    }

    #[test]
    fn else_with_an_if_becomes_else_if() {
        check(
            ID,
            "num nA\n  if nA==1\n    nA=2\n  el$0se\n    // why\n    if(nA==2)\n      nA=3\n    elseIf nA==3\n    else\n      nA=4\n    endIf\n    // last\n  endIf",
            expect![[r#"
                usrapp/main/start.pgx
                -  else
                -    // why
                -    if(nA==2)
                -      nA=3
                -    elseIf nA==3
                -    else
                -      nA=4
                -    endIf
                +  elseIf(nA==2)
                +    // why
                +    nA=3
                +  elseIf nA==3
                +  else
                +    nA=4
            "#]],
        );
    }

    #[test]
    fn it_is_offered_on_both_heads() {
        for code in [
            "i$0f bA\n  if bB\n  endIf\nendIf",
            "if bA\n  i$0f bB\n  endIf\nendIf",
            "if bA\nel$0se\n  if bB\n  endIf\nendIf",
            "if bA\nelse\n  i$0f bB\n  endIf\nendIf",
        ] {
            done(&format!("bool bA\nbool bB\n{code}"), ID);
        }
    }

    #[test]
    fn other_forms_are_not_merged() {
        for code in [
            "i$0f bA\n  if bB\n  else\n  endIf\nendIf",
            "i$0f bA\n  if bB\n  endIf\nelse\nendIf",
            "i$0f bA\n  if bB\n  endIf\n  bA=true\nendIf",
            "if bA\nel$0se\n  if bB\n  endIf\n  bA=true\nendIf",
            "if bA\nel$0se\n  if bB\n\nendIf",
            "i$0f bA\nendIf",
        ] {
            assert_eq!(offered(&format!("bool bA\nbool bB\n{code}"), ID), None, "{code}");
        }
    }
}
