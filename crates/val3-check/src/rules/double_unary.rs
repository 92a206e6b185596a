//! V0022: two unary operators in a row.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// Two unary operators follow each other.
    ///
    /// ## Why
    /// `-` and `!` before a value cannot follow each other directly, as in `--nA` or `!!bA`. The controller rejects the
    /// line. After a binary operator one sign is allowed: `nA*-1`. If both signs are meant, separate them with
    /// brackets.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    ///
    /// nCount=- -nCount
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    ///
    /// nCount=-nCount
    /// ```
    V0022 "double-unary" Error
}

/// Returns the wording of the finding.
pub(crate) fn word() -> Wording {
    Wording::new(
        "two unary operators follow each other",
        "two signs",
        "remove one, or put the inner part in brackets: `-(-nA)`",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn two_signs_are_reported() {
        expect![[r#"
            two unary operators follow each other
            | two signs
            ? remove one, or put the inner part in brackets: `-(-nA)`
        "#]]
        .assert_eq(&word().to_string());
    }
}
