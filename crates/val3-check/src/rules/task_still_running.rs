//! V0345: a second task with an endless task's name.

use smol_str::SmolStr;
use val3_analysis::application::summary;
use val3_analysis::db::FileRange;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// Two programs create tasks with the same name, and neither task ever ends.
    ///
    /// ## Why
    /// Two tasks of an application cannot have the same name at the same time: the second creation raises run-time
    /// error 31. The rule reports tasks of which the first is created each time the application runs, if both run an
    /// endless loop and no program except `stop` ends the task with `taskKill` or reads its state with `taskStatus`.
    ///
    /// ## Bad
    /// ```val3
    /// program start()
    /// begin
    ///   taskCreate "watch",10,watchDoor()
    ///   call initGripper()
    /// end
    ///
    /// program initGripper()
    /// begin
    ///   taskCreate "watch",10,watchGripper()
    /// end
    ///
    /// program watchDoor()
    /// begin
    ///   while true
    ///     putln("door")
    ///     delay(1)
    ///   endWhile
    /// end
    ///
    /// program watchGripper()
    /// begin
    ///   while true
    ///     putln("gripper")
    ///     delay(1)
    ///   endWhile
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// program start()
    /// begin
    ///   taskCreate "watchDoor",10,watchDoor()
    ///   call initGripper()
    /// end
    ///
    /// program initGripper()
    /// begin
    ///   taskCreate "watchGripper",10,watchGripper()
    /// end
    ///
    /// program watchDoor()
    /// begin
    ///   while true
    ///     putln("door")
    ///     delay(1)
    ///   endWhile
    /// end
    ///
    /// program watchGripper()
    /// begin
    ///   while true
    ///     putln("gripper")
    ///     delay(1)
    ///   endWhile
    /// end
    /// ```
    V0345 "task-still-running" Warning, Member: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    // Most programs create no task, so they do not need the summary of the application.
    let starts = &summary(program.db, program.project, program.file).tasks;
    for start in starts {
        let Some(name) = &start.name else { continue };
        let Some(other) = program.application().creator_of_same(program.name(), start) else { continue };
        let created = program.task_creations().find(|task| program.body.string(task.name).as_ref() == Some(name));
        if let Some(task) = created {
            found
                .report(&RULE, program.range(task.name), word(name, other))
                .related_at(creation_in(program, other, name), "the first one");
        }
    }
}

fn creation_in(program: &ProgramView<'_>, other: &str, name: &SmolStr) -> Option<FileRange> {
    let other = program.other(other)?;
    let task = other.task_creations().find(|task| other.body.string(task.name).as_ref() == Some(name))?;
    Some(other.span(task.name))
}

fn word(name: &str, other: &str) -> Wording {
    Wording::new(
        format!("`{other}` creates a task `{name}` as well, and that one never ends"),
        "run-time error 31",
        "use a different name for each task, or end the first one with `taskKill` before this line",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    /// Program `start` creates "io" and calls `two`, which has `code`; `loop` and `other` are endless, `once` is not.
    fn two(start: &str, code: &str) -> String {
        let endless = "begin\n  while true\n    delay(1)\n  endWhile\nend";
        check(
            &RULE,
            &format!(
                "bool bA\nstring sA\nprogram start()\nbegin\n{start}\nend\nprogram stop()\nbegin\n  taskKill(\"io\")\nend\n\
                 program two()\nbegin\n{code}\nend\nprogram loop()\n{endless}\nprogram other()\n{endless}\n\
                 program once()\nbegin\n  delay(1)\nend"
            ),
        )
    }

    const START: &str = "taskCreate \"io\",10,loop()\ncall two()";

    #[test]
    fn a_second_task_of_a_name_is_reported() {
        expect![[r#"
            two.pgx:5 `"io"` `start` creates a task `io` as well, and that one never ends
              | run-time error 31
              ? use a different name for each task, or end the first one with `taskKill` before this line
              > start.pgx:5 `"io"` the first one
        "#]]
        .assert_eq(&two(START, "taskCreate \"io\",10,other()"));
        expect![[r#"
            two.pgx:6 `"io"` `start` creates a task `io` as well, and that one never ends
              | run-time error 31
              ? use a different name for each task, or end the first one with `taskKill` before this line
              > start.pgx:5 `"io"` the first one
        "#]]
        .assert_eq(&two(START, "if bA\n  taskCreate \"io\",20,loop()\nendIf"));
    }

    #[test]
    fn the_certain_creation_counts_as_the_first() {
        let start = "call two()\nif bA\n  taskCreate \"io\",10,loop()\nendIf";
        expect![[r#"
            start.pgx:7 `"io"` `two` creates a task `io` as well, and that one never ends
              | run-time error 31
              ? use a different name for each task, or end the first one with `taskKill` before this line
              > two.pgx:5 `"io"` the first one
        "#]]
        .assert_eq(&two(start, "taskCreate \"io\",10,other()"));
    }

    #[test]
    fn a_creation_by_a_task_is_reported() {
        let start = "taskCreate \"io\",10,loop()\ntaskCreate \"two\",10,two()";
        expect![[r#"
            two.pgx:5 `"io"` `start` creates a task `io` as well, and that one never ends
              | run-time error 31
              ? use a different name for each task, or end the first one with `taskKill` before this line
              > start.pgx:5 `"io"` the first one
        "#]]
        .assert_eq(&two(start, "taskCreate \"io\",10,other()"));
    }

    #[test]
    fn a_first_task_that_may_have_ended_is_not_reported() {
        assert_eq!(two(START, "taskKill(\"io\")\ntaskCreate \"io\",10,other()"), "");
        assert_eq!(two(START, "taskKill(sA)\ntaskCreate \"io\",10,other()"), "");
        assert_eq!(two(START, "if taskStatus(\"io\")==-1\ntaskCreate \"io\",10,other()\nendIf"), "");
        assert_eq!(two("taskCreate \"io\",10,once()\ncall two()", "taskCreate \"io\",10,other()"), "");
        assert_eq!(two(START, "taskCreate \"io\",10,once()"), "");
    }

    #[test]
    fn exclusive_creations_are_not_reported() {
        let start = "if bA\n  taskCreate \"io\",10,loop()\nelse\n  call two()\nendIf";
        assert_eq!(two(start, "taskCreate \"io\",10,other()"), "");
    }

    #[test]
    fn programs_that_never_run_are_not_reported() {
        assert_eq!(two("taskCreate \"io\",10,loop()", "taskCreate \"io\",10,other()"), "");
    }

    #[test]
    fn different_names_are_not_reported() {
        assert_eq!(two(START, "taskCreate \"io2\",10,other()\ntaskCreate sA,10,other()"), "");
    }
}
