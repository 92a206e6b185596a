//! Adds the missing parts of a `switch`: `default`, and a `case` for each further known value of the selector.

mod constants;
mod values;

use val3_syntax::ast::{AstNode, CaseClause, SwitchStmt};
use val3_syntax::{TextRange, TextSize};

use super::context::Context;
use super::switch_to_if::is_at_head;
use super::{AssistKind, Assists};
use crate::edit::SourceChange;
use constants::Constants;

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    let switch = context.node::<SwitchStmt>().filter(|switch| is_at_head(context, switch))?;
    switch.end_switch()?;
    let cases: Vec<CaseClause> = switch.case_clauses().collect();
    let is_whole = cases.iter().all(|case| case.break_keyword().is_some()) && switch.stmts().next().is_none();
    if !is_whole || context.is_broken(switch.syntax().text_range()) {
        return None;
    }
    let place = NewCases::of(context, &switch, cases.last())?;
    if switch.default_clauses().next().is_none() {
        assists.add("add-default", AssistKind::Rewrite, "Add `default`", || {
            Some(place.change(context, &["default".to_owned()]))
        });
    }
    let selector = context.expr_at(switch.selector()?.syntax().text_range())?;
    let constants = Constants::of(context);
    let missing = values::missing(context, &constants, selector, &cases);
    let title = match missing.as_slice() {
        [] => return None,
        [value] => format!("Add missing `case {value}`"),
        more => format!("Add {} missing cases", more.len()),
    };
    assists.add("add-missing-cases", AssistKind::Rewrite, title, || {
        let heads: Vec<String> = missing.iter().map(|value| format!("case {value}")).collect();
        Some(place.change(context, &heads))
    });
    Some(())
}

/// Insertion point of new cases, after the existing ones.
struct NewCases {
    at: TextSize,
    indentation: String,
}

impl NewCases {
    fn of(context: &Context<'_>, switch: &SwitchStmt, last: Option<&CaseClause>) -> Option<Self> {
        let outer = switch.syntax().text_range().start();
        let (at, indentation) = match last.map(|case| case.syntax().text_range()) {
            Some(range) => (range.end(), context.indentation(range.start()).to_owned()),
            None => {
                let end = switch.selector()?.syntax().text_range().end();
                (end, format!("{}{}", context.indentation(outer), context.level()))
            }
        };
        Some(Self { at, indentation })
    }

    fn change(&self, context: &Context<'_>, heads: &[String]) -> SourceChange {
        let (line_end, blanks) = (context.line_end(), &self.indentation);
        let case = |head: &String| format!("{line_end}{blanks}{}{line_end}{blanks}break", context.written(head));
        let text: String = heads.iter().map(case).collect();
        SourceChange::of([context.replace(TextRange::empty(self.at), text)])
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::assists::testing::{check, done, offered};

    const ID: &str = "add-missing-cases";

    /// Values of the added cases.
    fn added(listing: &str) -> Vec<String> {
        let change = if offered(listing, ID).is_some() { done(listing, ID) } else { String::new() };
        let heads = change.lines().filter_map(|line| line.strip_prefix('+')?.trim_start().strip_prefix("case "));
        heads.map(str::to_owned).collect()
    }

    #[test]
    fn a_default_is_added_after_the_cases() {
        check(
            "add-default",
            "num nA\n  sw$0itch nA\n    case 1\n      nA=2\n    break\n    // end\n  endSwitch",
            expect![[r#"
                usrapp/main/start.pgx
                +    default
                +    break
            "#]],
        );
        check(
            "add-default",
            "num nA\n  sw$0itch nA\n  endSwitch",
            expect![[r#"
            usrapp/main/start.pgx
            +    default
            +    break
        "#]],
        );
        assert_eq!(offered("num nA\nsw$0itch nA\ndefault\nbreak\nendSwitch", "add-default"), None);
    }

    #[test]
    fn cases_come_before_the_default() {
        check(
            ID,
            "bool bA\n  sw$0itch bA\n    case true\n      bA=false\n    break\n    // other\n    default\n    break\n  endSwitch",
            expect![[r#"
                usrapp/main/start.pgx
                +    case false
                +    break
            "#]],
        );
    }

    #[test]
    fn values_of_the_data_in_the_application_are_missing() {
        let listing = "num nState\nnum nOther\nprogram start()\nbegin\n  sw$0itch nState\n    case 1\n    break\n  endSwitch\nend\nprogram other()\nbegin\n  nState=3\n  nState=1\n  nOther=9\n  if nState==-4 or (5!=nState)\n  endIf\n  switch nState\n    case 7,8\n    break\n  endSwitch\nend\nprogram hides()\n  num nState\nbegin\n  nState=11\nend";
        assert_eq!(added(listing), ["-4", "3", "5", "7", "8"]);
    }

    #[test]
    fn values_of_a_local_are_those_of_its_program() {
        let listing = "string sState\nprogram start()\n  string l_s\nbegin\n  l_s=\"b<\"\n  if l_s==\"a\"\n  endIf\n  sw$0itch l_s\n  endSwitch\nend\nprogram other()\n  string l_s\nbegin\n  l_s=\"c\"\nend";
        assert_eq!(added(listing), ["\"a\"", "\"b<\""]);
    }

    #[test]
    fn named_numbers_of_the_same_group_are_missing() {
        let data = "num eIdle = 0\nnum eRun = 1\nnum eStop = 2\nnum eNext = 3\nnum edge = 4\nnum nState\n";
        let listing =
            format!("{data}eNext=eNext+1\nsw$0itch nState\n  case eIdle\n  break\n  case eRun\n  break\nendSwitch");
        assert_eq!(added(&listing), ["eStop"]);
        let listing = format!("{data}nState=eStop\nsw$0itch nState\n  case 0\n  break\nendSwitch");
        assert_eq!(added(&listing), ["eStop"]);
        let listing = "num nIdle = 0\nnum nRun = 1\nnum nStop = 2\nnum nState\nsw$0itch nState\n  case nIdle\n  break\n  case nRun\n  break\nendSwitch";
        assert_eq!(added(listing), [] as [&str; 0]);
    }

    #[test]
    fn results_of_instructions_are_missing() {
        assert_eq!(added("sw$0itch workingMode()\n  case 1\n  break\nendSwitch"), ["0", "2", "3", "4"]);
        assert_eq!(added("num nA\nnA=taskStatus(\"a\")\nsw$0itch nA\nendSwitch"), ["-1", "0", "1"]);
        assert_eq!(
            added("config cA\nsw$0itch cA.elbow\n  case efree\n  break\nendSwitch"),
            ["esame", "epositive", "enegative"]
        );
    }

    #[test]
    fn code_of_s6_is_completed() {
        check(
            ID,
            "string sA\n=== main/start.pgx\n<programList xmlns=\"ProgramNameSpace\">\r\n  <program name=\"start\" public=\"false\">\r\n    <source><code>begin\r\n  sA=&quot;x&quot;\r\n  sw$0itch sA\r\n  endSwitch\r\nend</code></source>\r\n  </program>\r\n</programList>\r\n",
            expect![[r#"
                usrapp/main/start.pgx
                +    case &quot;x&quot;
                +    break
            "#]],
        );
    }

    #[test]
    fn other_places_are_not_offered() {
        for code in [
            "sw$0itch nA\nendSwitch",
            "switch nA\n  case 1\n    n$0A=2\n  break\nendSwitch",
            "nA=2\nsw$0itch nA\n  case 1\n    nA=1\nendSwitch",
            "nA=2\nsw$0itch nA\n  case 2\n  break",
        ] {
            assert_eq!(offered(&format!("num nA\n{code}"), ID), None, "{code}");
        }
    }
}
