//! V0027: `return` with a value.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// `return` is followed by a value.
    ///
    /// ## Why
    /// A program returns no value. It is started with `call` on a line of its own and cannot be part of an expression.
    /// `return` only ends it. A program returns a result through a parameter by reference, marked with `&` in its
    /// interface.
    ///
    /// ## Bad
    /// ```val3
    /// public program area(num x_nWidth, num x_nHeight)
    /// begin
    ///   return x_nWidth*x_nHeight
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// public program area(num x_nWidth, num x_nHeight, num& x_nArea)
    /// begin
    ///   x_nArea=x_nWidth*x_nHeight
    /// end
    /// ```
    V0027 "return-value" Error
}

/// Returns the wording of the finding.
pub(crate) fn word() -> Wording {
    Wording::new(
        "a program returns no value",
        "nothing can follow `return`",
        "return the result through a parameter by reference, such as `num& x_nResult`",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_value_after_return_is_reported() {
        expect![[r#"
            a program returns no value
            | nothing can follow `return`
            ? return the result through a parameter by reference, such as `num& x_nResult`
        "#]]
        .assert_eq(&word().to_string());
    }
}
