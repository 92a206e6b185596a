//! V0213: a case of another type than its switch.

use crate::{diagnostic::Wording, english::a, rule::rule};

rule! {
    /// The value of a `case` has another type than the `switch`.
    ///
    /// ## Why
    /// `switch` compares its value with the value of each `case`, as `==` does (2.2.5). Both must have the same type.
    /// Otherwise the branch could never be taken, and the controller does not load the application.
    ///
    /// ## Bad
    /// ```val3
    /// num nMode
    ///
    /// switch nMode
    ///   case "stop"
    ///     putln("stopped")
    ///   break
    /// endSwitch
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nMode
    ///
    /// switch nMode
    ///   case 0
    ///     putln("stopped")
    ///   break
    /// endSwitch
    /// ```
    V0213 "case-type" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(expected: &str, found: &str) -> Wording {
    Wording::new(
        format!("this `case` is {}, but its `switch` is {}", a(found), a(expected)),
        format!("this is {}", a(found)),
        "",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            this `case` is a `num`, but its `switch` is a `bool`
            | this is a `num`
        "#]]
        .assert_eq(&word("bool", "num").to_string());
        expect![[r#"
            this `case` is a `point`, but its `switch` is a `num`
            | this is a `point`
        "#]]
        .assert_eq(&word("num", "point").to_string());
    }
}
