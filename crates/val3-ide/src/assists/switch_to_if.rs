//! Turns a `switch` into a chain of `if`.

use val3_syntax::ast::{AstNode, Expr, SwitchStmt};
use val3_syntax::{SyntaxKind, TextRange};

use super::context::Context;
use super::lines::relaid;
use super::{AssistKind, Assists};
use crate::edit::SourceChange;

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    let switch = context.node::<SwitchStmt>().filter(|switch| is_at_head(context, switch))?;
    switch.end_switch_token()?;
    let selector = switch.selector().filter(is_pure)?;
    let clauses: Vec<_> = switch.case_clauses().collect();
    let mut defaults = switch.default_clauses();
    let default = defaults.next();
    let is_whole = clauses.iter().all(|clause| clause.break_token().is_some() && clause.values().next().is_some())
        && default.as_ref().is_none_or(|clause| clause.break_token().is_some());
    // `default` may stand in the middle only in code that is not taken anyway.
    let ends = default.as_ref().is_none_or(|default| {
        clauses.iter().all(|clause| clause.syntax().text_range().end() <= default.syntax().text_range().start())
    });
    if !is_whole || !ends || clauses.is_empty() || defaults.next().is_some() || switch.stmts().next().is_some() {
        return None;
    }
    assists.add("switch-to-if", AssistKind::Rewrite, "Replace `switch` with `if`", || {
        let outer = context.indentation(switch.syntax().text_range().start());
        let line_end = context.line_end();
        let inner = format!("{outer}{}", context.level());
        let mut text = String::new();
        for (index, clause) in clauses.iter().enumerate() {
            let values: Vec<String> =
                clause.values().map(|value| equal(context, &selector, value.syntax().text_range())).collect();
            let word = if index == 0 { "if" } else { "elseIf" };
            let start = if index == 0 { String::new() } else { format!("{line_end}{outer}") };
            text += &format!("{start}{word} {}{}", values.join(" or "), relaid(context, &clause.block()?, &inner));
        }
        if let Some(clause) = &default {
            text += &format!("{line_end}{outer}else{}", relaid(context, &clause.block()?, &inner));
        }
        text += &format!("{line_end}{outer}endIf");
        Some(SourceChange::of([context.replace(switch.syntax().text_range(), text)]))
    });
    Some(())
}

/// The cursor is in none of the blocks.
fn is_at_head(context: &Context<'_>, switch: &SwitchStmt) -> bool {
    let cases = switch.case_clauses().filter_map(|clause| clause.block());
    let mut blocks = cases.chain(switch.default_clauses().filter_map(|clause| clause.block()));
    !blocks.any(|block| block.stmts().any(|stmt| stmt.syntax().text_range().contains_range(context.range)))
}

fn equal(context: &Context<'_>, selector: &Expr, value: TextRange) -> String {
    let selected = context.slice(selector.syntax().text_range());
    let selected = if is_simple(selector) { selected.to_owned() } else { format!("({selected})") };
    format!("{selected}=={}", context.slice(value))
}

fn is_simple(expr: &Expr) -> bool {
    !matches!(expr, Expr::BinExpr(_) | Expr::PrefixExpr(_) | Expr::AssignExpr(_))
}

/// Computing it several times is computing it once: nothing is called, nothing assigned.
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
    fn a_switch() {
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
    fn and_back() {
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
    fn not_where_it_would_change_something() {
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
