//! V0330: a condition with an empty block.

use val3_analysis::body::{Stmt, StmtKind};
use val3_syntax::{TextRange, TextSize, text_at};

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// The block of an `if` or `elseIf` has neither a statement nor a comment.
    ///
    /// ## Why
    /// Nothing happens if the condition holds. Either code is missing, or the test is not needed. A comment in the
    /// block shows that it is empty on purpose.
    ///
    /// ## Bad
    /// ```val3
    /// bool bReady
    ///
    /// if bReady==true
    /// endIf
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// bool bReady
    ///
    /// if bReady==true
    ///   // nothing to wait for
    /// else
    ///   delay(1)
    /// endIf
    /// ```
    V0330 "empty-block" Info, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for stmt in program.stmts() {
        let StmtKind::If { arms, .. } = &stmt.kind else { continue };
        for (condition, block) in arms {
            let Some(condition) = condition.map(|id| program.range(id)).filter(|_| block.is_empty()) else { continue };
            if !has_comment(program, condition.end(), stmt) {
                found.report(&RULE, condition, word());
            }
        }
    }
}

/// Whether there is a comment between `start` and the next part of the statement.
fn has_comment(program: &ProgramView<'_>, start: TextSize, stmt: &Stmt) -> bool {
    let range = TextRange::new(start, stmt.range.end());
    let text = text_at(program.file.text(program.db), range);
    let inner = text.lines().map(str::trim_start).take_while(|line| {
        let word = line.split(|character: char| !character.is_ascii_alphabetic()).next().unwrap_or("");
        !["else", "elseif", "endif"].contains(&word.to_ascii_lowercase().as_str())
    });
    inner.into_iter().any(|line| line.contains("//"))
}

fn word() -> Wording {
    Wording::new("nothing happens if this condition is true", "no statement and no comment follows", "")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn empty_branches_are_reported() {
        expect![[r#"
            start.pgx:5 `n==1` nothing happens if this condition is true
              | no statement and no comment follows
            start.pgx:9 `(n==3)` nothing happens if this condition is true
              | no statement and no comment follows
        "#]]
        .assert_eq(&check(
            &RULE,
            "num n\nif n==1\n\nelseIf n==2\nput(2)\nelseIf (n==3)\nelse\n// the rest\nput(n)\nendIf",
        ));
    }

    #[test]
    fn branches_with_a_comment_or_statement_are_not_reported() {
        assert_eq!(
            check(&RULE, "num n\nif n==1\n// meant\nelseIf n==2\nput(2)\nelse\nendIf\nwhile n==1\nendWhile"),
            ""
        );
    }
}
