//! V0221: the value of an instruction that yields none.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// An instruction that yields no value is used as a value.
    ///
    /// ## Why
    /// Some instructions only act, such as `delay` or `waitEndMove`: nothing can be assigned, compared or passed on
    /// from them. They stand alone on their line. The controller does not load an application that uses their value.
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

/// Words the finding.
pub(crate) fn word(callee: &str) -> Wording {
    Wording::new(format!("`{callee}` yields no value"), "no value", format!("write `{callee}(…)` on a line of its own"))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn wording() {
        expect![[r#"
            `delay` yields no value
            | no value
            ? write `delay(…)` on a line of its own
        "#]]
        .assert_eq(&word("delay").to_string());
    }
}
