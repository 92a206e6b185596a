//! Converts a `switch` into an `if` chain.

use std::ops::Range;

use val3_lang::operators::BinaryOp;
use val3_syntax::ast::{AstNode, CaseClause, DefaultClause, Expr, SwitchStmt};
use val3_syntax::{SyntaxKind, TextRange, TextSize};

use super::context::Context;
use super::lines::{own_comments, relaid};
use super::precedence::needs_parentheses_after;
use super::{AssistKind, Assists};
use crate::edit::SourceChange;

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    let switch = context.node::<SwitchStmt>().filter(|switch| is_at_head(context, switch))?;
    switch.end_switch()?;
    let selector = switch.selector().filter(is_pure)?;
    let clauses: Vec<_> = switch.case_clauses().collect();
    let mut defaults = switch.default_clauses();
    let default = defaults.next();
    let is_whole = clauses.iter().all(|clause| clause.break_keyword().is_some() && clause.values().next().is_some())
        && default.as_ref().is_none_or(|clause| clause.break_keyword().is_some());
    // A `default` before a `case` occurs only in code that is excluded anyway.
    let ends = default.as_ref().is_none_or(|default| {
        clauses.iter().all(|clause| clause.syntax().text_range().end() <= default.syntax().text_range().start())
    });
    if !is_whole || !ends || clauses.is_empty() || defaults.next().is_some() || switch.stmts().next().is_some() {
        return None;
    }
    assists.add("switch-to-if", AssistKind::Rewrite, "Replace `switch` with `if`", || {
        let text = written(context, &switch, &selector, &clauses, default.as_ref())?;
        Some(SourceChange::of([context.replace(switch.syntax().text_range(), text)]))
    });
    Some(())
}

fn written(
    context: &Context<'_>,
    switch: &SwitchStmt,
    selector: &Expr,
    clauses: &[CaseClause],
    default: Option<&DefaultClause>,
) -> Option<String> {
    let outer = context.indentation(switch.syntax().text_range().start());
    let line_end = context.line_end();
    let inner = format!("{outer}{}", context.level());
    let comments = own_comments(switch.syntax());
    let start = switch.syntax().text_range().start();
    let first = clauses.first()?.syntax().text_range().start();
    // A comment before the first case belongs to the entire statement.
    let head = comment_lines(context, &comments, start..first, outer);
    let mut text = head.strip_prefix(&format!("{line_end}{outer}")).map_or_else(String::new, str::to_owned);
    let mut done = first;
    for clause in clauses {
        let values = clause.values().map(|value| equal(context, selector, value.syntax().text_range()));
        let values = values.collect::<Vec<_>>().join(" or ");
        let word = if done == first { "if" } else { "elseIf" };
        let before = if text.is_empty() { String::new() } else { format!("{line_end}{outer}") };
        let range = clause.syntax().text_range();
        let moved = comment_lines(context, &comments, done..range.start(), &inner);
        text += &format!("{before}{word} {values}{moved}{}", relaid(context, &clause.block()?, &inner));
        done = range.end();
    }
    if let Some(clause) = default {
        let range = clause.syntax().text_range();
        let moved = comment_lines(context, &comments, done..range.start(), &inner);
        text += &format!("{line_end}{outer}else{moved}{}", relaid(context, &clause.block()?, &inner));
        done = range.end();
    }
    text += &comment_lines(context, &comments, done..switch.syntax().text_range().end(), &inner);
    Some(text + &format!("{line_end}{outer}endIf"))
}

/// Comments in `range`, each preceded by a line end and `indent`.
fn comment_lines(context: &Context<'_>, comments: &[TextRange], range: Range<TextSize>, indent: &str) -> String {
    let line_end = context.line_end();
    let inside = comments.iter().filter(|comment| range.start <= comment.start() && comment.end() <= range.end);
    inside.map(|comment| format!("{line_end}{indent}{}", context.slice(*comment))).collect()
}

/// Whether the cursor is outside all blocks.
pub(super) fn is_at_head(context: &Context<'_>, switch: &SwitchStmt) -> bool {
    let cases = switch.case_clauses().filter_map(|clause| clause.block());
    let mut blocks = cases.chain(switch.default_clauses().filter_map(|clause| clause.block()));
    !blocks.any(|block| block.stmts().any(|stmt| stmt.syntax().text_range().contains_range(context.range)))
}

fn equal(context: &Context<'_>, selector: &Expr, value: TextRange) -> String {
    let selected = context.slice(selector.syntax().text_range());
    let selected = if is_simple(selector) { selected.to_owned() } else { format!("({selected})") };
    let compared = context.slice(value);
    let value = context.expr_at(value);
    match value.is_none_or(|id| needs_parentheses_after(context.body(), BinaryOp::Equal, id)) {
        true => format!("{selected}==({compared})"),
        false => format!("{selected}=={compared}"),
    }
}

fn is_simple(expr: &Expr) -> bool {
    !matches!(expr.syntax().kind(), SyntaxKind::BIN_EXPR | SyntaxKind::PREFIX_EXPR | SyntaxKind::ASSIGN_EXPR)
}

/// Whether the expression can be evaluated twice without a different effect: it contains no call and no assignment.
pub(super) fn is_pure(expr: &Expr) -> bool {
    let acts = |kind| matches!(kind, SyntaxKind::CALL_EXPR | SyntaxKind::ASSIGN_EXPR | SyntaxKind::ERROR);
    !expr.syntax().descendants().any(|node| acts(node.kind()))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::assists::testing::{check, offered};

    const ID: &str = "switch-to-if";

    #[test]
    fn a_switch_becomes_a_chain_of_conditions() {
        check(
            ID,
            "num nA\n  sw$0itch nA+1\n    case 1,2\n      // why\n      if true\n        nA=1\n      endIf\n    break\n    case 3\n    break\n    default\n      nA=4\n      // last\n    break\n  endSwitch\n  nA=5",
            expect![[r#"
                usrapp/main/start.pgx
                -  switch nA+1
                -    case 1,2
                -      // why
                -      if true
                -        nA=1
                -      endIf
                -    break
                -    case 3
                -    break
                -    default
                -      nA=4
                -      // last
                -    break
                -  endSwitch
                +  if (nA+1)==1 or (nA+1)==2
                +    // why
                +    if true
                +      nA=1
                +    endIf
                +  elseIf (nA+1)==3
                +  else
                +    nA=4
                +    // last
                +  endIf
            "#]],
        );
    }

    #[test]
    fn values_that_bind_loosely_get_parentheses() {
        check(
            ID,
            "num nA\nbool bA\nbool bB\nsw$0itch bA\n  case nA==1,bA or bB,nA>1 xor bA,!bB,(bB),nA!=2 and bB\n    nA=1\n  break\nendSwitch",
            expect![[r#"
                usrapp/main/start.pgx
                -switch bA
                -  case nA==1,bA or bB,nA>1 xor bA,!bB,(bB),nA!=2 and bB
                -    nA=1
                -  break
                -endSwitch
                +if bA==(nA==1) or bA==(bA or bB) or bA==(nA>1 xor bA) or bA==!bB or bA==(bB) or bA==(nA!=2 and bB)
                +  nA=1
                +endIf
            "#]],
        );
        check(
            ID,
            "num nA\nsw$0itch nA\n  case nA+1,-1,nA*2,abs(nA)\n    nA=1\n  break\nendSwitch",
            expect![[r#"
                usrapp/main/start.pgx
                -switch nA
                -  case nA+1,-1,nA*2,abs(nA)
                -    nA=1
                -  break
                -endSwitch
                +if nA==nA+1 or nA==-1 or nA==nA*2 or nA==abs(nA)
                +  nA=1
                +endIf
            "#]],
        );
    }

    #[test]
    fn comments_are_kept() {
        check(
            ID,
            "num nA\n  sw$0itch nA\n    // all\n    // cases\n    case 1\n      nA=1\n    break\n    // two\n    case 2\n      // in it\n    break\n    // other\n    default\n    break\n    // done\n  endSwitch",
            expect![[r#"
                usrapp/main/start.pgx
                -  switch nA
                -    // all
                -    // cases
                -    case 1
                -      nA=1
                -    break
                -    // two
                -    case 2
                -      // in it
                -    break
                -    // other
                -    default
                -    break
                -    // done
                -  endSwitch
                +  // all
                +  // cases
                +  if nA==1
                +    nA=1
                +  elseIf nA==2
                +    // two
                +    // in it
                +  else
                +    // other
                +    // done
                +  endIf
            "#]],
        );
        check(
            "if-to-switch",
            "num nA\ni$0f nA==1\n  // one\nelseIf nA==2\n  nA=2\n  // two\nelse\n  // other\nendIf",
            expect![[r#"
                usrapp/main/start.pgx
                -if nA==1
                -  // one
                -elseIf nA==2
                -  nA=2
                -  // two
                -else
                -  // other
                -endIf
                +switch nA
                +  case 1
                +    // one
                +  break
                +  case 2
                +    nA=2
                +    // two
                +  break
                +  default
                +    // other
                +  break
                +endSwitch
            "#]],
        );
    }

    #[test]
    fn the_conversion_can_be_undone() {
        check(
            "if-to-switch",
            "num nA\ni$0f nA==1\n  nA=2\nelseIf nA==5\nelse\n  nA=3\nendIf",
            expect![[r#"
                usrapp/main/start.pgx
                -if nA==1
                -  nA=2
                -elseIf nA==5
                -else
                -  nA=3
                -endIf
                +switch nA
                +  case 1
                +    nA=2
                +  break
                +  case 5
                +  break
                +  default
                +    nA=3
                +  break
                +endSwitch
            "#]],
        );
        check(
            ID,
            "num nA\nsw$0itch nA\n  case 1\n    nA=2\n  break\n  default\n    nA=3\n  break\nendSwitch",
            expect![[r#"
                usrapp/main/start.pgx
                -switch nA
                -  case 1
                -    nA=2
                -  break
                -  default
                -    nA=3
                -  break
                -endSwitch
                +if nA==1
                +  nA=2
                +else
                +  nA=3
                +endIf
            "#]],
        );
    }

    #[test]
    fn switches_that_would_behave_differently_are_refused() {
        for listing in [
            "sw$0itch get()\ncase 1,2\nbreak\nendSwitch",
            "num nA\nsw$0itch nA\ncase 1\nnA=2\nendSwitch",
            "num nA\nsw$0itch nA\ndefault\nbreak\nendSwitch",
            "num nA\nswitch nA\ncase 1\nn$0A=2\nbreak\nendSwitch",
        ] {
            assert_eq!(offered(listing, ID), None, "{listing}");
        }
    }
}
