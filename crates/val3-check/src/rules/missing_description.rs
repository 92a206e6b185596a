//! V0713: a program without a description.

use val3_analysis::items::declarations;
use val3_analysis::items::layout::comments;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A program does not begin with a comment that describes it.
    ///
    /// ## Why
    /// Such a comment is the first thing that a new reader of the cell needs. It must be before the first line of code.
    /// The rule is off by default, because it enforces a convention that not every shop has.
    ///
    /// ## Bad
    /// ```val3
    /// program start()
    /// begin
    ///   putln("ready")
    ///   // greets the operator
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// program start()
    /// begin
    ///   // Greets the operator
    ///   putln("ready")
    /// end
    /// ```
    V0713 "missing-description" Info off, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let first = program.body.block.first().map(|stmt| stmt.range.start());
    let says = |text: &str| text.chars().any(char::is_alphanumeric);
    let comments = comments(program.db, program.file);
    let mut at_head = comments.iter().filter(|range| first.is_none_or(|first| range.end() <= first));
    if !at_head.any(|range| says(program.slice(*range)))
        && let Some(place) = declarations::program(program.db, program.file)
    {
        found.report(&RULE, place.range, word(program.name()));
    }
}

fn word(name: &str) -> Wording {
    Wording::new(
        format!("the program `{name}` does not begin with a comment"),
        "not described",
        "describe the program in a comment before the first line",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn programs_without_a_comment_are_reported() {
        expect![[r#"
            p.pgx:3 `p` the program `p` does not begin with a comment
              | not described
              ? describe the program in a comment before the first line
        "#]]
        .assert_eq(&check(&RULE, "program p()\nbegin\n  // ------\n  cls()\n  // why\nend"));
    }

    #[test]
    fn programs_with_a_comment_are_not_reported() {
        assert_eq!(check(&RULE, "program p()\nbegin\n\n  // Clears\n  cls()\nend"), "");
        assert_eq!(check(&RULE, "program p()\nbegin\n  // nothing to do\nend"), "");
    }
}
