//! V0024: a comment behind code.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A comment stands behind code on the same line.
    ///
    /// ## Why
    /// `//` must be the first thing on its line. VAL 3 has no comments behind an instruction, and the
    /// controller refuses the program.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    ///
    /// nCount=0 // reset
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    ///
    /// // reset
    /// nCount=0
    /// ```
    V0024 "comment-after-code" Error
}

/// Words the finding.
pub(crate) fn word() -> Wording {
    Wording::new(
        "a comment cannot follow code on the same line",
        "`//` must be first on its line",
        "move the comment to a line of its own",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_comment_behind_code() {
        expect![[r#"
            a comment cannot follow code on the same line
            | `//` must be first on its line
            ? move the comment to a line of its own
        "#]]
        .assert_eq(&word().to_string());
    }
}
