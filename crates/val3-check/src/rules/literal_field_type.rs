//! V0216: a value between braces that has another type than its field.

use crate::{conversion, diagnostic::Wording, english::a, rule::rule};

rule! {
    /// A value between braces has another type than the field that it goes to.
    ///
    /// ## Why
    /// The values between braces go to the fields of the type, in the order of the fields, and each must have the type
    /// of its field. Words such as `joint`, `Cartesian`, `lefty` or `wfree` are written without quotes: they are values
    /// of the language, not text. The controller does not load an application where a value does not fit.
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

/// Words the finding.
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
    fn wording() {
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
