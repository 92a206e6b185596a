//! V0221: the value of an instruction that returns none.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// An instruction that returns no value is used as a value.
    ///
    /// ## Why
    /// Some instructions such as `delay` or `waitEndMove` return nothing that could be assigned, compared or passed on.
    /// They are written on a line of their own. The controller does not load an application that uses their value.
    ///
    /// ## Bad
    /// ```val3
    /// num nTime
    ///
    /// nTime=delay(0.5)
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nTime
    ///
    /// delay(0.5)
    /// nTime=clock()
    /// ```
    V0221 "no-value" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(callee: &str) -> Wording {
    Wording::new(
        format!("`{callee}` returns no value"),
        "no value",
        format!("write `{callee}(…)` on a line of its own"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            `delay` returns no value
            | no value
            ? write `delay(…)` on a line of its own
        "#]]
        .assert_eq(&word("delay").to_string());
    }
}
