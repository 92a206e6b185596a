//! V0026: a word of another language.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// An operator or keyword of another programming language.
    ///
    /// ## Why
    /// VAL 3 writes `and`, `or`, `!` and `!=` where other languages have `&&`, `||`, `not` and `<>`. A
    /// condition ends with its line, without `then` or `do`, and an instruction needs no `;`. The controller
    /// knows none of the other spellings.
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

/// Words the finding; `instead` is empty where the word is to be removed.
pub(crate) fn word(found: &str, instead: &str) -> Wording {
    if instead.is_empty() {
        return Wording::new(format!("VAL 3 has no `{found}`"), "remove it", "");
    }
    Wording::new(format!("VAL 3 writes `{instead}` instead of `{found}`"), format!("write `{instead}`"), "")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn an_operator_of_another_language() {
        expect![[r#"
            VAL 3 writes `and` instead of `&&`
            | write `and`
        "#]]
        .assert_eq(&word("&&", "and").to_string());
    }

    #[test]
    fn a_word_too_many() {
        expect![[r#"
            VAL 3 has no `then`
            | remove it
        "#]]
        .assert_eq(&word("then", "").to_string());
    }
}
