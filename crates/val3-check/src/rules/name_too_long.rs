//! V0109: a name longer than the version allows.

use crate::{diagnostic::Wording, english::count, rule::rule};

rule! {
    /// A name is longer than the VAL 3 version of the project allows.
    ///
    /// ## Why
    /// Up to s7, the name of data, a local variable, a parameter, a program or a library identifier has at most 15
    /// characters (2.5.1). From s8 on longer names are accepted. A project that declares s7 but runs on a CS9
    /// controller loads with longer names; on a CS8 controller it does not.
    ///
    /// ## Bad
    /// ```val3
    /// version s7.11
    /// num nPartsOnConveyor
    ///
    /// nPartsOnConveyor=0
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// version s7.11
    /// num nPartsOnConv
    ///
    /// nPartsOnConv=0
    /// ```
    V0109 "name-too-long" Info
}

/// Returns the wording of the finding.
pub(crate) fn word(name: &str, limit: usize) -> Wording {
    let length = name.chars().count();
    Wording::new(
        format!("the name `{name}` has {}; this version of VAL 3 allows {limit}", count(length, "character")),
        format!("{} too long", count(length.saturating_sub(limit), "character")),
        "",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            the name `nPartsOnConveyor` has 16 characters; this version of VAL 3 allows 15
            | 1 character too long
        "#]]
        .assert_eq(&word("nPartsOnConveyor", 15).to_string());
    }
}
