//! V0342: a task that is created again while it runs.

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_analysis::body::{Body, Expr, Stmt, StmtKind};
use val3_analysis::flow::PointKind;
use val3_lang::instructions;
use val3_syntax::TextRange;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A program creates two tasks with the same name, one directly after the other.
    ///
    /// ## Why
    /// The first task is still running when the second is created. Two tasks of an application with the same name raise
    /// run-time error 31. The rule only examines creations between which nothing waits, ends a task or calls a program,
    /// and tasks that never end and that an endless loop creates in each pass.
    ///
    /// ## Bad
    /// ```val3
    /// program start()
    /// begin
    ///   taskCreate "axis",10,watchAxis(1)
    ///   taskCreate "axis",10,watchAxis(2)
    /// end
    ///
    /// program watchAxis(num x_nAxis)
    /// begin
    ///   delay(x_nAxis)
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// program start()
    /// begin
    ///   taskCreate "axis1",10,watchAxis(1)
    ///   taskCreate "axis2",10,watchAxis(2)
    /// end
    ///
    /// program watchAxis(num x_nAxis)
    /// begin
    ///   delay(x_nAxis)
    /// end
    /// ```
    V0342 "duplicate-task" Warning, Member: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    if program.flow().points().all(|(_, point)| !matches!(point.kind, PointKind::TaskCreate(_))) {
        return;
    }
    let mut pairs = Vec::new();
    in_endless_loops(program, &mut pairs);
    in_block(program.body, &program.body.block, &mut pairs);
    for EqualNames { name, first, second } in pairs {
        let reported = found.report(&RULE, second, word(&name, first == second));
        if first != second {
            reported.related(first, "the first one");
        }
    }
}

/// Two tasks with the same name. A task that a loop creates conflicts with itself.
struct EqualNames {
    name: SmolStr,
    first: TextRange,
    second: TextRange,
}

/// Endless tasks that an endless loop creates in each pass.
fn in_endless_loops(program: &ProgramView<'_>, pairs: &mut Vec<EqualNames>) {
    for stmt in program.stmts() {
        if program.endless_condition(stmt).is_none() || stmt.holds(&StmtKind::Return) {
            continue;
        }
        for (name, range) in stmt.blocks().flatten().filter_map(|stmt| endless_task(program, stmt)) {
            pairs.push(EqualNames { name, first: range, second: range });
        }
    }
}

/// A created task whose program never ends, and that no program kills.
fn endless_task(program: &ProgramView<'_>, stmt: &Stmt) -> Option<(SmolStr, TextRange)> {
    let (name, range) = created(program.body, stmt)?;
    let StmtKind::TaskCreate { arguments, .. } = &stmt.kind else { return None };
    let Expr::Call(callee, _) = program.body.expr(*arguments.last()?) else { return None };
    let Expr::Name(run) = program.body.expr(*callee) else { return None };
    let application = program.application();
    let is_managed = application.managed_tasks.iter().any(|beginning| name.starts_with(beginning.as_str()));
    (application.sound && application.endless.contains(run) && !is_managed).then_some((name, range))
}

fn in_block(body: &Body, block: &[Stmt], pairs: &mut Vec<EqualNames>) {
    let mut running: FxHashMap<SmolStr, TextRange> = FxHashMap::default();
    for stmt in block {
        if let Some((name, range)) = created(body, stmt) {
            if let Some(first) = running.insert(name.clone(), range) {
                pairs.push(EqualNames { name, first, second: range });
            }
        } else if !running.is_empty() && may_wait(body, stmt) {
            running.clear();
        }
        match &stmt.kind {
            StmtKind::For { block, .. } if creates(body, block) && !may_wait(body, stmt) => {
                let again = block.iter().filter_map(|stmt| created(body, stmt));
                pairs.extend(again.map(|(name, range)| EqualNames { name, first: range, second: range }));
            }
            _ => stmt.blocks().for_each(|inner| in_block(body, inner, pairs)),
        }
    }
}

/// Task that the statement creates, if its name is known.
fn created(body: &Body, stmt: &Stmt) -> Option<(SmolStr, TextRange)> {
    let StmtKind::TaskCreate { arguments, .. } = &stmt.kind else { return None };
    let name = arguments.first()?;
    Some((body.string(*name)?, body.range(*name)))
}

fn creates(body: &Body, block: &[Stmt]) -> bool {
    block.iter().any(|stmt| created(body, stmt).is_some())
}

/// Whether the statement may give other tasks their turn, may kill a task, or has unknown effects.
fn may_wait(body: &Body, stmt: &Stmt) -> bool {
    let inside = body.exprs().filter(|(_, _, range)| stmt.range.contains_range(*range));
    let mut callees = inside
        .filter_map(|(_, expr, _)| if let Expr::Call(callee, _) = expr { Some(body.expr(*callee)) } else { None });
    !is_creation_only(body, stmt) && callees.any(may_block)
}

/// Whether the callee is an instruction that may wait, or a program.
fn may_block(callee: &Expr) -> bool {
    let Expr::Name(name) = callee else { return true };
    instructions::find(name).is_none_or(|instruction| instruction.blocking)
}

/// Whether the call is inside a task creation, so that it does not run on this line.
fn is_creation_only(body: &Body, stmt: &Stmt) -> bool {
    match &stmt.kind {
        StmtKind::TaskCreate { .. } => true,
        StmtKind::For { block, .. } => {
            block.iter().all(|stmt| created(body, stmt).is_some() || !may_wait(body, stmt)) && !block.is_empty()
        }
        _ => false,
    }
}

fn word(name: &str, again: bool) -> Wording {
    let message = if again {
        format!("the second round creates the task `{name}` while the first one runs")
    } else {
        format!("the task `{name}` was created just before and still runs")
    };
    Wording::new(message, "run-time error 31", "use a different name for each task")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn program(code: &str) -> String {
        check(&RULE, &format!("string sA\nnum nA\nprogram p()\nbegin\nend\nprogram start()\nbegin\n{code}\nend"))
    }

    #[test]
    fn two_tasks_of_one_name_are_reported() {
        expect![[r#"
            start.pgx:7 `"a"` the task `a` was created just before and still runs
              | run-time error 31
              ? use a different name for each task
              > start.pgx:5 `"a"` the first one
        "#]]
        .assert_eq(&program("taskCreate \"a\",10,p()\nnA=abs(1)\ntaskCreate \"a\",10,p()"));
    }

    #[test]
    fn a_task_created_in_a_loop_is_reported() {
        expect![[r#"
            start.pgx:6 `"a"` the second round creates the task `a` while the first one runs
              | run-time error 31
              ? use a different name for each task
        "#]]
        .assert_eq(&program("for nA=0 to 2\ntaskCreate \"a\",10,p()\nendFor"));
    }

    #[test]
    fn a_task_that_may_have_ended_is_not_reported() {
        let between = |line: &str| program(&format!("taskCreate \"a\",10,p()\n{line}\ntaskCreate \"a\",10,p()"));
        for line in
            ["taskKill(\"a\")", "delay(1)", "call p()", "wait(taskStatus(\"a\")==-1)", "if nA==0\ndelay(0)\nendIf"]
        {
            assert_eq!(between(line), "", "{line}");
        }
        assert_eq!(program("for nA=0 to 2\ntaskCreate \"a\",10,p()\ndelay(1)\nendFor"), "");
    }

    #[test]
    fn different_names_are_not_reported() {
        assert_eq!(
            program("taskCreate \"a\",10,p()\ntaskCreate \"b\",10,p()\ntaskCreate sA,10,p()\ntaskCreate sA,10,p()"),
            ""
        );
        assert_eq!(program("for nA=0 to 2\ntaskCreate \"a\"+toString(\"\",nA),10,p()\nendFor"), "");
        assert_eq!(program("if nA==0\ntaskCreate \"a\",10,p()\nelse\ntaskCreate \"a\",20,p()\nendIf"), "");
    }

    fn start_and_work(code: &str, work: &str) -> String {
        check(&RULE, &format!("program start()\nbegin\n{code}\nend\nprogram work()\nbegin\n{work}\nend"))
    }

    #[test]
    fn tasks_without_end_are_created_once() {
        let endless = "while true\ndelay(1)\nendWhile";
        let creation = "taskCreate \"w\",10,work()";
        expect![[r#"
            start.pgx:6 `"w"` the second round creates the task `w` while the first one runs
              | run-time error 31
              ? use a different name for each task
        "#]]
        .assert_eq(&start_and_work(&format!("while true\n{creation}\ndelay(1)\nendWhile"), endless));
        assert_eq!(start_and_work(&format!("while true\n{creation}\ndelay(9)\nendWhile"), "delay(1)"), "");
        assert_eq!(
            start_and_work(&format!("while true\n{creation}\ndelay(9)\ntaskKill(\"w\")\nendWhile"), endless),
            ""
        );
        assert_eq!(
            start_and_work(
                &format!("while true\nif taskStatus(\"w\")==-1\n{creation}\nendIf\ndelay(9)\nendWhile"),
                endless
            ),
            ""
        );
    }
}
