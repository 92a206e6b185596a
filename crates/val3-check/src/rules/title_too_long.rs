//! V0248: a title that is longer than the user page.

use val3_lang::instructions::TITLE;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A constant title has more characters than the user page has columns.
    ///
    /// ## Why
    /// The user page of s5 to s7 has 40 columns (4.1), and the title is a single line: the end is not shown. `put` and
    /// `putln` continue in the next line and are not reported.
    ///
    /// ## Bad
    /// ```val3
    /// title("Palletising of the second layer of the left tray")
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// title("Left tray: second layer")
    /// ```
    V0248 "title-too-long" Info, Program: check
}

/// Number of columns on the user page.
const COLUMNS: usize = 40;

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    if program.items.version.language() >= 8 {
        return;
    }
    for call in program.calls_of(TITLE) {
        let Some(text) = call.args.last() else { continue };
        let count = program.body.string(*text).map_or(0, |text| text.chars().count());
        if count > COLUMNS {
            found.report(&RULE, program.range(*text), word(count));
        }
    }
}

fn word(count: usize) -> Wording {
    Wording::new(
        format!("the title has {count} characters, but the user page has {COLUMNS} columns"),
        "the end is not shown",
        "shorten the title",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn titles_beyond_the_page_are_reported() {
        let long = "x".repeat(41);
        expect![[r#"
            start.pgx:5 `"xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx"` the title has 41 characters, but the user page has 40 columns
              | the end is not shown
              ? shorten the title
        "#]].assert_eq(&check(&RULE, &format!("title(\"{long}\")")));
    }

    #[test]
    fn shorter_and_computed_titles_are_not_reported() {
        let (full, long) = ("x".repeat(40), "x".repeat(41));
        assert_eq!(check(&RULE, &format!("string sA\ntitle(\"{full}\")\ntitle(\"{long}\"+sA)\nput(\"{long}\")")), "");
        assert_eq!(check(&RULE, &format!("version s8.10\ntitle(\"{long}\")")), "");
    }
}
