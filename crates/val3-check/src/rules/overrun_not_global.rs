//! V0321: an overrun variable that is not global.

use super::task_local_by_reference::ends_with_program;
use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// The variable that indicates the overrun of a synchronous task is not global.
    ///
    /// ## Why
    /// The system sets the variable during the whole life of the task. Only a global variable exists for that time, and
    /// `taskCreateSync` accepts no other (5.10).
    ///
    /// ## Bad
    /// ```val3
    /// program begins()
    ///   bool l_bLate
    /// begin
    ///   taskCreateSync "watch",0.02,l_bLate,watching()
    /// end
    ///
    /// program watching()
    /// begin
    ///   putln("watching")
    /// end
    ///
    /// call begins()
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// bool bLate
    ///
    /// taskCreateSync "watch",0.02,bLate,watching()
    ///
    /// program watching()
    /// begin
    ///   putln("watching")
    /// end
    /// ```
    V0321 "overrun-not-global" Error, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for overrun in program.task_creations().filter_map(|task| task.overrun) {
        if let Some(what) = ends_with_program(program, program.effects.root(overrun)) {
            found.report(&RULE, program.range(overrun), word(what, program.text(overrun)));
        }
    }
}

fn word(what: &str, variable: &str) -> Wording {
    Wording::new(
        format!("{what} `{variable}` cannot indicate the overrun of a task"),
        "ends with this program, before the task does",
        "use a global variable",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn local_variables_are_reported() {
        expect![[r#"
            p.pgx:11 `l_b` the local variable `l_b` cannot indicate the overrun of a task
              | ends with this program, before the task does
              ? use a global variable
            p.pgx:12 `x_b` the value parameter `x_b` cannot indicate the overrun of a task
              | ends with this program, before the task does
              ? use a global variable
        "#]]
        .assert_eq(&check(
            &RULE,
            "program p(bool x_b)\nbool l_b\nbegin\ntaskCreateSync \"a\",0.02,l_b,q()\n\
             taskCreateSync \"b\",0.02,x_b,q()\nend\nprogram q()\nbegin\nend",
        ));
    }

    #[test]
    fn global_variables_are_not_reported() {
        assert_eq!(
            check(
                &RULE,
                "bool b[2]\nprogram p(bool& x_b)\nbegin\ntaskCreateSync \"a\",0.02,b[1],q()\n\
                 taskCreateSync \"b\",0.02,x_b,q()\nend\nprogram q()\nbegin\nend"
            ),
            ""
        );
    }
}
