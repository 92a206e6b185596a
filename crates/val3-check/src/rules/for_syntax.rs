//! V0030: a `for` line of the wrong form.

use crate::{diagnostic::Wording, phrase::found_text, rule::rule};

rule! {
    /// A `for` line has no `=`, no `to`, or no value after `step`.
    ///
    /// ## Why
    /// A counting loop is written `for counter = first to last`, followed by `step` and a number if the step is not 1.
    /// A negative step counts down. All parts must be on one line; the controller rejects any other form.
    ///
    /// ## Bad
    /// ```val3
    /// num nIndex
    /// num nSum
    ///
    /// for nIndex=1, 9
    ///   nSum=nSum+nIndex
    /// endFor
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nIndex
    /// num nSum
    ///
    /// for nIndex=1 to 9
    ///   nSum=nSum+nIndex
    /// endFor
    /// ```
    V0030 "for-syntax" Error
}

/// Returns the wording for a counter that is not followed by `=`.
pub(crate) fn no_assignment(found: &str) -> Wording {
    part("`=`", "after the counter", found)
}

/// Returns the wording for a first value that is not followed by `to`.
pub(crate) fn no_to(found: &str) -> Wording {
    part("`to`", "after the first value", found)
}

/// Returns the wording for a `step` that is not followed by a value.
pub(crate) fn no_step(found: &str) -> Wording {
    part("a value", "after `step`", found)
}

fn part(what: &str, behind: &str, found: &str) -> Wording {
    Wording::new(
        format!("`for` has no {} {behind}: {}", what.trim_start_matches("a "), found_text(found)),
        format!("expected {what}"),
        "write `for nIndex=0 to 9`, followed by `step 2` if needed",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_counter_without_value_is_reported() {
        expect![[r#"
            `for` has no `=` after the counter: `to` was found
            | expected `=`
            ? write `for nIndex=0 to 9`, followed by `step 2` if needed
        "#]]
        .assert_eq(&no_assignment("to").to_string());
    }

    #[test]
    fn a_loop_without_last_value_is_reported() {
        expect![[r#"
            `for` has no `to` after the first value: `,` was found
            | expected `to`
            ? write `for nIndex=0 to 9`, followed by `step 2` if needed
        "#]]
        .assert_eq(&no_to(",").to_string());
    }

    #[test]
    fn a_step_without_value_is_reported() {
        expect![[r#"
            `for` has no value after `step`: the line ends
            | expected a value
            ? write `for nIndex=0 to 9`, followed by `step 2` if needed
        "#]]
        .assert_eq(&no_step("").to_string());
    }
}
