//! V0015: the end of a block that is not open.

use crate::{
    diagnostic::{Fix, Wording},
    fix::Site,
    rule::rule,
};

rule! {
    /// A keyword ends or continues a block that is not open.
    ///
    /// ## Why
    /// `else`, `elseIf` and the closing keywords belong to the innermost open block. If the block before them is
    /// already closed, or was never opened, the controller rejects the program. Often the line that opens the block was
    /// deleted, or its end was written twice. No further branch can follow `else`.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    ///
    /// if nCount>9
    ///   nCount=0
    /// endIf
    /// endIf
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    ///
    /// if nCount>9
    ///   nCount=0
    /// endIf
    /// ```
    V0015 "unmatched-block-end" Error
}

/// Returns the wording for the keyword `found` without an open `opener`.
pub(crate) fn word(found: &str, opener: &str) -> Wording {
    Wording::new(
        format!("`{found}` belongs to no `{opener}`"),
        format!("no `{opener}` is open here"),
        format!("remove it, or add the `{opener}` that is missing above"),
    )
}

/// Returns the wording for `else` or `elseIf` after `else`.
pub(crate) fn else_after_else() -> Wording {
    Wording::new(
        "`else` must be the last branch of its `if`",
        "this branch follows `else`",
        "move this branch before `else`, or close the block with `endIf` first",
    )
}

/// Removes the keyword that ends a block, with its line if nothing else is on it. `else` and `elseIf` are followed by code.
pub(crate) fn fix(site: &Site<'_>, found: &str) -> Option<Fix> {
    let is_alone = site.before().trim().is_empty() && site.after().trim().is_empty();
    let is_end = found.starts_with("end") && site.text().eq_ignore_ascii_case(found);
    (is_alone && is_end).then(|| Fix::guess(format!("remove this `{found}`"), vec![site.remove_line()]))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn an_end_without_block_is_reported() {
        expect![[r#"
            `endIf` belongs to no `if`
            | no `if` is open here
            ? remove it, or add the `if` that is missing above
        "#]]
        .assert_eq(&word("endIf", "if").to_string());
    }

    #[test]
    fn a_branch_after_else_is_reported() {
        expect![[r#"
            `else` must be the last branch of its `if`
            | this branch follows `else`
            ? move this branch before `else`, or close the block with `endIf` first
        "#]]
        .assert_eq(&else_after_else().to_string());
    }
}
