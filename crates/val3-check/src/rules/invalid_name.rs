//! V0110: a name with characters that are not allowed.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A name has a character that VAL 3 does not allow in names.
    ///
    /// ## Why
    /// A name consists of letters, digits and `_`, and begins with a letter (2.5.1). The letters are the 26 of English,
    /// without accents. Names of programs, local variables and parameters may also begin with `_`. The controller does
    /// not load any other name.
    ///
    /// ## Bad
    /// ```val3
    /// num nLänge
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nLength
    /// ```
    V0110 "invalid-name" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(name: &str) -> Wording {
    Wording::new(
        reason(name),
        "not a name of VAL 3",
        "names have the letters `a` to `z` and `A` to `Z`, digits and `_`, and begin with a letter",
    )
}

/// Reason why `name` is invalid: its most obvious fault.
fn reason(name: &str) -> String {
    let foreign = name.chars().find(|&letter| !letter.is_ascii_alphanumeric() && letter != '_');
    match (name.chars().next(), foreign) {
        (None, _) => "the name is empty".to_owned(),
        (_, Some(' ')) => format!("the name `{name}` contains a blank"),
        (_, Some(foreign)) => {
            format!("the name `{name}` contains `{foreign}`, which no name may have")
        }
        (Some(first), None) => {
            format!("the name `{name}` begins with `{first}`, not with a letter")
        }
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            the name `nLänge` contains `ä`, which no name may have
            | not a name of VAL 3
            ? names have the letters `a` to `z` and `A` to `Z`, digits and `_`, and begin with a letter
        "#]]
        .assert_eq(&word("nLänge").to_string());
    }

    #[test]
    fn the_message_gives_the_reason() {
        expect!["the name `2nd` begins with `2`, not with a letter"].assert_eq(&reason("2nd"));
        expect!["the name `n Count` contains a blank"].assert_eq(&reason("n Count"));
        expect!["the name is empty"].assert_eq(&reason(""));
    }
}
