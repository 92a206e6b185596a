//! V0025: a keyword as a name.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A keyword is used as a name.
    ///
    /// ## Why
    /// Keywords cannot name data, programs or libraries, in any letter case: `default`, `Default` and `DEFAULT` all
    /// belong to `switch`. The controller reads the keyword and rejects the line.
    ///
    /// ## Bad
    /// ```val3
    /// num nSpeed
    ///
    /// nSpeed=default
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nSpeed
    /// num nDefault
    ///
    /// nSpeed=nDefault
    /// ```
    V0025 "reserved-word" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(word: &str) -> Wording {
    Wording::new(format!("`{word}` is a keyword of VAL 3 and cannot be a name"), "a keyword", "")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_keyword_used_as_a_name_is_reported() {
        expect![[r#"
            `default` is a keyword of VAL 3 and cannot be a name
            | a keyword
        "#]]
        .assert_eq(&word("default").to_string());
    }
}
