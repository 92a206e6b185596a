//! V0215: more values between braces than fields.

use crate::{
    built_in,
    diagnostic::Wording,
    english::{a, count},
    rule::rule,
};

rule! {
    /// There are more values between braces than the type has fields.
    ///
    /// ## Why
    /// The values between braces are assigned to the fields of the type, in order. An empty place means 0 (2.4.2). The
    /// controller does not load an application with a value after the last field. The fields of a point are in two
    /// inner pairs of braces: first the transformation, then the configuration.
    ///
    /// ## Bad
    /// ```val3
    /// trsf trAbove
    ///
    /// trAbove={0,0,100,0,0,0,0}
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// trsf trAbove
    ///
    /// trAbove={0,0,100,0,0,0}
    /// ```
    V0215 "literal-field-count" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(ty: &str, expected: usize, found: usize) -> Wording {
    let (fields, values) = (count(expected, "field"), count(found, "value"));
    let help = built_in::layout(ty).map(|layout| format!("the fields are `{layout}`"));
    Wording::new(
        format!("{} has {fields}, but {values} are between the braces", a(ty)),
        format!("{} too many", count(found.saturating_sub(expected), "value")),
        help.unwrap_or_default(),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            a `trsf` has 6 fields, but 7 values are between the braces
            | 1 value too many
            ? the fields are `{x,y,z,rx,ry,rz}`
        "#]]
        .assert_eq(&word("trsf", 6, 7).to_string());
        expect![[r#"
            a `pointRx` has 2 fields, but 6 values are between the braces
            | 4 values too many
            ? the fields are `{{x,y,z,rx,ry,rz},{shoulder,elbow,wrist}}`
        "#]]
        .assert_eq(&word("pointRx", 2, 6).to_string());
    }
}
