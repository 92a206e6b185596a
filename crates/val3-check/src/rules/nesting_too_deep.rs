//! V0006: nesting beyond the limit of the check or the controller.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// Brackets, blocks or XML elements are nested too deeply to be read.
    ///
    /// ## Why
    /// The controller's compiler limits the nesting of an expression and rejects a line with more levels. This check
    /// reads 200 levels, far more than people write. A file with more levels is damaged, or a generator wrote it
    /// wrongly. Deeper levels are not checked.
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

/// Returns the wording of the finding.
pub(crate) fn word() -> Wording {
    Wording::new(
        "brackets, blocks or elements are nested too deeply",
        "one level too many",
        "compute parts of the expression on lines of their own, or move inner blocks into a program",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_level_beyond_the_limit_is_reported() {
        expect![[r#"
            brackets, blocks or elements are nested too deeply
            | one level too many
            ? compute parts of the expression on lines of their own, or move inner blocks into a program
        "#]]
        .assert_eq(&word().to_string());
    }
}
