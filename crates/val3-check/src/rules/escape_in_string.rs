//! V0249: an escape sequence of other languages in a string.

use val3_analysis::body::Expr;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A string ends with `\n`, or contains `\r\n`.
    ///
    /// ## Why
    /// VAL 3 strings have no escape sequences: the backslash and the letter are shown and sent as they are. `chr(10)` is
    /// the line feed, `chr(13)` the carriage return, and `putln` begins a new line.
    ///
    /// ## Bad
    /// ```val3
    /// put("ready\n")
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// putln("ready")
    /// ```
    V0249 "escape-in-string" Info, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for (_, expr, range) in program.body.exprs() {
        let Expr::String(text) = expr else { continue };
        // A path such as `BasicIO-1\nOut` has a letter after the `n`.
        if text.ends_with("\\n") || text.contains("\\r\\n") {
            found.report(&RULE, range, word());
        }
    }
}

fn word() -> Wording {
    Wording::new(
        "strings have no escape sequences: `\\n` stays a backslash and an `n`",
        "two characters",
        "use `putln(…)`, or add `chr(10)` for a line feed and `chr(13)` for a carriage return",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn line_ends_of_other_languages_are_reported() {
        expect![[r#"
            start.pgx:5 `"a\n"` strings have no escape sequences: `\n` stays a backslash and an `n`
              | two characters
              ? use `putln(…)`, or add `chr(10)` for a line feed and `chr(13)` for a carriage return
            start.pgx:6 `"\r\nb"` strings have no escape sequences: `\n` stays a backslash and an `n`
              | two characters
              ? use `putln(…)`, or add `chr(10)` for a line feed and `chr(13)` for a carriage return
        "#]]
        .assert_eq(&check(&RULE, "put(\"a\\n\")\nput(\"\\r\\nb\")"));
    }

    #[test]
    fn backslashes_in_paths_are_not_reported() {
        assert_eq!(check(&RULE, "put(\"BasicIO-1\\nOut\")\nput(\"n\")\nput(\"C:\\new\")"), "");
    }
}
