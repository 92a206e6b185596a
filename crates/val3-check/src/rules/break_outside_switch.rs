//! V0017: `break` outside a `switch` branch.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// `break` is used outside a `case` or `default` branch.
    ///
    /// ## Why
    /// `break` closes a branch of `switch` and does nothing else. It does not leave a loop, as it does in other
    /// languages. A loop ends by its condition; `return` ends the whole program.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    /// bool bFull
    ///
    /// while nCount<10
    ///   nCount=nCount+1
    ///   if bFull
    ///     break
    ///   endIf
    /// endWhile
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    /// bool bFull
    ///
    /// while nCount<10 and !bFull
    ///   nCount=nCount+1
    /// endWhile
    /// ```
    V0017 "break-outside-switch" Error
}

/// Returns the wording of the finding.
pub(crate) fn word() -> Wording {
    Wording::new(
        "`break` closes a branch of `switch`, and no branch is open",
        "not inside `case` or `default`",
        "to leave a loop early, add to its condition; to leave the program, write `return`",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_help_explains_how_to_leave_a_loop() {
        expect![[r#"
            `break` closes a branch of `switch`, and no branch is open
            | not inside `case` or `default`
            ? to leave a loop early, add to its condition; to leave the program, write `return`
        "#]]
        .assert_eq(&word().to_string());
    }
}
