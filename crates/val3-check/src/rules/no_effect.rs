//! V0220: a line that does nothing.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A line computes a value and does nothing with it.
    ///
    /// ## Why
    /// A line must assign a value, call a program, or use an instruction that acts. A comparison, a calculation or an
    /// instruction that only yields a value changes nothing when it stands alone, so it is almost always a slip, and
    /// the controller does not load the application. The usual one is `==` where `=` is meant.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    ///
    /// nCount==0
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    ///
    /// nCount=0
    /// ```
    V0220 "no-effect" Error
}

/// Words the finding.
pub(crate) fn word() -> Wording {
    Wording::new(
        "this line computes a value and does nothing with it",
        "the value is lost",
        "assign the value to a variable; an assignment is written with one `=`",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn wording() {
        expect![[r#"
            this line computes a value and does nothing with it
            | the value is lost
            ? assign the value to a variable; an assignment is written with one `=`
        "#]]
        .assert_eq(&word().to_string());
    }
}
