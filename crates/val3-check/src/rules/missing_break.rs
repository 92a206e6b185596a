//! V0016: a branch of `switch` without `break`.

use crate::{
    diagnostic::{Fix, Wording},
    fix::Site,
    rule::rule,
};

rule! {
    /// A `case` or `default` is not closed with `break`.
    ///
    /// ## Why
    /// In VAL 3 `break` is not an instruction that ends the branch early. It is the closing keyword of `case` and
    /// `default`, as `endIf` is of `if`, and each branch has exactly one. Execution never continues into the next
    /// branch: write several values for one branch as a list, `case 1, 2`.
    ///
    /// ## Bad
    /// ```val3
    /// num nMode
    /// num nSpeed
    ///
    /// switch nMode
    ///   case 1
    ///     nSpeed=10
    ///   case 2
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
    ///     nSpeed=10
    ///   break
    ///   case 2
    ///     nSpeed=50
    ///   break
    /// endSwitch
    /// ```
    V0016 "missing-break" Error
}

/// Returns the wording of the finding.
pub(crate) fn word() -> Wording {
    Wording::new(
        "a branch of `switch` is not closed with `break`",
        "`break` belongs here",
        "each `case` and `default` ends with its own `break`; write values that share a branch as a list: `case 1, 2`",
    )
}

/// Closes the branch. The fix is safe, because execution never continues into the next branch.
pub(crate) fn fix(site: &Site<'_>) -> Option<Fix> {
    let indentation = site.indentation(site.related?);
    let edit = site.insert_line(&format!("{indentation}break"))?;
    Some(Fix::safe("close the branch with `break`", vec![edit]))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_branch_without_break_is_reported() {
        expect![[r#"
            a branch of `switch` is not closed with `break`
            | `break` belongs here
            ? each `case` and `default` ends with its own `break`; write values that share a branch as a list: `case 1, 2`
        "#]].assert_eq(&word().to_string());
    }
}
