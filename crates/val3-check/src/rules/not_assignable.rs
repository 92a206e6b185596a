//! V0224: an assignment to something other than a variable.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// The left side of `=` is not a variable.
    ///
    /// ## Why
    /// `=` stores a value in a variable: a local variable, a parameter, data of the application or of a library, or an
    /// element or field of a variable. The result of an instruction or of a calculation cannot store a value, and the
    /// controller does not load the application.
    ///
    /// ## Bad
    /// ```val3
    /// num nList[3]
    ///
    /// size(nList)=5
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nList[3]
    ///
    /// resize(nList,1,5)
    /// ```
    V0224 "not-assignable" Error
}

/// Returns the wording of the finding.
pub(crate) fn word() -> Wording {
    Wording::new("a value can only be assigned to a variable", "not a variable", String::new())
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            a value can only be assigned to a variable
            | not a variable
        "#]]
        .assert_eq(&word().to_string());
    }
}
