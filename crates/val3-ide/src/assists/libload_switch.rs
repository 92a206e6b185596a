//! Adds a `switch` over the result of `libLoad`.

use val3_lang::instructions::LIB_LOAD;
use val3_lang::library_errors::of_load;
use val3_syntax::ast::{AstNode as _, Expr};
use val3_syntax::{SyntaxKind, SyntaxNode, TextRange};

use super::context::Context;
use super::switch_to_if::is_pure;
use super::{AssistKind, Assists};
use crate::edit::{FileEdit, SourceChange};

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    context.code()?;
    let (stmts, range) = context.stmts()?;
    let [stmt] = stmts.as_slice() else { return None };
    let stmt = stmt.syntax();
    let result = if context.is_broken(range) { None } else { LoadResult::of(stmt) }?;
    if result.stored.is_some() && stmt.next_sibling().is_some_and(|next| next.kind() == SyntaxKind::SWITCH_STMT) {
        return None;
    }
    let title = format!("Add a `switch` over the result of `{LIB_LOAD}`");
    assists.add("libload-switch", AssistKind::Rewrite, title, || Some(SourceChange::of([result.edit(context, stmt)])));
    Some(())
}

/// A call of `libLoad`, and the variable that receives its result.
struct LoadResult {
    call: TextRange,
    stored: Option<TextRange>,
}

impl LoadResult {
    /// Recognises a statement that calls `libLoad` or assigns its result.
    fn of(stmt: &SyntaxNode) -> Option<Self> {
        let mut parts = stmt.children().filter_map(Expr::cast);
        let (target, call) = match stmt.kind() {
            SyntaxKind::EXPR_STMT => (None, parts.next()?),
            SyntaxKind::ASSIGN_STMT => (Some(parts.next().filter(is_pure)?), parts.next()?),
            _ => return None,
        };
        let stored = target.map(|target| target.syntax().text_range());
        is_load(call.syntax()).then(|| Self { call: call.syntax().text_range(), stored })
    }

    fn edit(&self, context: &Context<'_>, stmt: &SyntaxNode) -> FileEdit {
        let outer = context.indentation(stmt.text_range().start());
        let line_end = context.line_end();
        let selector = context.slice(self.stored.unwrap_or(self.call));
        let mut text = format!("switch {selector}{line_end}");
        for line in cases(&context.level()) {
            text += &format!("{outer}{}{line_end}", context.written(&line));
        }
        text += &format!("{outer}endSwitch");
        match self.stored {
            Some(_) => context.replace(TextRange::empty(stmt.text_range().end()), format!("{line_end}{outer}{text}")),
            None => context.replace(stmt.text_range(), text),
        }
    }
}

/// Whether the call is `libLoad` of a library identifier.
fn is_load(call: &SyntaxNode) -> bool {
    let callee = call.first_child().filter(|_| call.kind() == SyntaxKind::CALL_EXPR);
    let name = callee.and_then(|callee| callee.last_token());
    name.is_some_and(|name| name.text() == LIB_LOAD)
}

/// A `case` for each result code with its meaning, and `default`.
fn cases(level: &str) -> Vec<String> {
    let codes = of_load().flat_map(|row| case(level, &format!("case {}", row.number), row.short));
    codes.chain(case(level, "default", "file cannot be read")).collect()
}

/// Lines of a case with a comment.
fn case(level: &str, head: &str, comment: &str) -> [String; 3] {
    [format!("{level}{head}"), format!("{level}{level}// {comment}"), format!("{level}break")]
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::assists::testing::{check, done, offered};

    const ID: &str = "libload-switch";
    const PART: &str = "\n--- part\npublic num nWeight";

    fn listing(line: &str) -> String {
        format!("library part \"Disk://part/part.pjx\" autoload=false\nnum nCode\n{line}{PART}")
    }

    #[test]
    fn each_result_gets_a_case() {
        check(
            ID,
            &listing("if true\n  nCode=part:lib$0Load(\"Disk://part\")\nendIf"),
            expect![[r#"
                usrapp/main/start.pgx
                +  switch nCode
                +    case 0
                +      // no error
                +    break
                +    case 11
                +      // loaded, interface differs
                +    break
                +    case 12
                +      // library cannot be loaded
                +    break
                +    case 13
                +      // library in use by a task
                +    break
                +    case 14
                +      // library has a running task
                +    break
                +    case 20
                +      // bad root in the path
                +    break
                +    case 21
                +      // bad path
                +    break
                +    case 22
                +      // bad file name
                +    break
                +    case 23
                +      // library not encrypted
                +    break
                +    case 30
                +      // file cannot be read or written
                +    break
                +    case 32
                +      // device not found
                +    break
                +    case 33
                +      // device fault
                +    break
                +    case 34
                +      // device does not answer
                +    break
                +    case 36
                +      // no disk in the device
                +    break
                +    case 37
                +      // disk not formatted
                +    break
                +    case 39
                +      // file not found
                +    break
                +    case 41
                +      // connection refused
                +    break
                +    case 42
                +      // FTP server does not answer
                +    break
                +    case 43
                +      // FTP fault in the controller
                +    break
                +    case 44
                +      // bad FTP parameter
                +    break
                +    case 45
                +      // FTP access denied
                +    break
                +    case 47
                +      // bad FTP user
                +    break
                +    case 48
                +      // no such FTP connection
                +    break
                +    default
                +      // file cannot be read
                +    break
                +  endSwitch
            "#]],
        );
    }

    #[test]
    fn an_unused_result_is_selected_directly() {
        let done = done(&listing("part:lib$0Load(\"Disk://part\")"), ID);
        let lines: Vec<&str> = done.lines().take(5).collect();
        expect![[r#"
            usrapp/main/start.pgx
            -part:libLoad("Disk://part")
            +switch part:libLoad("Disk://part")
            +  case 0
            +    // no error"#]]
        .assert_eq(&lines.join("\n"));
    }

    #[test]
    fn other_statements_and_results_with_a_switch_are_not_offered() {
        for line in ["nCode$0=1", "nCode=part:li$0bSave()", "nCode=part:lib$0Load(\"a\")\nswitch nCode\nendSwitch"] {
            assert_eq!(offered(&listing(line), ID), None, "{line}");
        }
    }
}
