//! V0011: a bracket that is not closed.

use crate::{diagnostic::Wording, phrase::opening_bracket, rule::rule};

rule! {
    /// A bracket is not closed on its line.
    ///
    /// ## Why
    /// An instruction ends with its line; VAL 3 has no sign that continues it on the next one. So every
    /// `(`, `[` and `{` needs its closing bracket on the same line. The controller refuses the
    /// program when one is missing.
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

/// Words the finding; `missing` is the closing bracket.
pub(crate) fn word(missing: char) -> Wording {
    Wording::new(
        format!("the bracket `{}` is not closed on its line", opening_bracket(missing)),
        format!("`{missing}` is missing"),
        "",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn an_argument_list_without_end() {
        expect![[r#"
            the bracket `(` is not closed on its line
            | `)` is missing
        "#]]
        .assert_eq(&word(')').to_string());
    }

    #[test]
    fn an_index_without_end() {
        expect![[r#"
            the bracket `[` is not closed on its line
            | `]` is missing
        "#]]
        .assert_eq(&word(']').to_string());
    }
}
