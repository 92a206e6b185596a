//! V0341: a task that is never created.

use rustc_hash::FxHashSet;
use smol_str::SmolStr;
use val3_analysis::body::{Expr, ExprId};
use val3_lang::instructions::{ON_TASKS, TASK_STATUS};
use val3_lang::operators::BinaryOp;
use val3_lang::suggest::nearest;

use crate::diagnostic::Wording;
use crate::english::all_of;
use crate::lint::{Findings, ProgramView};
use crate::phrase::did_you_mean_or;
use crate::rule::rule;

rule! {
    /// An instruction names a task that the application does not create.
    ///
    /// ## Why
    /// A task is found by its name, and only by the application or library that created it. Suspending or resuming an
    /// unknown task raises run-time error 30, killing it has no effect, and its status is always -1. Usually the name
    /// is misspelt: letter case matters. Tasks with computed names are taken into account. Each name is reported once
    /// per program. A comparison of `taskStatus` with -1 tests whether the task exists. Neither the comparison nor a call
    /// in the same program with the tested name is reported, unless the application creates a task with a similar name.
    ///
    /// ## Bad
    /// ```val3
    /// program start()
    /// begin
    ///   taskCreate "robot",10,cycle()
    ///   taskKill("robto")
    /// end
    ///
    /// program cycle()
    /// begin
    ///   waitEndMove()
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// program start()
    /// begin
    ///   taskCreate "robot",10,cycle()
    ///   taskKill("robot")
    /// end
    ///
    /// program cycle()
    /// begin
    ///   waitEndMove()
    /// end
    /// ```
    V0341 "unknown-task" Warning, Member: check
}

/// Status of a task that does not exist (5.10).
const NO_TASK: f64 = -1.0;

/// Character in the names of controller tasks (5.2).
const OF_CONTROLLER: char = '~';

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let mut told: FxHashSet<SmolStr> = FxHashSet::default();
    let presence = presence_tests(program);
    let tested: FxHashSet<SmolStr> = presence.iter().filter_map(|id| task_name(program, *id)).collect();
    let calls = program.calls().iter().filter(|call| ON_TASKS.contains(&call.instruction.name));
    for call in calls.filter(|call| !presence.contains(&call.id)) {
        let Some(argument) = call.args.first() else { continue };
        let Some(name) = program.body.string(*argument).filter(|name| !name.contains(OF_CONTROLLER)) else { continue };
        let application = program.application();
        if !application.sound || application.may_have_task(&name) || !told.insert(name.clone()) {
            continue;
        }
        let mut known: Vec<&str> = application.created_tasks().filter_map(|start| start.name.as_deref()).collect();
        known.sort_unstable();
        known.dedup();
        if tested.contains(&name) && nearest(&name, known.iter().copied()).is_none() {
            continue;
        }
        found.report(&RULE, program.range(*argument), word(&name, &known));
    }
}

/// Calls of `taskStatus` that are compared with -1, the status of a task that does not exist.
fn presence_tests(program: &ProgramView<'_>) -> FxHashSet<ExprId> {
    let mut tests = FxHashSet::default();
    if program.calls_of(TASK_STATUS).next().is_none() {
        return tests;
    }
    for (_, expr, _) in program.body.exprs() {
        if let Expr::Binary(BinaryOp::Equal | BinaryOp::NotEqual, left, right) = expr {
            let sides = [(*left, *right), (*right, *left)];
            let tested = sides.into_iter().find(|(_, value)| program.body.number(*value) == Some(NO_TASK));
            tests.extend(tested.map(|(call, _)| program.body.without_parentheses(call)));
        }
    }
    tests
}

/// Constant task name in a call of `taskStatus`.
fn task_name(program: &ProgramView<'_>, call: ExprId) -> Option<SmolStr> {
    let argument = *program.call_of(call)?.args.first()?;
    program.body.string(argument)
}

fn word(name: &str, known: &[&str]) -> Wording {
    let near = nearest(name, known.iter().copied());
    let help = match known {
        [] => "the application creates no task at all".to_owned(),
        known => did_you_mean_or(near, &format!("it creates {}", all_of(known))),
    };
    Wording::new(format!("the application creates no task called `{name}`"), "no such task", help)
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
    fn unknown_tasks_are_reported_with_a_proposal() {
        expect![[r#"
            start.pgx:7 `"Robot"` the application creates no task called `Robot`
              | no such task
              ? did you mean `robot`?
            start.pgx:9 `"io"` the application creates no task called `io`
              | no such task
              ? it creates `robot` and `screen`
        "#]].assert_eq(&program(
            "taskCreate \"robot\",10,p()\ntaskCreate \"screen\",10,p()\ntaskSuspend(\"Robot\")\ntaskKill(\"Robot\")\nnA=taskStatus(\"io\")",
        ));
    }

    #[test]
    fn a_call_after_a_test_for_the_task_is_reported_only_with_a_similar_name() {
        let kill =
            |name| format!("taskCreate \"robot\",10,p()\nif taskStatus(\"{name}\")!=-1\ntaskKill(\"{name}\")\nendIf");
        assert_eq!(program(&kill("camera")), "");
        assert!(program(&kill("Robot")).contains("did you mean `robot`?"));
    }

    #[test]
    fn applications_without_tasks_are_reported() {
        expect![[r#"
            start.pgx:5 `"robot"` the application creates no task called `robot`
              | no such task
              ? the application creates no task at all
        "#]]
        .assert_eq(&program("taskKill(\"robot\")"));
    }

    #[test]
    fn tests_for_absence_are_not_reported() {
        assert_eq!(program("wait(taskStatus(\"io\")==-1)\nif -1!=(taskStatus(\"io\"))\nput(1)\nendIf"), "");
        assert!(!program("wait(taskStatus(\"io\")==1)").is_empty());
    }

    #[test]
    fn possible_names_are_not_reported() {
        assert_eq!(program("taskCreate \"robot\",10,p()\ntaskKill(\"robot\")\ntaskKill(sA)\ntaskKill(\"main~\")"), "");
        assert_eq!(program("taskCreate \"r\"+sA,10,p()\ntaskResume(\"robot\",0)"), "");
        assert!(!program("taskCreate \"r\"+sA,10,p()\ntaskResume(\"axis\",0)").is_empty());
        assert_eq!(program("taskCreate sA,10,p()\ntaskResume(\"axis\",0)"), "");
    }
}
