//! V0202: an assignment of a value with the wrong type.

use crate::{conversion, diagnostic::Wording, english::a, rule::rule};

rule! {
    /// A value is assigned to a variable that has another type.
    ///
    /// ## Why
    /// `=` requires a value of the variable's type. The exceptions are inputs and outputs: a `bool` is written to a
    /// `dio` and read from it, and a `string` or `num` is sent to a `sio` and received from it. Since s7 a `dio` is no
    /// longer assigned to another `dio` (3.5.2). The controller does not load an application with any other assignment.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    /// string sText
    ///
    /// sText=nCount
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    /// string sText
    ///
    /// sText=toString("",nCount)
    /// ```
    V0202 "assignment-type" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(target: &str, value: &str) -> Wording {
    Wording::new(
        format!("{} cannot be assigned to {}", a(value), a(target)),
        format!("this is {}", a(value)),
        conversion::advice(value, target),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            a `num` cannot be assigned to a `string`
            | this is a `num`
            ? `toString("", …)` turns a number into text
        "#]]
        .assert_eq(&word("string", "num").to_string());
        expect![[r#"
            a `dio` cannot be assigned to a `dio`
            | this is a `dio`
            ? a `dio` takes a `bool`: compare the input, `(…==true)`
        "#]]
        .assert_eq(&word("dio", "dio").to_string());
        expect![[r#"
            a `trsf` cannot be assigned to a `pointRx`
            | this is a `trsf`
            ? assign it to the field `.trsf` of a point; `compose(…)` returns a point with it
        "#]]
        .assert_eq(&word("pointRx", "trsf").to_string());
        expect![[r#"
            an `aio` cannot be assigned to a `Slot`
            | this is an `aio`
        "#]]
        .assert_eq(&word("Slot", "aio").to_string());
    }
}
