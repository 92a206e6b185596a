//! V0216: a value between braces that has another type than its field.

use crate::{conversion, diagnostic::Wording, english::a, rule::rule};

rule! {
    /// The type of a value between braces differs from the type of its field.
    ///
    /// ## Why
    /// The values between braces are assigned to the fields of the type, in order, and each must have the type of its
    /// field. Words such as `joint`, `Cartesian`, `lefty` or `wfree` are values of the language and are written without
    /// quotes. The controller does not load an application with a value of another type.
    ///
    /// ## Bad
    /// ```val3
    /// mdesc mFast
    ///
    /// mFast={100,100,100,9999,9999,"joint",50,50}
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// mdesc mFast
    ///
    /// mFast={100,100,100,9999,9999,joint,50,50}
    /// ```
    V0216 "literal-field-type" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(ty: &str, field: &str, expected: &str, found: &str) -> Wording {
    Wording::new(
        format!("the field `{field}` of `{ty}` is {}, not {}", a(expected), a(found)),
        format!("this is {}", a(found)),
        conversion::advice(found, expected),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            the field `blend` of `mdesc` is a `blend`, not a `string`
            | this is a `string`
            ? write `joint`, `off` or `Cartesian`
        "#]]
        .assert_eq(&word("mdesc", "blend", "blend", "string").to_string());
        expect![[r#"
            the field `x` of `trsf` is a `num`, not a `point`
            | this is a `point`
        "#]]
        .assert_eq(&word("trsf", "x", "num", "point").to_string());
    }
}
