//! V0019: a branch after `default`.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A `case` follows `default`.
    ///
    /// ## Why
    /// The branches are tested from top to bottom, and `default` matches every remaining value. It must therefore be
    /// the last branch. The controller rejects a program with a `case` after it.
    ///
    /// ## Bad
    /// ```val3
    /// num nMode
    /// num nSpeed
    ///
    /// switch nMode
    ///   default
    ///     nSpeed=10
    ///   break
    ///   case 1
    ///     nSpeed=50
    ///   break
    /// endSwitch
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nMode
    /// num nSpeed
    ///
    /// switch nMode
    ///   case 1
    ///     nSpeed=50
    ///   break
    ///   default
    ///     nSpeed=10
    ///   break
    /// endSwitch
    /// ```
    V0019 "case-after-default" Error
}

/// Returns the wording of the finding.
pub(crate) fn word() -> Wording {
    Wording::new(
        "`default` must be the last branch of its `switch`",
        "this `case` follows `default`",
        "move this `case` before `default`",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_case_after_default_is_reported() {
        expect![[r#"
            `default` must be the last branch of its `switch`
            | this `case` follows `default`
            ? move this `case` before `default`
        "#]]
        .assert_eq(&word().to_string());
    }
}
