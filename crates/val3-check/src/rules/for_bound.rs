//! V0219: a bound or step of `for` that is not a `num`.

use crate::{conversion, diagnostic::Wording, english::a, rule::rule};

rule! {
    /// The first value, the last value or the step of `for` is not a `num`.
    ///
    /// ## Why
    /// The counter of `for` is a number, and its bounds and its step must be numbers as well. The controller does not
    /// load an application with a value of another type.
    ///
    /// ## Bad
    /// ```val3
    /// num nPart
    /// string sLast
    ///
    /// for nPart=1 to sLast
    ///   putln(nPart)
    /// endFor
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nPart
    /// num nLast
    ///
    /// for nPart=1 to nLast
    ///   putln(nPart)
    /// endFor
    /// ```
    V0219 "for-bound" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(keyword: &str, found: &str) -> Wording {
    let bound = match keyword {
        "to" => "last value",
        "step" => "step",
        _ => "first value",
    };
    Wording::new(
        format!("the {bound} of `for` is a `num`, not {}", a(found)),
        format!("this is {}", a(found)),
        conversion::advice(found, "num"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            the first value of `for` is a `num`, not a `bool`
            | this is a `bool`
            ? `sel(…, 1, 0)` converts a `bool` to a number
        "#]]
        .assert_eq(&word("=", "bool").to_string());
        expect![[r#"
            the last value of `for` is a `num`, not a `string`
            | this is a `string`
            ? `toNum(…)` reads a number from a text
        "#]]
        .assert_eq(&word("to", "string").to_string());
        expect![[r#"
            the step of `for` is a `num`, not a `point`
            | this is a `point`
        "#]]
        .assert_eq(&word("step", "point").to_string());
    }
}
