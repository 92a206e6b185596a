//! V0205: a value in place of a variable for a parameter by reference.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A parameter that is passed by reference gets a value instead of a variable.
    ///
    /// ## Why
    /// A parameter marked with `&` is linked to the variable of the caller, so that the program or instruction can
    /// change it (2.6.2). A constant or the result of an expression cannot be changed; an element of an array or
    /// collection and a field are variables. The controller does not load an application that passes a value there.
    ///
    /// ## Bad
    /// ```val3
    /// call double(10)
    ///
    /// program double(num& x_nValue)
    /// begin
    ///   x_nValue=2*x_nValue
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nSpeed
    ///
    /// nSpeed=10
    /// call double(nSpeed)
    ///
    /// program double(num& x_nValue)
    /// begin
    ///   x_nValue=2*x_nValue
    /// end
    /// ```
    V0205 "variable-expected" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(callee: &str, parameter: &str) -> Wording {
    Wording::new(
        format!("`{callee}` takes `{parameter}` by reference and needs a variable here"),
        "a value, not a variable",
        "assign the value to a variable first, and pass the variable",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            `double` takes `x_nValue` by reference and needs a variable here
            | a value, not a variable
            ? assign the value to a variable first, and pass the variable
        "#]]
        .assert_eq(&word("double", "x_nValue").to_string());
    }
}
