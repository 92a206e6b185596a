//! Splits an `if`: `and` into nested `if`, `elseIf` into an `if` inside an `else`.

use val3_analysis::body::{Expr, ExprId};
use val3_lang::operators::BinaryOp;
use val3_syntax::TextRange;
use val3_syntax::ast::{AstNode, ElseIfClause, IfStmt};

use super::context::Context;
use super::if_to_switch::is_at_head;
use super::lines::{end_of_line, whole_lines};
use super::nested_if::{IfLines, deeper, is_simple};
use super::{AssistKind, Assists};
use crate::edit::SourceChange;

const ID: &str = "split-if";
const NESTED: &str = "Split `and` into nested `if`";

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    let chain = context.node::<IfStmt>().filter(|chain| is_at_head(context, chain))?;
    if context.is_broken(chain.syntax().text_range()) {
        return None;
    }
    match chain.else_if_clauses().find(|clause| is_at_clause(context, clause)) {
        Some(clause) => offer_else_if(context, assists, &chain, &clause),
        None => offer_nested(context, assists, &chain),
    }
}

/// Whether the cursor or selection is on the line of `elseIf`.
fn is_at_clause(context: &Context<'_>, clause: &ElseIfClause) -> bool {
    let range = clause.syntax().text_range();
    let end = clause.condition().map_or(range.start(), |condition| condition.syntax().text_range().end());
    TextRange::new(range.start(), end).contains_range(context.range)
}

fn offer_else_if(
    context: &Context<'_>,
    assists: &mut Assists<'_>,
    chain: &IfStmt,
    clause: &ElseIfClause,
) -> Option<()> {
    let keyword = clause.syntax().first_token()?.text_range();
    whole_lines(context, TextRange::new(keyword.start(), clause.condition()?.syntax().text_range().end()))?;
    let end = IfLines::of(context, chain)?.last.start();
    let head = end_of_line(context, clause.condition()?.syntax().text_range().end())?;
    assists.add(ID, AssistKind::Rewrite, "Split `elseIf` into `else` and `if`", || {
        let (outer, level, line_end) = (context.indentation(keyword.start()), context.level(), context.line_end());
        let condition = context.slice(TextRange::new(keyword.end(), head));
        let lines = deeper(context.slice(TextRange::new(head, end)), &level);
        let text = format!("else{line_end}{outer}{level}if{condition}{lines}{outer}{level}endIf{line_end}");
        Some(SourceChange::of([context.replace(TextRange::new(keyword.start(), end), text)]))
    });
    Some(())
}

fn offer_nested(context: &Context<'_>, assists: &mut Assists<'_>, chain: &IfStmt) -> Option<()> {
    let condition = chain.condition()?.syntax().text_range();
    let id = context.expr_at(condition)?;
    let body = context.body();
    let Expr::Binary(BinaryOp::And, left, right) = body.expr(body.without_parentheses(id)) else { return None };
    let obstacle = match body.expr(id) {
        _ if !is_simple(chain) => Some("The other branches of the `if` would be needed twice"),
        Expr::Paren(_) => Some("The condition is in parentheses. Remove them first"),
        _ => None,
    };
    if let Some(reason) = obstacle {
        assists.refuse(None, ID, AssistKind::Rewrite, NESTED, reason);
        return None;
    }
    let lines = IfLines::of(context, chain)?;
    whole_lines(context, TextRange::new(chain.syntax().text_range().start(), condition.end()))?;
    assists.add(ID, AssistKind::Rewrite, NESTED, || {
        let start = chain.syntax().text_range().start();
        let (outer, level, line_end) = (context.indentation(start), context.level(), context.line_end());
        let touches = chain.syntax().first_token().is_some_and(|word| word.text_range().end() == condition.start());
        let left = side(context, *left, &[BinaryOp::Or], touches);
        let right = side(context, *right, &[BinaryOp::Or, BinaryOp::And], false);
        let blank = if touches && right.starts_with('(') { "" } else { " " };
        let head = format!("{left}{line_end}{outer}{level}if{blank}{right}");
        let inner = format!("{}{outer}{level}endIf{line_end}", deeper(context.slice(lines.inner), &level));
        Some(SourceChange::of([context.replace(condition, head), context.replace(lines.inner, inner)]))
    });
    Some(())
}

/// One side of `and` as a condition, without parentheses that only `and` requires.
fn side<'db>(context: &Context<'db>, id: ExprId, operators: &[BinaryOp], keeps: bool) -> &'db str {
    let body = context.body();
    let inner = match body.expr(id) {
        Expr::Paren(inner) if !keeps => *inner,
        _ => id,
    };
    let needed = matches!(body.expr(inner), Expr::Binary(op, ..) if operators.contains(op));
    context.slice(body.range(if needed { inner } else { id }))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::assists::testing::{check, done, offered, refused};

    const ID: &str = "split-if";

    #[test]
    fn and_becomes_a_nested_if() {
        check(
            ID,
            "num nA\nbool bA\n  i$0f (bA or nA==1) and nA<2\n    // why\n    nA=2\n\n  endIf",
            expect![[r#"
                usrapp/main/start.pgx
                -  if (bA or nA==1) and nA<2
                -    // why
                -    nA=2
                -
                +  if bA or nA==1
                +    if nA<2
                +      // why
                +      nA=2
                +
                +    endIf
            "#]],
        );
    }

    #[test]
    fn conditions_in_parentheses_follow_the_word_as_before() {
        check(
            ID,
            "num nA\nbool bA\n  i$0f(bA) and (nA<2)\n    nA=2\n  endIf",
            expect![[r#"
                usrapp/main/start.pgx
                -  if(bA) and (nA<2)
                -    nA=2
                +  if(bA)
                +    if(nA<2)
                +      nA=2
                +    endIf
            "#]],
        );
    }

    #[test]
    fn else_if_becomes_an_if_in_an_else() {
        check(
            ID,
            "num nA\n  if nA==1\n  el$0seIf(nA==2)\n    nA=3\n  elseIf nA==3\n  else\n    // other\n    nA=4\n  endIf",
            expect![[r#"
                usrapp/main/start.pgx
                -  elseIf(nA==2)
                -    nA=3
                -  elseIf nA==3
                -  else
                -    // other
                -    nA=4
                +  else
                +    if(nA==2)
                +      nA=3
                +    elseIf nA==3
                +    else
                +      // other
                +      nA=4
                +    endIf
            "#]],
        );
    }

    #[test]
    fn code_of_s6_is_split() {
        check(
            ID,
            "num nZ\n=== main/start.pgx\n<programList xmlns=\"ProgramNameSpace\">\n  <program name=\"start\" public=\"false\">\n    <source><code>begin&#13;\n  i$0f nZ&gt;=2 and nZ&lt;4&#13;\n&#13;\n    putln(1)&#13;\n  endIf&#13;\nend</code></source>\n  </program>\n</programList>\n",
            expect![[r#"
                usrapp/main/start.pgx
                -  if nZ&gt;=2 and nZ&lt;4&#13;
                -&#13;
                -    putln(1)&#13;
                +  if nZ&gt;=2&#13;
                +    if nZ&lt;4&#13;
                +&#13;
                +      putln(1)&#13;
                +    endIf&#13;
            "#]],
        );
    }

    #[test]
    fn other_forms_are_not_split() {
        for code in ["i$0f bA or bB\nendIf", "i$0f bA\nendIf", "if bA and bB\n  bA=$0true\nendIf", "i$0f bA and\nendIf"]
        {
            assert_eq!(offered(&format!("bool bA\nbool bB\n{code}"), ID), None, "{code}");
        }
        for (code, reason) in [("i$0f bA and bB\nelse\nendIf", "twice"), ("i$0f (bA and bB)\nendIf", "parentheses")] {
            assert!(refused(&format!("bool bA\nbool bB\n{code}"), ID).is_some_and(|it| it.contains(reason)), "{code}");
        }
        done("bool bA\nbool bB\ni$0f(bA or bB) and bA\nendIf", ID);
    }
}
