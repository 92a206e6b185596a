//! V0011: a bracket that is not closed.

use val3_syntax::TextRange;

use crate::{
    diagnostic::{Fix, Wording},
    fix::Site,
    phrase::opening_bracket,
    rule::rule,
};

rule! {
    /// A bracket is not closed on its line.
    ///
    /// ## Why
    /// An instruction ends with its line and cannot continue on the next one. Every `(`, `[` and `{` needs its closing
    /// bracket on the same line. The controller rejects a program without it.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    /// num nLast
    ///
    /// nLast=max(nCount,roundUp(nCount/2)
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    /// num nLast
    ///
    /// nLast=max(nCount,roundUp(nCount/2))
    /// ```
    V0011 "unclosed-bracket" Error
}

/// Returns the wording of the finding; `missing` is the closing bracket.
pub(crate) fn word(missing: char) -> Wording {
    Wording::new(
        format!("the bracket `{}` is not closed on its line", opening_bracket(missing)),
        format!("`{missing}` is missing"),
        "",
    )
}

/// Inserts the bracket at the position of the fault.
pub(crate) fn fix(site: &Site<'_>, missing: char) -> Option<Fix> {
    let edit = site.replace(TextRange::empty(site.range.start()), &missing.to_string());
    Some(Fix::guess(format!("write `{missing}`"), vec![edit]))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn an_argument_list_without_end_is_reported() {
        expect![[r#"
            the bracket `(` is not closed on its line
            | `)` is missing
        "#]]
        .assert_eq(&word(')').to_string());
    }

    #[test]
    fn an_index_without_end_is_reported() {
        expect![[r#"
            the bracket `[` is not closed on its line
            | `]` is missing
        "#]]
        .assert_eq(&word(']').to_string());
    }
}
