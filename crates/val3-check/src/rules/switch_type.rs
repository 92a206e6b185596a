//! V0214: a switch over values that cannot be compared.

use crate::{built_in, conversion, diagnostic::Wording, english::a, rule::rule};

rule! {
    /// `switch` is used with a value that `==` does not compare.
    ///
    /// ## Why
    /// `switch` finds its branch with `==` (2.2.5). That operator is not defined for numerical inputs and outputs,
    /// serial channels, screens and user types, and the controller does not load such a `switch`. Read the input first,
    /// or use one field of the user type.
    ///
    /// ## Bad
    /// ```val3
    /// aio aiLevel
    ///
    /// switch aiLevel
    ///   case 1
    ///     putln("low")
    ///   break
    /// endSwitch
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// aio aiLevel
    ///
    /// switch aioGet(aiLevel)
    ///   case 1
    ///     putln("low")
    ///   break
    /// endSwitch
    /// ```
    V0214 "switch-type" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(found: &str) -> Wording {
    let help = match built_in::parse(found) {
        Some(_) => conversion::advice(found, "num"),
        None => "use one of its fields".to_owned(),
    };
    Wording::new(
        format!("`switch` cannot compare {} with the values of its `case` lines", a(found)),
        format!("`==` is not defined for `{found}`"),
        help,
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            `switch` cannot compare an `aio` with the values of its `case` lines
            | `==` is not defined for `aio`
            ? `aioGet(…)` reads a numerical input
        "#]]
        .assert_eq(&word("aio").to_string());
        expect![[r#"
            `switch` cannot compare a `Slot` with the values of its `case` lines
            | `==` is not defined for `Slot`
            ? use one of its fields
        "#]]
        .assert_eq(&word("Slot").to_string());
    }
}
