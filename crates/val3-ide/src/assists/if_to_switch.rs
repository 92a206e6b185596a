//! Converts an `if` chain that compares one value into a `switch`.

use val3_syntax::ast::{AstNode, Block, Expr, IfStmt};
use val3_syntax::{SyntaxKind, TextRange};

use super::context::Context;
use super::lines::relaid;
use super::switch_to_if::is_pure;
use super::{AssistKind, Assists};
use crate::edit::SourceChange;

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    let chain = context.node::<IfStmt>().filter(|chain| is_at_head(context, chain))?;
    chain.end_if()?;
    let mut arms = vec![(chain.condition()?, chain.block()?)];
    for clause in chain.else_if_clauses() {
        arms.push((clause.condition()?, clause.block()?));
    }
    // A single comparison is no chain.
    if arms.len() < 2 {
        return None;
    }
    let mut selector = None;
    let mut cases = Vec::new();
    for (condition, block) in arms {
        let mut values = Vec::new();
        compared(context, condition, &mut selector, &mut values)?;
        cases.push((values, block));
    }
    let selector = selector.filter(|selector: &Expr| is_pure(selector) && is_comparable(context, selector))?;
    let otherwise = match chain.else_clause() {
        Some(clause) => Some(clause.block()?),
        None => None,
    };
    assists.add("if-to-switch", AssistKind::Rewrite, "Replace `if` with `switch`", || {
        let text = written(context, &chain, &selector, &cases, otherwise.as_ref());
        Some(SourceChange::of([context.replace(chain.syntax().text_range(), text)]))
    });
    Some(())
}

/// Whether the cursor is on a keyword line of the chain, not inside a block.
pub(super) fn is_at_head(context: &Context<'_>, chain: &IfStmt) -> bool {
    let clauses = chain.else_if_clauses().filter_map(|clause| clause.block());
    let first_and_last = [chain.block(), chain.else_clause().and_then(|clause| clause.block())];
    let mut stmts = first_and_last.into_iter().flatten().chain(clauses).flat_map(|block| block.stmts());
    !stmts.any(|stmt| stmt.syntax().text_range().contains_range(context.range))
}

/// Collects the constants with which the selector is compared; `None` if the condition contains anything else.
fn compared(
    context: &Context<'_>,
    condition: Expr,
    selector: &mut Option<Expr>,
    values: &mut Vec<TextRange>,
) -> Option<()> {
    if condition.syntax().kind() == SyntaxKind::PAREN_EXPR {
        return compared(context, condition.inner()?, selector, values);
    }
    match condition.binary()? {
        (left, SyntaxKind::OR_KW, right) => {
            compared(context, left, selector, values)?;
            compared(context, right, selector, values)
        }
        (left, SyntaxKind::EQ2, right) => {
            let (value, constant) = sides(left, right)?;
            let text = |expr: &Expr| context.slice(expr.syntax().text_range()).replace([' ', '\t'], "");
            let same = selector.as_ref().is_none_or(|known| text(known) == text(&value));
            if !same {
                return None;
            }
            values.push(constant.syntax().text_range());
            *selector = Some(value);
            Some(())
        }
        _ => None,
    }
}

/// Whether `switch` supports the type (2.2.5): it rejects inputs, outputs, serial lines and user types.
fn is_comparable(context: &Context<'_>, selector: &Expr) -> bool {
    let id = context.expr_at(selector.syntax().text_range());
    let ty = id.and_then(|id| context.inference().ty(id).base.builtin());
    ty.is_some_and(|ty| !ty.is_linkable())
}

/// Value and constant of a comparison.
fn sides(left: Expr, right: Expr) -> Option<(Expr, Expr)> {
    match (is_constant(&left), is_constant(&right)) {
        (false, true) => Some((left, right)),
        (true, false) => Some((right, left)),
        _ => None,
    }
}

fn is_constant(expr: &Expr) -> bool {
    match expr.syntax().kind() {
        SyntaxKind::LITERAL => true,
        SyntaxKind::PREFIX_EXPR => expr.inner().is_some_and(|inner| inner.syntax().kind() == SyntaxKind::LITERAL),
        _ => false,
    }
}

fn written(
    context: &Context<'_>,
    chain: &IfStmt,
    selector: &Expr,
    cases: &[(Vec<TextRange>, Block)],
    otherwise: Option<&Block>,
) -> String {
    let outer = context.indentation(chain.syntax().text_range().start());
    let line_end = context.line_end();
    let indent = format!("{outer}{}", context.level());
    let mut text = format!("switch {}", context.slice(selector.syntax().text_range()));
    for (values, block) in cases {
        let values: Vec<&str> = values.iter().map(|range| context.slice(*range)).collect();
        text += &case(context, &indent, &format!("case {}", values.join(",")), block);
    }
    if let Some(block) = otherwise {
        text += &case(context, &indent, "default", block);
    }
    text + &format!("{line_end}{outer}endSwitch")
}

/// A case of the `switch`, preceded by a line end. `indent` is the indentation of its head.
fn case(context: &Context<'_>, indent: &str, head: &str, block: &Block) -> String {
    let line_end = context.line_end();
    let inner = relaid(context, block, &format!("{indent}{}", context.level()));
    format!("{line_end}{indent}{head}{inner}{line_end}{indent}break")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::assists::testing::{check, offered};

    const ID: &str = "if-to-switch";

    #[test]
    fn a_chain_of_comparisons_becomes_a_switch() {
        check(
            ID,
            "num nA[2]\n  i$0f nA[0]==1\n    // one\n    nA[1]=1\n  elseIf nA[ 0 ]==2 or (-3==nA[0])\n    if true\n\n      nA[1]=2\n    endIf\n  else\n    // other\n  endIf\n  nA=0",
            expect![[r#"
                usrapp/main/start.pgx
                -  if nA[0]==1
                -    // one
                -    nA[1]=1
                -  elseIf nA[ 0 ]==2 or (-3==nA[0])
                -    if true
                -
                -      nA[1]=2
                -    endIf
                -  else
                -    // other
                -  endIf
                +  switch nA[0]
                +    case 1
                +      // one
                +      nA[1]=1
                +    break
                +    case 2,-3
                +      if true
                +
                +        nA[1]=2
                +      endIf
                +    break
                +    default
                +      // other
                +    break
                +  endSwitch
            "#]],
        );
    }

    #[test]
    fn other_conditions_are_not_offered() {
        for listing in [
            "num nA\ni$0f nA==1\nelseIf nA<2\nendIf",
            "num nA\ni$0f nA==1 and nA==2\nelseIf nA==3\nendIf",
            "num nA\nnum nB\ni$0f nA==1\nelseIf nB==2\nendIf",
            "num nA\ni$0f nA==nA\nelseIf nA==1\nendIf",
            "num nA\ni$0f nA==1\nendIf",
            "i$0f get()==1\nelseIf get()==2\nendIf",
            "num nA\nif nA==1\n  nA=$02\nelseIf nA==3\nendIf",
            "aio aiA\ni$0f aiA==1\nelseIf aiA==2\nendIf",
            "num nA\ni$0f nA==1\nelseIf nA==2\n  nA=2\n",
        ] {
            assert_eq!(offered(listing, ID), None, "{listing}");
        }
    }
}
