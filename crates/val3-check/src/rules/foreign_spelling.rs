//! V0026: a word of another language.

use val3_syntax::{TextRange, TextSize};

use crate::{
    diagnostic::{Fix, Wording},
    fix::Site,
    rule::rule,
};

rule! {
    /// A line contains an operator or keyword of another programming language.
    ///
    /// ## Why
    /// VAL 3 writes `and`, `or`, `!` and `!=` where other languages have `&&`, `||`, `not` and `<>`. A condition ends
    /// with its line, without `then` or `do`, and an instruction needs no `;`. The controller supports no other
    /// spelling.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    ///
    /// if nCount>3 && nCount<9
    ///   nCount=0
    /// endIf
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    ///
    /// if nCount>3 and nCount<9
    ///   nCount=0
    /// endIf
    /// ```
    V0026 "foreign-spelling" Error
}

/// Returns the wording of the finding; `instead` is empty if the word must be removed.
pub(crate) fn word(found: &str, instead: &str) -> Wording {
    if instead.is_empty() {
        return Wording::new(format!("VAL 3 has no `{found}`"), "remove it", "");
    }
    Wording::new(format!("VAL 3 writes `{instead}` instead of `{found}`"), format!("write `{instead}`"), "")
}

/// Writes the VAL 3 spelling. A superfluous word is removed, with the preceding blanks if it ends its line.
pub(crate) fn fix(site: &Site<'_>, instead: &str) -> Option<Fix> {
    if !instead.is_empty() {
        return Some(Fix::safe(format!("write `{instead}`"), vec![site.replace(site.range, instead)]));
    }
    let before = site.before();
    let blanks = TextSize::of(before) - TextSize::of(before.trim_end());
    let range = TextRange::new(site.range.start() - blanks, site.range.end());
    let ends_line = site.after().trim().is_empty();
    ends_line.then(|| Fix::safe(format!("remove `{}`", site.text()), vec![site.replace(range, "")]))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn an_operator_of_another_language_is_reported() {
        expect![[r#"
            VAL 3 writes `and` instead of `&&`
            | write `and`
        "#]]
        .assert_eq(&word("&&", "and").to_string());
    }

    #[test]
    fn a_word_of_another_language_is_reported() {
        expect![[r#"
            VAL 3 has no `then`
            | remove it
        "#]]
        .assert_eq(&word("then", "").to_string());
    }
}
