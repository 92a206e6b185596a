//! V0343: a task whose name the code does not spell out.

use val3_analysis::flow::PointKind;

use crate::diagnostic::Wording;
use crate::lint::{Findings, Program};
use crate::rule::rule;

rule! {
    /// A task is created under a name that is computed.
    ///
    /// ## Why
    /// Who looks for a task by its name does not find it in the code, and no check can tell whether the name is free,
    /// of the right length, and the one that `taskKill` uses. Where one program serves several tasks, a computed name
    /// is the plain way: this is a convention of some shops, and off unless it is asked for.
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

fn check(program: &Program<'_>, found: &mut Findings) {
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
    fn variables_and_sums() {
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
    fn texts() {
        assert_eq!(program("\"a\"") + &program("\"a\"+\"b\""), "");
    }
}
