//! V0218: a counter of `for` that is not a `num` variable.

use crate::{diagnostic::Wording, english::a, rule::rule};

rule! {
    /// The counter of `for` is not a `num` variable.
    ///
    /// ## Why
    /// `for` assigns its first value to the counter, and adds the step to it after each turn (2.2.5). Only a variable
    /// of type `num` can count: a local variable, a parameter, data of the application, or an element or field of one.
    /// The controller does not load an application with another counter.
    ///
    /// ## Bad
    /// ```val3
    /// string sPart
    ///
    /// for sPart=1 to 3
    ///   putln("part")
    /// endFor
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nPart
    ///
    /// for nPart=1 to 3
    ///   putln("part")
    /// endFor
    /// ```
    V0218 "for-counter" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(found: &str) -> Wording {
    match found {
        "num" => Wording::new("the counter of `for` must be a variable", "a value, not a variable", String::new()),
        _ => Wording::new(
            format!("the counter of `for` must be a `num` variable, not {}", a(found)),
            format!("this is {}", a(found)),
            String::new(),
        ),
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            the counter of `for` must be a `num` variable, not a `string`
            | this is a `string`
        "#]]
        .assert_eq(&word("string").to_string());
        expect![[r#"
            the counter of `for` must be a variable
            | a value, not a variable
        "#]]
        .assert_eq(&word("num").to_string());
    }
}
