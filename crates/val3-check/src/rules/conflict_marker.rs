//! V0004: an unresolved merge conflict.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A line that version control wrote to mark a merge conflict is still in the file.
    ///
    /// ## Why
    /// When two people changed the same lines, version control keeps both versions and marks them with `<<<<<<<`,
    /// `=======` and `>>>>>>>`. The controller does not know these lines: the file is neither XML nor VAL 3 until one
    /// version is chosen and the marks are removed.
    ///
    /// `val3 merge` writes a conflict of data as a comment before the element, which begins with `<!-- <<<<<<<` and
    /// holds the value of the other branch. The file is XML, but no value has been chosen yet.
    ///
    /// ## Bad
    /// ```val3
    /// num nSpeed
    ///
    /// <<<<<<< HEAD
    /// nSpeed=50
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nSpeed
    ///
    /// nSpeed=50
    /// ```
    V0004 "conflict-marker" Error
}

/// Returns the wording of the finding.
pub(crate) fn word() -> Wording {
    Wording::new(
        "a merge conflict is not resolved",
        "written by version control",
        "keep one version of the lines between `<<<<<<<` and `>>>>>>>`, and remove the marks",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_mark_of_version_control_is_reported() {
        expect![[r#"
            a merge conflict is not resolved
            | written by version control
            ? keep one version of the lines between `<<<<<<<` and `>>>>>>>`, and remove the marks
        "#]]
        .assert_eq(&word().to_string());
    }
}
