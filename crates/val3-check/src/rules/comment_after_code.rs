//! V0024: a comment after code.

use val3_syntax::{TextRange, TextSize};

use crate::{
    diagnostic::{Fix, Wording},
    fix::Site,
    rule::rule,
};

rule! {
    /// A comment follows code on the same line.
    ///
    /// ## Why
    /// `//` must be the first text on its line. VAL 3 has no comments after an instruction, and the controller rejects
    /// the program.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    ///
    /// nCount=0 // reset
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    ///
    /// // reset
    /// nCount=0
    /// ```
    V0024 "comment-after-code" Error
}

/// Returns the wording of the finding.
pub(crate) fn word() -> Wording {
    Wording::new(
        "a comment cannot follow code on the same line",
        "`//` must be first on its line",
        "move the comment to a line of its own",
    )
}

/// Moves the comment to a separate line above the code.
pub(crate) fn fix(site: &Site<'_>) -> Option<Fix> {
    let comment = site.text();
    let comment = comment.strip_suffix("&#13;").unwrap_or(comment);
    let moved = site.insert_line(&format!("{}{comment}", site.indentation(site.range)))?;
    let code = site.before().trim_end();
    let end = site.range.start() + TextSize::of(comment);
    let start = site.range.start() - (TextSize::of(site.before()) - TextSize::of(code));
    let removed = site.replace(TextRange::new(start, end), "");
    Some(Fix::safe("move the comment above the line", vec![moved, removed]))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_comment_after_code_is_reported() {
        expect![[r#"
            a comment cannot follow code on the same line
            | `//` must be first on its line
            ? move the comment to a line of its own
        "#]]
        .assert_eq(&word().to_string());
    }
}
