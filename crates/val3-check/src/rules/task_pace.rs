//! V0322: an invalid priority or period of a task.

use val3_lang::runtime_errors::INVALID_PARAMETER;
use val3_lang::tasks;

use crate::diagnostic::Wording;
use crate::lint::ranges::RangeInWords;
use crate::lint::{Findings, ProgramView};
use crate::phrase::runtime_error;
use crate::rule::rule;

rule! {
    /// A task is created with an invalid constant priority or period.
    ///
    /// ## Why
    /// A priority is a number from 1 to 100: the number of lines that the task runs in its turn. A period is a positive
    /// number of seconds (5.10). Any other value raises run-time error 70, and the task is not created.
    ///
    /// ## Bad
    /// ```val3
    /// taskCreate "watch",0,watching()
    ///
    /// program watching()
    /// begin
    ///   putln("watching")
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// taskCreate "watch",1,watching()
    ///
    /// program watching()
    /// begin
    ///   putln("watching")
    /// end
    /// ```
    V0322 "task-pace" Error, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for task in program.task_creations() {
        let (noun, range) = match task.is_synchronous() {
            true => ("period", tasks::period()),
            false => ("priority", tasks::priority()),
        };
        let (Some(range), Some(value)) = (range, program.body.number(task.pace)) else { continue };
        if !range.takes(value) {
            let wording = Wording::new(
                format!("the {noun} of a task is {}, not {value}", RangeInWords(range)),
                runtime_error(INVALID_PARAMETER),
                "",
            );
            found.report(&RULE, program.range(task.pace), wording);
        }
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn impossible_priorities_and_periods_are_reported() {
        expect![[r#"
            start.pgx:5 `0` the priority of a task is 1 to 100, not 0
              | run-time error 70: invalid parameter
            start.pgx:6 `101` the priority of a task is 1 to 100, not 101
              | run-time error 70: invalid parameter
            start.pgx:7 `0` the period of a task is more than 0, not 0
              | run-time error 70: invalid parameter
            start.pgx:8 `-0.02` the period of a task is more than 0, not -0.02
              | run-time error 70: invalid parameter
        "#]]
        .assert_eq(&check(
            &RULE,
            "bool b\ntaskCreate \"a\",0,q()\ntaskCreate \"b\",101,q()\ntaskCreateSync \"c\",0,b,q()\n\
             taskCreateSync \"d\",-0.02,b,q()\nprogram q()\nbegin\nend",
        ));
    }

    #[test]
    fn possible_priorities_and_periods_are_not_reported() {
        assert_eq!(
            check(
                &RULE,
                "num n\nbool b\ntaskCreate \"a\",1,q()\ntaskCreate \"b\",100,q()\ntaskCreate \"c\",n,q()\n\
                 taskCreateSync \"d\",0.004,b,q()\nprogram q()\nbegin\nend"
            ),
            ""
        );
    }
}
