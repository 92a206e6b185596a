//! V0701: a keyword in an unusual letter case.

use crate::{
    diagnostic::{Fix, Wording},
    fix::Site,
    rule::rule,
};

rule! {
    /// A keyword is not written in its usual letter case.
    ///
    /// ## Why
    /// The controller reads keywords in any letter case. The PC tools write each of them in one way (`endIf`, `elseIf`,
    /// `endFor`, `taskCreateSync`) whenever they save a program. With the same spelling everywhere, a comparison of two
    /// versions shows no lines that differ only in letter case.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    ///
    /// if nCount>9
    ///   nCount=0
    /// endif
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
    V0701 "keyword-spelling" Info
}

/// Returns the wording of the finding.
pub(crate) fn word(found: &str, canonical: &str) -> Wording {
    Wording::new(format!("the keyword `{found}` is usually written `{canonical}`"), format!("write `{canonical}`"), "")
}

/// Writes the keyword in its usual letter case.
pub(crate) fn fix(site: &Site<'_>, canonical: &str) -> Fix {
    Fix::safe(format!("write `{canonical}`"), vec![site.replace(site.range, canonical)])
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_keyword_in_lower_case_is_reported() {
        expect![[r#"
            the keyword `endif` is usually written `endIf`
            | write `endIf`
        "#]]
        .assert_eq(&word("endif", "endIf").to_string());
    }
}
