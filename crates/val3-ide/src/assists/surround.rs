//! Surrounds the selected statements with a block.

use super::context::Context;
use super::{AssistKind, Assists};
use crate::declare::{self, NewVariable, free};
use crate::edit::{FileEdit, SourceChange};

const GROUP: &str = "Surround";
/// Condition with which the block behaves like its statements.
const CONDITION: &str = "true";

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    // Without a selection, surrounding a single line is rarely intended.
    if context.range.is_empty() {
        return None;
    }
    context.code()?;
    let (_, range) = context.stmts()?;
    let around = |head: &str, tail: &str| block(context, range, head, tail);
    let kind = AssistKind::Rewrite;
    assists.add_in(Some(GROUP), "surround-if", kind, "Surround with `if`", || {
        Some(with_condition(context, around("if true", "endIf")))
    });
    assists.add_in(Some(GROUP), "surround-while", kind, "Surround with `while`", || {
        Some(with_condition(context, around("while true", "endWhile")))
    });
    assists.add_in(Some(GROUP), "surround-for", kind, "Surround with `for`", || {
        let counter = NewVariable::single(&counter(context), "num");
        let local = declare::locals(context.db, context.file, &[&counter])?;
        let block = around(&format!("for {}=0 to 1", counter.name), "endFor");
        let start = block.range.start();
        Some(SourceChange::of([local, block]).with_placeholder(context.file, start, "0 to 1"))
    });
    Some(())
}

/// Change that inserts a block whose condition the user then replaces.
fn with_condition(context: &Context<'_>, block: FileEdit) -> SourceChange {
    let start = block.range.start();
    SourceChange::of([block]).with_placeholder(context.file, start, CONDITION)
}

fn counter(context: &Context<'_>) -> String {
    let options = context.options();
    let number = options.prefixes.get("num").map_or("", String::as_str);
    free(&format!("{}{number}Index", options.local_prefix), |name| context.is_taken(name))
}

/// Statements indented by one level, between two lines.
fn block(context: &Context<'_>, range: val3_syntax::TextRange, head: &str, tail: &str) -> FileEdit {
    let outer = context.indentation(range.start());
    let line_end = context.line_end();
    let inner = indented(context.slice(range), &context.level());
    let text = format!("{head}{line_end}{outer}{}{inner}{line_end}{outer}{tail}", context.level());
    context.replace(range, text)
}

/// Indents all lines except the first by one level; blank lines are unchanged.
pub(super) fn indented(text: &str, level: &str) -> String {
    let mut lines = text.split_inclusive('\n');
    let mut new = lines.next().unwrap_or("").to_owned();
    for line in lines {
        if !line.trim().is_empty() {
            new += level;
        }
        new += line;
    }
    new
}

#[cfg(test)]
mod tests {
    use expect_test::expect;
    use val3_analysis::db::FileRange;

    use crate::assists::resolve_assist;
    use crate::assists::testing::{check, offered};
    use crate::testing::MarkedListing;

    #[test]
    fn the_condition_is_a_placeholder() {
        let marked = MarkedListing::new("num nA\n  nA=1\n$0  nA=2$0");
        let place = FileRange { file: marked.at().file, range: marked.selected.unwrap() };
        for (id, text) in [("surround-if", "true"), ("surround-while", "true"), ("surround-for", "0 to 1")] {
            let change = resolve_assist(marked.db(), id, place).unwrap();
            let mut shown = place.file.text(marked.db()).to_string();
            for edit in change.edits.iter().rev() {
                shown.replace_range(std::ops::Range::<usize>::from(edit.range), &edit.text);
            }
            let range = change.placeholder.unwrap().range;
            assert_eq!(&shown[std::ops::Range::<usize>::from(range)], text);
        }
    }

    #[test]
    fn one_statement_is_surrounded() {
        check(
            "surround-if",
            "num nA\n  nA=1\n$0  nA=2$0",
            expect![[r#"
            usrapp/main/start.pgx
            -  nA=2
            +  if true
            +    nA=2
            +  endIf
        "#]],
        );
        check(
            "surround-while",
            "num nA\nif nA==1\n  $0nA=2$0\nendIf",
            expect![[r#"
            usrapp/main/start.pgx
            -  nA=2
            +  while true
            +    nA=2
            +  endWhile
        "#]],
        );
    }

    #[test]
    fn the_selected_lines_are_surrounded() {
        check(
            "surround-if",
            "num nA\n$0// first\nnA=1\n\nif nA==2\n  nA=3\nendIf\n$0nA=4",
            expect![[r#"
            usrapp/main/start.pgx
            -// first
            -nA=1
            -
            -if nA==2
            -  nA=3
            +if true
            +  // first
            +  nA=1
            +
            +  if nA==2
            +    nA=3
            +  endIf
        "#]],
        );
        check(
            "surround-if",
            "num nA\nif nA==1\n  $0// why\n  nA=2$0\nendIf",
            expect![[r#"
            usrapp/main/start.pgx
            -  // why
            -  nA=2
            +  if true
            +    // why
            +    nA=2
            +  endIf
        "#]],
        );
        check(
            "surround-for",
            "program start()\n  num l_nIndex\nbegin\n  $0l_nIndex=1$0\nend",
            expect![[r#"
            usrapp/main/start.pgx
            -    </Locals>
            -    <Code><![CDATA[begin
            -  l_nIndex=1
            +      <Local name="l_nIndex2" type="num" xsi:type="array" size="1" />
            +    </Locals>
            +    <Code><![CDATA[begin
            +  for l_nIndex2=0 to 1
            +    l_nIndex=1
            +  endFor
        "#]],
        );
    }

    #[test]
    fn a_selection_is_extended_to_whole_statements() {
        for listing in [
            "num nA\nnA=$02",
            "num nA\n$0if nA==1\nnA=2\nendIf",
            "num nA\n$0if nA==1\n  nA$0=2\nendIf",
            "num nA\nif nA==1\n  $0nA=2\nend$0If\nnA=1",
            "num nA\nif $0nA==1$0\nendIf",
            "num nA\n$0// nothing$0\nnA=1",
        ] {
            assert_eq!(offered(listing, "surround-if"), None, "{listing}");
        }
    }

    #[test]
    fn escaped_code_is_surrounded() {
        check(
            "surround-if",
            "num nA\n=== main/start.pgx\n<programList xmlns=\"ProgramNameSpace\">\n  <program name=\"start\" public=\"false\">\n    <source><code>begin\r\n  $0put(\"&lt;\")$0\r\nend</code></source>\n  </program>\n</programList>\n",
            expect![[r#"
                usrapp/main/start.pgx
                -  put("&lt;")
                +  if true
                +    put("&lt;")
                +  endIf
            "#]],
        );
    }
}
