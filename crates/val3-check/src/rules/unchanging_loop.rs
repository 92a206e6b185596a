//! V0319: a loop whose condition nothing changes.

use rustc_hash::FxHashSet;
use smol_str::SmolStr;
use val3_analysis::body::{Expr, ExprId, Stmt, StmtKind};
use val3_analysis::effects::{AccessKind, RootVariable};
use val3_lang::instructions::TASK_KILL;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// The condition of a loop consists of local variables that nothing in the loop changes.
    ///
    /// ## Why
    /// The condition has the same value in each pass, so the loop runs never, once or for ever. Usually the line that
    /// counts is missing. Only local variables are considered: other tasks change global data. A loop with `return` is
    /// not reported, nor is one on a single `bool` such as `!l_bStop`, which is a usual way to write an endless loop.
    ///
    /// ## Bad
    /// ```val3
    /// program start()
    ///   num l_nCount
    /// begin
    ///   l_nCount=0
    ///   while l_nCount<5
    ///     putln(l_nCount)
    ///     delay(1)
    ///   endWhile
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// program start()
    ///   num l_nCount
    /// begin
    ///   l_nCount=0
    ///   while l_nCount<5
    ///     putln(l_nCount)
    ///     delay(1)
    ///     l_nCount=l_nCount+1
    ///   endWhile
    /// end
    /// ```
    V0319 "unchanging-loop" Warning, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for stmt in program.stmts() {
        let condition = match &stmt.kind {
            StmtKind::While { condition, .. } | StmtKind::Do { condition, .. } => *condition,
            _ => continue,
        };
        let Some((condition, locals)) = condition.and_then(|id| Some((id, locals(program, id)?))) else { continue };
        if !locals.is_empty() && !may_end(program, stmt, &locals) {
            let mut names: Vec<&str> = locals.iter().map(SmolStr::as_str).collect();
            names.sort_unstable();
            found.report(&RULE, program.range(condition), word(&names));
        }
    }
}

/// Variables of a condition; `None` if it depends on something other than local variables and constants.
fn locals(program: &ProgramView<'_>, condition: ExprId) -> Option<FxHashSet<SmolStr>> {
    let body = program.body;
    // A constant has no variables, and a single flag may be meant to never change.
    if !matches!(body.expr(body.without_parentheses(condition)), Expr::Binary(..)) {
        return None;
    }
    let mut locals = FxHashSet::default();
    for part in body.within(condition) {
        match body.expr(part) {
            Expr::Call(..) | Expr::Path { .. } | Expr::Assign(..) | Expr::Missing | Expr::Struct(_) => return None,
            Expr::Name(name) => match program.effects.root(part)? {
                RootVariable::Local(local) if !program.is_linkable(name) => _ = locals.insert(local),
                _ => return None,
            },
            _ => {}
        }
    }
    Some(locals)
}

/// Whether a line of the loop may change one of the variables or leave the loop.
fn may_end(program: &ProgramView<'_>, stmt: &Stmt, locals: &FxHashSet<SmolStr>) -> bool {
    let changes = program.effects.all().iter().any(|access| {
        let is_local = matches!(&access.root, RootVariable::Local(name) if locals.contains(name));
        // A program that has received the variable by reference may change it at any time.
        let is_inside = access.kind == AccessKind::Reference || stmt.range.contains_range(program.range(access.id));
        is_local && is_inside && access.kind != AccessKind::Read
    });
    let kills = || program.calls_of(TASK_KILL).any(|call| stmt.range.contains_range(program.range(call.id)));
    changes || stmt.holds(&StmtKind::Return) || kills()
}

fn word(names: &[&str]) -> Wording {
    let names: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    Wording::new(
        format!("nothing in the loop changes {}", names.join(" or ")),
        "the same in each pass",
        "change the variable in the loop, or compare another one",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn program(code: &str) -> String {
        let head = "num nG\nprogram start()\nnum l_nA\nnum l_nB[3]\nbool l_bA\nbegin\n";
        let others = "program change(num& x_nA)\nbegin\nx_nA=1\nend";
        check(&RULE, &format!("{head}{code}\nend\n{others}"))
    }

    #[test]
    fn loops_whose_condition_never_changes_are_reported() {
        expect![[r#"
            start.pgx:10 `l_nA<5` nothing in the loop changes `l_nA`
              | the same in each pass
              ? change the variable in the loop, or compare another one
            start.pgx:15 `l_nB[l_nA]==1 and l_nA>2` nothing in the loop changes `l_nA` or `l_nB`
              | the same in each pass
              ? change the variable in the loop, or compare another one
        "#]]
        .assert_eq(&program("while l_nA<5\ndelay(1)\nendWhile\ndo\nput(l_nA)\nuntil l_nB[l_nA]==1 and l_nA>2"));
    }

    #[test]
    fn loops_that_may_end_are_not_reported() {
        for code in [
            "while l_nA<5\nl_nA=l_nA+1\nendWhile",
            "while l_nA<5\ncall change(l_nA)\nendWhile",
            "while l_nA<5\nif nG==1\nreturn\nendIf\ndelay(1)\nendWhile",
            "while l_nA<nG\ndelay(1)\nendWhile",
            "while l_nA<clock()\ndelay(1)\nendWhile",
            "while l_bA\ndelay(1)\nendWhile",
            "while !l_bA\ndelay(1)\nendWhile",
            "while true\ndelay(1)\nendWhile",
            "taskCreate \"t\",10,change(l_nA)\nwhile l_nA<5\ndelay(1)\nendWhile",
            "while l_nB[0]==1\nl_nB[1]=2\nendWhile",
            "while l_nA<5\ntaskKill(\"main~\")\nendWhile",
            "while l_nA<5\nfor l_nA=1 to 3\nput(1)\nendFor\nendWhile",
        ] {
            assert_eq!(program(code), "", "{code}");
        }
    }
}
