//! V0715: a program without a line of code.

use val3_analysis::application::ENTRY_POINTS;
use val3_analysis::items::declarations;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A program has no line of code.
    ///
    /// ## Why
    /// A call of it does nothing. Its code is missing or was commented out. `start` and `stop` may be empty, and so may
    /// public programs that an interface requires. The rule is off by default, because it enforces a convention that
    /// not every shop has.
    ///
    /// ## Bad
    /// ```val3
    /// call greet()
    ///
    /// program greet()
    /// begin
    ///   // putln("ready")
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// call greet()
    ///
    /// program greet()
    /// begin
    ///   putln("ready")
    /// end
    /// ```
    V0715 "empty-program" Info off, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let may_be_empty = program.header.public || ENTRY_POINTS.contains(&program.name());
    if program.body.block.is_empty()
        && !may_be_empty
        && let Some(place) = declarations::program(program.db, program.file)
    {
        found.report(&RULE, place.range, word(program.name()));
    }
}

fn word(name: &str) -> Wording {
    Wording::new(
        format!("the program `{name}` has no line of code"),
        "does nothing",
        "write its code, or remove the program and its calls",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn programs_of_comments_alone_are_reported() {
        expect![[r#"
            p.pgx:3 `p` the program `p` has no line of code
              | does nothing
              ? write its code, or remove the program and its calls
        "#]]
        .assert_eq(&check(&RULE, "program p()\nbegin\n  // later\nend"));
    }

    #[test]
    fn programs_with_code_entry_points_and_interfaces_are_not_reported() {
        assert_eq!(check(&RULE, "program p()\nbegin\n  return\nend\nprogram stop()\nbegin\nend"), "");
        assert_eq!(check(&RULE, "public program p()\nbegin\nend"), "");
    }
}
