//! V0703: a comment that cannot silence anything.

use crate::{diagnostic::Wording, phrase::did_you_mean_or, rule::rule};

rule! {
    /// A comment that starts with `val3:` cannot silence anything: its form, its place or a code in it is wrong.
    ///
    /// ## Why
    /// The comment was written to silence a finding but has no effect. There are two forms. `//val3: allow(V0701)`
    /// applies to the next line of code. `//val3: allow-program(V0701)` applies to the whole program and must be before
    /// the first line of code. The brackets contain codes or names of findings, separated by commas. Faults of the
    /// syntax (`V00…`) cannot be silenced, because the controller rejects the program in any case. A third form,
    /// `//val3: no-coverage`, silences nothing: it excludes code from the coverage of `val3 test`.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    ///
    /// //val3: allow(keyword-speling)
    /// nCount=0
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    ///
    /// //val3: allow(keyword-spelling)
    /// IF nCount>9
    ///   nCount=0
    /// endIf
    /// ```
    V0703 "unknown-suppression" Warning
}

/// Returns the wording for a comment without a known form.
pub(crate) fn form() -> Wording {
    Wording::new(
        "a comment with `val3:` needs `allow(…)`, `allow-program(…)` or `no-coverage`",
        "this silences nothing",
        "write `//val3: allow(V0701)` for the next line of code, `//val3: allow-program(V0701)` for the program, \
         `//val3: no-coverage` for reports of coverage",
    )
}

/// Returns the wording for `allow-program` after code.
pub(crate) fn misplaced() -> Wording {
    Wording::new(
        "`allow-program` is after the first line of code",
        "this silences nothing",
        "move it before the first line of code, or write `allow` for the next line",
    )
}

/// Returns the wording for an unknown rule. `near` is the rule that was probably intended.
pub(crate) fn rule(word: &str, near: Option<&str>) -> Wording {
    let help = did_you_mean_or(near, "`val3 explain` lists all codes and names");
    Wording::new(format!("no rule has the code or name `{word}`"), "this silences nothing", help)
}

/// Returns the wording for a rule that comments cannot silence.
pub(crate) fn never_silenced(word: &str) -> Wording {
    Wording::new(
        format!("`{word}` cannot be silenced by a comment"),
        "this silences nothing",
        "correct the fault that it reports",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn wrong_forms_and_places_are_reported() {
        expect![[r#"
            a comment with `val3:` needs `allow(…)`, `allow-program(…)` or `no-coverage`
            | this silences nothing
            ? write `//val3: allow(V0701)` for the next line of code, `//val3: allow-program(V0701)` for the program, `//val3: no-coverage` for reports of coverage
        "#]]
        .assert_eq(&form().to_string());
        expect![[r#"
            `allow-program` is after the first line of code
            | this silences nothing
            ? move it before the first line of code, or write `allow` for the next line
        "#]]
        .assert_eq(&misplaced().to_string());
    }

    #[test]
    fn unknown_codes_are_reported() {
        expect![[r#"
            no rule has the code or name `V071`
            | this silences nothing
            ? did you mean `V0701`?
        "#]]
        .assert_eq(&rule("V071", Some("V0701")).to_string());
        expect![[r#"
            no rule has the code or name `sql`
            | this silences nothing
            ? `val3 explain` lists all codes and names
        "#]]
        .assert_eq(&rule("sql", None).to_string());
        expect![[r#"
            `V0010` cannot be silenced by a comment
            | this silences nothing
            ? correct the fault that it reports
        "#]]
        .assert_eq(&never_silenced("V0010").to_string());
    }
}
