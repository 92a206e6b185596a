//! V0343: a task whose name is computed.

use val3_analysis::flow::PointKind;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A task is created under a name that is computed.
    ///
    /// ## Why
    /// A search for the name of the task does not find it in the code. The check cannot verify that the name is free,
    /// has a valid length, and is the one that `taskKill` uses. A computed name is usual where one program serves
    /// several tasks. The rule is off by default, because it enforces a convention that not every shop has.
    ///
    /// ## Bad
    /// ```val3
    /// string sTask = "robot"
    /// taskCreate sTask,10,cycle()
    ///
    /// program cycle()
    /// begin
    ///   waitEndMove()
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// taskCreate "robot",10,cycle()
    ///
    /// program cycle()
    /// begin
    ///   waitEndMove()
    /// end
    /// ```
    V0343 "computed-task-name" Info off, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for (_, point) in program.flow().points() {
        let PointKind::TaskCreate(arguments) = &point.kind else { continue };
        let Some(name) = arguments.first().filter(|name| program.body.string(**name).is_none()) else { continue };
        found.report(&RULE, program.range(*name), word());
    }
}

fn word() -> Wording {
    Wording::new("the name of this task is computed", "not a plain text", "write the name as a text")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn program(name: &str) -> String {
        check(
            &RULE,
            &format!("string sA\nprogram p()\nbegin\nend\nprogram start()\nbegin\ntaskCreate {name},10,p()\nend"),
        )
    }

    #[test]
    fn names_from_variables_and_sums_are_reported() {
        expect![[r#"
            start.pgx:5 `sA` the name of this task is computed
              | not a plain text
              ? write the name as a text
            start.pgx:5 `"a"+sA` the name of this task is computed
              | not a plain text
              ? write the name as a text
        "#]]
        .assert_eq(&(program("sA") + &program("\"a\"+sA")));
    }

    #[test]
    fn literal_names_are_not_reported() {
        assert_eq!(program("\"a\"") + &program("\"a\"+\"b\""), "");
    }
}
