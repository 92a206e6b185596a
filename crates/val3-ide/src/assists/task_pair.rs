//! Ends a task of the same name before a task is created.

use val3_lang::instructions::{TASK_KILL, TASK_STATUS};
use val3_syntax::ast::{AstNode as _, Expr, Stmt};
use val3_syntax::{SyntaxKind, TextRange};

use super::context::Context;
use super::switch_to_if::is_pure;
use super::{AssistKind, Assists};
use crate::edit::SourceChange;

/// Result of `taskStatus` if no such task exists.
const NO_TASK: &str = "-1";

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    context.code()?;
    let (stmts, _) = context.stmts()?;
    let [create] = stmts.as_slice() else { return None };
    let create = create.syntax();
    if create.kind() != SyntaxKind::TASK_CREATE_STMT || context.is_broken(create.text_range()) {
        return None;
    }
    let name = create.children().find_map(Expr::cast).filter(is_pure)?;
    let name = context.slice(name.syntax().text_range());
    let previous = create.prev_sibling().and_then(Stmt::cast);
    if previous.is_some_and(|stmt| ends(context, &stmt, name)) {
        return None;
    }
    let title = format!("End the task before it is created with `{TASK_KILL}`");
    assists.add("task-pair", AssistKind::Rewrite, title, || {
        let start = create.text_range().start();
        let (line_end, outer, level) = (context.line_end(), context.indentation(start), context.level());
        // `taskKill` returns only after the task has ended, so no wait is necessary (5.4, 5.10).
        let guard = [
            format!("if {TASK_STATUS}({name})!={NO_TASK}"),
            format!("{outer}{level}{TASK_KILL}({name})"),
            format!("{outer}endIf"),
            outer.to_owned(),
        ];
        Some(SourceChange::of([context.replace(TextRange::empty(start), guard.join(line_end))]))
    });
    Some(())
}

/// Whether the statement calls `taskKill` with this name, directly or in a block.
fn ends(context: &Context<'_>, stmt: &Stmt, name: &str) -> bool {
    let calls = stmt.syntax().descendants().filter(|node| node.kind() == SyntaxKind::CALL_EXPR);
    let text = |range| context.slice(range).replace([' ', '\t'], "");
    let wanted = format!("{TASK_KILL}({})", name.replace([' ', '\t'], ""));
    calls.into_iter().any(|call| text(call.text_range()) == wanted)
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::assists::testing::{check, offered};

    const ID: &str = "task-pair";
    const OTHER: &str = "\nprogram other()\nbegin\n  delay(1)\nend";

    #[test]
    fn a_task_of_the_name_is_ended_before() {
        check(
            ID,
            &format!("if true\n  taskC$0reate \"watch\",10,other()\nendIf{OTHER}"),
            expect![[r#"
                usrapp/main/start.pgx
                +  if taskStatus("watch")!=-1
                +    taskKill("watch")
                +  endIf
            "#]],
        );
        check(
            ID,
            &format!("string sTask\nbool bOver\ntaskCr$0eateSync \"a\"+sTask,0.004,bOver,other(){OTHER}"),
            expect![[r#"
                usrapp/main/start.pgx
                +if taskStatus("a"+sTask)!=-1
                +  taskKill("a"+sTask)
                +endIf
            "#]],
        );
    }

    #[test]
    fn code_without_a_cdata_section_is_escaped() {
        let program = "<Programs><Program name=\"other\"><Code>begin\r\n\ttaskCreate &quot;$0a&quot;,1,start()\r\nend</Code></Program></Programs>";
        check(
            ID,
            &format!("put(1)\n=== main/other.pgx\n{program}"),
            expect![[r#"
                usrapp/main/other.pgx
                +	if taskStatus(&quot;a&quot;)!=-1
                +	  taskKill(&quot;a&quot;)
                +	endIf
            "#]],
        );
    }

    #[test]
    fn a_task_that_is_ended_needs_nothing() {
        for before in ["taskKill( \"a\" )", "if taskStatus(\"a\")!=-1\n  taskKill(\"a\")\nendIf"] {
            assert_eq!(offered(&format!("{before}\ntaskCre$0ate \"a\",1,other(){OTHER}"), ID), None, "{before}");
        }
        let other_name = format!("taskKill(\"b\")\ntaskCre$0ate \"a\",1,other(){OTHER}");
        assert!(offered(&other_name, ID).is_some());
    }

    #[test]
    fn other_lines_are_not_offered() {
        for line in ["taskK$0ill(\"a\")", "taskCre$0ate toString(\"\",1),1,other()", "taskCre$0ate \"a\",(,other()"] {
            assert_eq!(offered(&format!("{line}{OTHER}"), ID), None, "{line}");
        }
    }
}
