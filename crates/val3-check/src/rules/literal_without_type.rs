//! V0217: braces where no structure is expected.

use crate::{diagnostic::Wording, english::a, rule::rule};

rule! {
    /// Values between braces are used where no structured type is expected.
    ///
    /// ## Why
    /// Values between braces have no type by themselves. Their type follows from the context: the variable on the left
    /// of `=`, the other side of a comparison, or the parameter of a program. Values of simple types such as `num` are
    /// written without braces, and an array is filled element by element. The controller does not load an application
    /// with braces anywhere else.
    ///
    /// ## Bad
    /// ```val3
    /// num nSize[3]
    ///
    /// nSize={10,20,30}
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nSize[3]
    ///
    /// nSize[0]=10
    /// nSize[1]=20
    /// nSize[2]=30
    /// ```
    V0217 "literal-without-type" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(expected: Option<&str>) -> Wording {
    match expected {
        Some(expected) => Wording::new(
            format!("{} is needed here, not values between braces", a(expected)),
            "braces make a structured value",
            "an array is filled element by element; a simple value is written without braces",
        ),
        None => Wording::new(
            "the type of the values between these braces is unknown",
            "no type",
            "assign them to a variable of the type first, and use the variable",
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
            a `num` is needed here, not values between braces
            | braces make a structured value
            ? an array is filled element by element; a simple value is written without braces
        "#]]
        .assert_eq(&word(Some("num")).to_string());
        expect![[r#"
            the type of the values between these braces is unknown
            | no type
            ? assign them to a variable of the type first, and use the variable
        "#]]
        .assert_eq(&word(None).to_string());
    }
}
