//! V0012: a bracket without its opening bracket.

use crate::{
    diagnostic::{Fix, Wording},
    fix::Site,
    phrase::opening_bracket,
    rule::rule,
};

rule! {
    /// A closing bracket has no opening bracket on its line.
    ///
    /// ## Why
    /// Brackets belong together in pairs on one line. A superfluous bracket is often left over from a deleted part of
    /// an expression. The controller rejects the program, because the intended pair is ambiguous.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    /// num nHalf
    ///
    /// nHalf=nCount+1)/2
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    /// num nHalf
    ///
    /// nHalf=(nCount+1)/2
    /// ```
    V0012 "unmatched-bracket" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(bracket: char) -> Wording {
    let opening = opening_bracket(bracket);
    Wording::new(
        format!("`{bracket}` closes no bracket"),
        format!("no `{opening}` is open here"),
        format!("remove it, or add the missing `{opening}`"),
    )
}

/// Removes the bracket.
pub(crate) fn fix(site: &Site<'_>, bracket: char) -> Option<Fix> {
    let is_alone = site.text().chars().eq([bracket]);
    is_alone.then(|| Fix::guess(format!("remove `{bracket}`"), vec![site.replace(site.range, "")]))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_closing_bracket_too_many_is_reported() {
        expect![[r#"
            `)` closes no bracket
            | no `(` is open here
            ? remove it, or add the missing `(`
        "#]]
        .assert_eq(&word(')').to_string());
    }
}
