//! V0020: a second `default`.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A `switch` has two `default` branches.
    ///
    /// ## Why
    /// `default` matches every value without a `case`. A second `default` could never run, and the controller rejects
    /// the program.
    ///
    /// ## Bad
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
    ///   default
    ///     nSpeed=20
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
    V0020 "second-default" Error
}

/// Returns the wording of the finding.
pub(crate) fn word() -> Wording {
    Wording::new("`switch` has a second `default`", "could never run", "keep one of them")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_second_default_is_reported() {
        expect![[r#"
            `switch` has a second `default`
            | could never run
            ? keep one of them
        "#]]
        .assert_eq(&word().to_string());
    }
}
