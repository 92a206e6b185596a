//! V0018: a branch outside a `switch`.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// `case` or `default` is used outside `switch`.
    ///
    /// ## Why
    /// A branch belongs to the `switch` around it. If `endSwitch` comes too early, or the line with `switch` was
    /// deleted, the branch has nothing to compare with, and the controller rejects the program.
    ///
    /// ## Bad
    /// ```val3
    /// num nMode
    /// num nSpeed
    ///
    /// switch nMode
    ///   case 1
    ///     nSpeed=10
    ///   break
    /// endSwitch
    ///   case 2
    ///     nSpeed=50
    ///   break
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nMode
    /// num nSpeed
    ///
    /// switch nMode
    ///   case 1
    ///     nSpeed=10
    ///   break
    ///   case 2
    ///     nSpeed=50
    ///   break
    /// endSwitch
    /// ```
    V0018 "case-outside-switch" Error
}

/// Returns the wording of the finding.
pub(crate) fn word() -> Wording {
    Wording::new(
        "`case` and `default` belong inside `switch`",
        "no `switch` is open here",
        "move the branch into a `switch`, or add the line `switch …` above it",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_case_without_switch_is_reported() {
        expect![[r#"
            `case` and `default` belong inside `switch`
            | no `switch` is open here
            ? move the branch into a `switch`, or add the line `switch …` above it
        "#]]
        .assert_eq(&word().to_string());
    }
}
