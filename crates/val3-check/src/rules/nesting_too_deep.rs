//! V0006: more levels than a reader or the controller can follow.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// Brackets, blocks or XML elements nest deeper than can be read.
    ///
    /// ## Why
    /// The controller's compiler counts the levels of an expression and refuses a line that has too
    /// many. This check follows 200 levels, far more than people write; a file that reaches them is
    /// damaged, or a generator wrote it wrongly. What lies deeper is not checked.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    ///
    /// nCount=(((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((1)))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    ///
    /// nCount=1
    /// ```
    V0006 "nesting-too-deep" Error
}

/// Words the finding.
pub(crate) fn word() -> Wording {
    Wording::new(
        "brackets, blocks or elements nest too deeply",
        "one level too many",
        "compute parts of the expression on lines of their own, or move inner blocks into a program",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_level_too_many() {
        expect![[r#"
            brackets, blocks or elements nest too deeply
            | one level too many
            ? compute parts of the expression on lines of their own, or move inner blocks into a program
        "#]]
        .assert_eq(&word().to_string());
    }
}
