//! V0021: code between `switch` and its first branch.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// There is an instruction between `switch` and its first `case`.
    ///
    /// ## Why
    /// Inside `switch` every instruction belongs to a branch. An instruction before the first `case` would belong to no
    /// value, and the syntax does not allow it.
    ///
    /// ## Bad
    /// ```val3
    /// num nMode
    /// num nSpeed
    ///
    /// switch nMode
    ///   nSpeed=20
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
    /// nSpeed=20
    /// switch nMode
    ///   case 1
    ///     nSpeed=50
    ///   break
    /// endSwitch
    /// ```
    V0021 "statement-before-case" Error
}

/// Returns the wording of the finding.
pub(crate) fn word() -> Wording {
    Wording::new(
        "an instruction is between `switch` and its first `case`",
        "belongs to no branch",
        "move it before `switch`, or into a branch",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_statement_before_the_first_case_is_reported() {
        expect![[r#"
            an instruction is between `switch` and its first `case`
            | belongs to no branch
            ? move it before `switch`, or into a branch
        "#]]
        .assert_eq(&word().to_string());
    }
}
