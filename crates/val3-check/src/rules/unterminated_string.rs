//! V0013: a string without a closing quote.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A string has no closing quote on its line.
    ///
    /// ## Why
    /// A string is enclosed by two `"` on one line. There are no escape sequences: `\` is an ordinary character, and
    /// the next `"` always ends the string. Use `chr(34)` for a quote inside a string. The controller rejects a program
    /// with an open string.
    ///
    /// ## Bad
    /// ```val3
    /// string sText
    ///
    /// sText="waiting for part
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// string sText
    ///
    /// sText="waiting for part"
    /// ```
    V0013 "unterminated-string" Error
}

/// Returns the wording of the finding.
pub(crate) fn word() -> Wording {
    Wording::new(
        "the string has no closing quote",
        "`\"` is missing at the end of the string",
        "a string ends on its line; a quote inside it is written `\"…\"+chr(34)+\"…\"`",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_string_without_end_is_reported() {
        expect![[r#"
            the string has no closing quote
            | `"` is missing at the end of the string
            ? a string ends on its line; a quote inside it is written `"…"+chr(34)+"…"`
        "#]]
        .assert_eq(&word().to_string());
    }
}
