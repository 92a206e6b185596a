//! Swaps the two branches in an `if` with `else`.

use val3_syntax::ast::{AstNode, IfStmt};
use val3_syntax::{TextRange, TextSize};

use super::context::Context;
use super::if_to_switch::is_at_head;
use super::lines::{end_of_line, whole_lines};
use super::negation::negated;
use super::{AssistKind, Assists};
use crate::edit::SourceChange;

const ID: &str = "invert-if";
const TITLE: &str = "Invert `if`";

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    let chain = context.node::<IfStmt>().filter(|chain| is_at_head(context, chain))?;
    chain.else_clause()?;
    if context.is_broken(chain.syntax().text_range()) {
        return None;
    }
    if chain.else_if_clauses().next().is_some() {
        let reason = "The `if` has `elseIf` as well, so that its branches cannot change places";
        assists.refuse(None, ID, AssistKind::Rewrite, TITLE, reason);
        return None;
    }
    let branches = Branches::of(context, &chain)?;
    let is_first_empty = context.slice(branches.first).trim().is_empty();
    if context.slice(branches.second).trim().is_empty() && !is_first_empty {
        let reason = "The `else` is empty, and would become an empty first branch: remove it instead";
        assists.refuse(None, ID, AssistKind::Rewrite, TITLE, reason);
        return None;
    }
    let condition = chain.condition()?.syntax().text_range();
    let id = context.expr_at(condition)?;
    assists.add(ID, AssistKind::Rewrite, TITLE, || {
        let mut text = negated(context, id);
        let touches = !context.text.get(..usize::from(condition.start()))?.ends_with([' ', '\t']);
        if touches && !text.starts_with('(') {
            text.insert(0, ' ');
        }
        if is_first_empty {
            // The empty branch would follow `else`, so both are omitted.
            let both = branches.first.cover(branches.second);
            let kept = context.replace(both, context.slice(branches.second));
            return Some(SourceChange::of([context.replace(condition, text), kept]));
        }
        Some(SourceChange::of([
            context.replace(condition, text),
            context.replace(branches.first, context.slice(branches.second)),
            context.replace(branches.second, context.slice(branches.first)),
        ]))
    });
    Some(())
}

/// Complete lines of both branches, including comments.
struct Branches {
    first: TextRange,
    second: TextRange,
}

impl Branches {
    /// Finds the branches. `None` unless each keyword is on its own line.
    fn of(context: &Context<'_>, chain: &IfStmt) -> Option<Self> {
        let start = end_of_line(context, chain.condition()?.syntax().text_range().end())?;
        let middle = whole_lines(context, chain.else_clause()?.syntax().first_token()?.text_range())?;
        let end: TextSize = whole_lines(context, chain.end_if()?.text_range())?.start();
        Some(Self { first: TextRange::new(start, middle.start()), second: TextRange::new(middle.end(), end) })
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::assists::testing::{check, done, offered, refused};

    const ID: &str = "invert-if";

    #[test]
    fn an_empty_branch_is_left_out() {
        check(
            ID,
            "num nA\ni$0f nA==1\nelse\n  nA=2\nendIf",
            expect![[r#"
            usrapp/main/start.pgx
            -if nA==1
            -else
            +if nA!=1
        "#]],
        );
        let empty = "num nA\ni$0f nA==1\n  nA=2\nelse\nendIf";
        assert!(refused(empty, ID).is_some_and(|reason| reason.contains("remove it")));
    }

    #[test]
    fn branches_change_places_with_their_comments() {
        check(
            ID,
            "num nA\n  i$0f nA<1\n    // low\n    nA=1\n\n  else\n    nA=2\n    // high\n  endIf",
            expect![[r#"
                usrapp/main/start.pgx
                -  if nA<1
                -    // low
                -    nA=1
                -
                -  else
                -    nA=2
                -    // high
                +  if nA>=1
                +    nA=2
                +    // high
                +  else
                +    // low
                +    nA=1
                +
            "#]],
        );
    }

    #[test]
    fn conditions_are_negated_in_their_simplest_form() {
        for (condition, contrary) in [
            ("nA==1", "nA!=1"),
            ("nA != 1", "nA == 1"),
            ("nA<1", "nA>=1"),
            ("nA<=1", "nA>1"),
            ("jA<jB", "!(jA<jB)"),
            ("sA==\"a\"", "sA!=\"a\""),
            ("bA", "!bA"),
            ("dA", "!dA"),
            ("(nA==1)", "(nA!=1)"),
            ("isPowered()", "!isPowered()"),
            ("true", "false"),
            ("bA and bB", "!bA or !bB"),
            ("!bA or nA>1 or bB", "bA and nA<=1 and !bB"),
            ("bA and (bB or nA==1)", "!bA or (!bB and nA!=1)"),
            ("bA and bB or bC", "!(bA and bB or bC)"),
            ("bA xor bB", "!(bA xor bB)"),
            ("bA and bB xor bC", "!bA or !(bB xor bC)"),
            ("bA==bB", "bA!=bB"),
        ] {
            for (from, to) in [(condition, contrary), (contrary, condition)] {
                let listing = format!(
                    "num nA\nbool bA\nbool bB\nbool bC\nstring sA\njoint jA\njoint jB\ndio dA\ni$0f {from}\n  nA=1\nelse\n  nA=2\nendIf"
                );
                let found = done(&listing, ID);
                assert!(found.contains(&format!("+if {to}\n")), "{from}: {found}");
            }
        }
        let listing = "bool bA\nbool bB\ni$0f !(bA and bB)\nelse\n  bA=true\nendIf";
        assert!(done(listing, ID).contains("+if bA and bB\n"));
    }

    #[test]
    fn the_word_and_the_condition_stay_apart() {
        let listing = |condition: &str| format!("bool bA\ni$0f{condition}\nelse\n  bA=true\nendIf");
        assert!(done(&listing("(bA)"), ID).contains("+if(!bA)\n"));
        assert!(done(&listing("!bA"), ID).contains("+if bA\n"));
    }

    #[test]
    fn code_of_s6_is_inverted() {
        check(
            ID,
            "num nZ\n=== main/start.pgx\n<programList xmlns=\"ProgramNameSpace\">\r\n  <program name=\"start\" public=\"false\">\r\n    <source><code>begin\r\n  i$0f nZ&gt;=2\r\n    putln(&quot;a&quot;)\r\n  else\r\n    cls()\r\n  endIf\r\nend</code></source>\r\n  </program>\r\n</programList>\r\n",
            expect![[r#"
                usrapp/main/start.pgx
                -  if nZ&gt;=2
                -    putln(&quot;a&quot;)
                -  else
                -    cls()
                +  if nZ&lt;2
                +    cls()
                +  else
                +    putln(&quot;a&quot;)
            "#]],
        );
    }

    #[test]
    fn the_end_of_a_cdata_section_is_not_written() {
        let listing = "num nA[2]\nnum nB\ni$0f nA[nA[0]]<1\nelse\n  nB=1\nendIf";
        assert!(done(listing, ID).contains("+if !(nA[nA[0]]<1)\n"));
    }

    #[test]
    fn other_forms_are_not_inverted() {
        for code in ["i$0f bA\nendIf", "if bA\n  bA=$0true\nelse\nendIf", "i$0f bA and\nelse\nendIf", "i$0f bA\nelse\n"]
        {
            assert_eq!(offered(&format!("bool bA\n{code}"), ID), None, "{code}");
        }
        assert!(refused("bool bA\ni$0f bA\nelseIf !bA\nelse\nendIf", ID).is_some_and(|it| it.contains("elseIf")));
    }
}
