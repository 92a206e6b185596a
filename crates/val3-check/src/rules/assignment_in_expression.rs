//! V0023: `=` inside an expression.

use val3_syntax::SyntaxKind;

use crate::{
    diagnostic::{Fix, Wording},
    fix::Site,
    rule::rule,
};

rule! {
    /// `=` is used inside an expression, where only the comparison `==` is possible.
    ///
    /// ## Why
    /// `=` sets a variable and `==` compares two values. To keep the two apart, VAL 3 allows `=` only as the main part
    /// of a line (`nA=nB=0` sets both), never in a condition or an argument. Otherwise `if bA=bB` would change `bA`
    /// instead of testing it.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    ///
    /// if nCount=10
    ///   nCount=0
    /// endIf
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    ///
    /// if nCount==10
    ///   nCount=0
    /// endIf
    /// ```
    V0023 "assignment-in-expression" Error
}

/// Returns the wording of the finding.
pub(crate) fn word() -> Wording {
    Wording::new(
        "`=` assigns a value and is not allowed inside an expression",
        "did you mean `==`?",
        "write `==` to compare; to assign, use a line of its own",
    )
}

/// Replaces `=` by `==`. Outside of a condition, a second assignment may be intended.
pub(crate) fn fix(site: &Site<'_>) -> Option<Fix> {
    let first = site.before().split(|letter: char| !letter.is_ascii_alphanumeric()).find(|word| !word.is_empty());
    let safe = first.is_some_and(|word| SyntaxKind::from_keyword(word).is_some());
    Some(Fix { title: "write `==`".to_owned(), safe, edits: vec![site.replace(site.range, "==")] })
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn an_assignment_in_a_condition_is_reported() {
        expect![[r#"
            `=` assigns a value and is not allowed inside an expression
            | did you mean `==`?
            ? write `==` to compare; to assign, use a line of its own
        "#]]
        .assert_eq(&word().to_string());
    }
}
