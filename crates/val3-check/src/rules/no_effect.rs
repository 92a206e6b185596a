//! V0220: a line without an effect.

use val3_syntax::{TextRange, TextSize};

use crate::{
    diagnostic::{Fix, Wording},
    fix::Site,
    rule::rule,
};

rule! {
    /// A line computes a value and does not use it.
    ///
    /// ## Why
    /// A line must assign a value, call a program, or use an instruction that has an effect. A comparison, a
    /// calculation or an instruction that only returns a value has no effect on a line of its own. It is almost always
    /// a mistake, usually `==` in place of `=`, and the controller does not load the application.
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

/// Returns the wording of the finding.
pub(crate) fn word() -> Wording {
    Wording::new(
        "this line computes a value and does not use it",
        "the value is lost",
        "assign the value to a variable; an assignment is written with one `=`",
    )
}

/// Replaces the comparison by an assignment if its left side is a variable.
pub(crate) fn fix(site: &Site<'_>) -> Option<Fix> {
    const SIGN: &str = "==";
    let (target, value) = site.text().split_once(SIGN)?;
    let is_path = target.chars().all(|letter| letter.is_ascii_alphanumeric() || "_.:[],\" ".contains(letter));
    let is_variable = is_path && !value.contains(SIGN);
    let range = TextRange::at(site.range.start() + TextSize::of(target), TextSize::of(SIGN));
    is_variable.then(|| Fix::guess("write `=`", vec![site.replace(range, "=")]))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            this line computes a value and does not use it
            | the value is lost
            ? assign the value to a variable; an assignment is written with one `=`
        "#]]
        .assert_eq(&word().to_string());
    }
}
