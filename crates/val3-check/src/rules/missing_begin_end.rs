//! V0028: code without `begin` or `end`.

use crate::{
    diagnostic::{Fix, Wording},
    fix::Site,
    rule::rule,
};

rule! {
    /// The code of a program does not start with `begin` or does not end with `end`.
    ///
    /// ## Why
    /// The code of every program is enclosed by a line `begin` and a line `end`, even if it is empty. They mark the
    /// program as complete; a file that was cut off has no `end`. The controller does not load an application with such
    /// a program.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    ///
    /// program count()
    /// begin
    ///   nCount=nCount+1
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    ///
    /// program count()
    /// begin
    ///   nCount=nCount+1
    /// end
    /// ```
    V0028 "missing-begin-end" Error
}

/// Returns the wording for code without `begin`.
pub(crate) fn no_begin() -> Wording {
    Wording::new("the code of the program does not start with `begin`", "`begin` belongs here", "")
}

/// Returns the wording for code without `end`.
pub(crate) fn no_end() -> Wording {
    Wording::new(
        "the code of the program does not finish with `end`",
        "`end` belongs here",
        "if lines are missing too, the file was cut off: take it from a backup",
    )
}

/// Returns the wording for code without `begin` and `end`.
pub(crate) fn neither() -> Wording {
    Wording::new(
        "the code of the program has neither `begin` nor `end`",
        "`begin` belongs here",
        "the code of every program is enclosed by a line `begin` and a line `end`",
    )
}

/// Returns the wording for a program without code.
pub(crate) fn no_code() -> Wording {
    Wording::new(
        "the program has no code",
        "no `begin` and no `end`",
        "a program that does nothing is written `begin` and `end` on two lines",
    )
}

/// Writes the missing keyword on a separate line. Missing lines of code cannot be restored, so the fix is a guess.
pub(crate) fn fix(site: &Site<'_>, keyword: &str) -> Option<Fix> {
    let edit = site.insert_line(keyword)?;
    Some(Fix::guess(format!("write `{keyword}`"), vec![edit]))
}

/// Writes both keywords.
pub(crate) fn fix_both(site: &Site<'_>) -> Option<Fix> {
    let edits = vec![site.insert_line("begin")?, site.other_side()?.insert_line("end")?];
    Some(Fix::guess("write `begin` and `end`", edits))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn code_without_begin_is_reported() {
        expect![[r#"
            the code of the program does not start with `begin`
            | `begin` belongs here
        "#]]
        .assert_eq(&no_begin().to_string());
    }

    #[test]
    fn code_without_end_is_reported() {
        expect![[r#"
            the code of the program does not finish with `end`
            | `end` belongs here
            ? if lines are missing too, the file was cut off: take it from a backup
        "#]]
        .assert_eq(&no_end().to_string());
    }

    #[test]
    fn code_without_begin_and_end_is_reported() {
        expect![[r#"
            the code of the program has neither `begin` nor `end`
            | `begin` belongs here
            ? the code of every program is enclosed by a line `begin` and a line `end`
        "#]]
        .assert_eq(&neither().to_string());
    }

    #[test]
    fn a_program_without_code_is_reported() {
        expect![[r#"
            the program has no code
            | no `begin` and no `end`
            ? a program that does nothing is written `begin` and `end` on two lines
        "#]]
        .assert_eq(&no_code().to_string());
    }
}
