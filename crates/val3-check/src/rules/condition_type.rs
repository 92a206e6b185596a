//! V0207: a condition that is not a `bool`.

use crate::{conversion, diagnostic::Wording, english::a, rule::rule};

rule! {
    /// The condition of `if`, `elseIf`, `while` or `until` is not a `bool`.
    ///
    /// ## Why
    /// A condition must be true or false (2.2.5). Unlike other languages, VAL 3 does not accept a number as a
    /// condition: compare the number or text with a value. The controller does not load an application with a condition
    /// of another type.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    ///
    /// if nCount
    ///   putln("parts left")
    /// endIf
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    ///
    /// if nCount>0
    ///   putln("parts left")
    /// endIf
    /// ```
    V0207 "condition-type" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(keyword: &str, found: &str) -> Wording {
    let mut advice = conversion::advice(found, "bool");
    if advice.is_empty() {
        "compare it with something: `…==…`".clone_into(&mut advice);
    }
    Wording::new(
        format!("`{keyword}` needs a `bool` as its condition, not {}", a(found)),
        format!("this is {}", a(found)),
        advice,
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            `if` needs a `bool` as its condition, not a `num`
            | this is a `num`
            ? a comparison such as `…!=0` converts a number to a `bool`
        "#]]
        .assert_eq(&word("if", "num").to_string());
        expect![[r#"
            `while` needs a `bool` as its condition, not a `string`
            | this is a `string`
            ? compare it with something: `…==…`
        "#]]
        .assert_eq(&word("while", "string").to_string());
    }
}
