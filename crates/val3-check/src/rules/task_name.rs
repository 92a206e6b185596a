//! V0325: an invalid task name.

use val3_lang::runtime_errors::BAD_TASK_NAME;
use val3_lang::tasks::{NameFault, name_fault};

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::phrase::runtime_error;
use crate::rule::rule;

rule! {
    /// The name of a task is empty, too long or has characters that are not allowed.
    ///
    /// ## Why
    /// The name of a task has 1 to 15 letters, digits and underscores (5.10). Only s8 accepts longer names. With any
    /// other name the line raises run-time error 29, and the task is not created.
    ///
    /// ## Bad
    /// ```val3
    /// taskCreate "watch door",10,watching()
    ///
    /// program watching()
    /// begin
    ///   putln("watching")
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// taskCreate "watchDoor",10,watching()
    ///
    /// program watching()
    /// begin
    ///   putln("watching")
    /// end
    /// ```
    V0325 "task-name" Error, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for task in program.task_creations() {
        let Some(name) = program.body.string(task.name) else { continue };
        if let Some(fault) = name_fault(&name, program.items.version) {
            found.report(&RULE, program.range(task.name), word(&name, fault));
        }
    }
}

fn word(name: &str, fault: NameFault) -> Wording {
    let message = match fault {
        NameFault::Empty => "a task needs a name".to_owned(),
        NameFault::Long(limit) => {
            format!("the name `{name}` of a task has {} characters, more than {limit}", name.chars().count())
        }
        NameFault::Character(character) => format!("the name `{name}` of a task cannot have a `{character}`"),
    };
    let help = if let NameFault::Character(_) = fault { "use letters, digits and `_`" } else { "" };
    Wording::new(message, runtime_error(BAD_TASK_NAME), help)
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn invalid_task_names_are_reported() {
        expect![[r#"
            start.pgx:5 `""` a task needs a name
              | run-time error 29: bad task name
            start.pgx:6 `"conveyorWatching"` the name `conveyorWatching` of a task has 16 characters, more than 15
              | run-time error 29: bad task name
            start.pgx:7 `"a-b"` the name `a-b` of a task cannot have a `-`
              | run-time error 29: bad task name
              ? use letters, digits and `_`
        "#]].assert_eq(&check(
            &RULE,
            "bool b\ntaskCreate \"\",10,q()\ntaskCreate \"conveyorWatching\",10,q()\ntaskCreateSync \"a-b\",0.02,b,q()\n\
             program q()\nbegin\nend",
        ));
    }

    #[test]
    fn valid_task_names_are_not_reported() {
        assert_eq!(
            check(
                &RULE,
                "version s8.10\nstring s\ntaskCreate \"conveyorWatching\",10,q()\ntaskCreate \"conveyorWatcher\",10,q()\ntaskCreate s+\" \",10,q()\nprogram q()\nbegin\nend"
            ),
            ""
        );
    }
}
