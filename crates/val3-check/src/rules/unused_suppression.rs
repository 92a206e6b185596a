//! V0702: a comment that silences nothing.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A comment silences a finding that does not exist.
    ///
    /// A comment `//val3: allow(V0701)` silences the findings with this code or name in the next line of code;
    /// `//val3: allow-program(V0701)` before the first line of code silences them in the whole program. Several codes
    /// are separated by commas, and a reason may follow the bracket. Faults of the syntax cannot be silenced.
    ///
    /// ## Why
    /// The fault was corrected, or the comment is before the wrong line. If the comment remained, it would hide the
    /// next fault of this kind. Findings that are turned off are not searched for, so comments about them are not
    /// reported.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    ///
    /// //val3: allow(no-effect)
    /// nCount=0
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    ///
    /// //val3: allow(unknown-name) declared by the generator
    /// nCuont=0
    /// nCount=0
    /// ```
    V0702 "unused-suppression" Warning
}

/// Returns the wording of the finding.
pub(crate) fn word(rule: &str, whole_program: bool) -> Wording {
    let place = if whole_program { "in this program" } else { "in the line below" };
    Wording::new(format!("`{rule}` is not found {place}"), "this silences nothing", "remove it")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_message_for_a_line_names_the_line_below() {
        expect![[r#"
            `V0701` is not found in the line below
            | this silences nothing
            ? remove it
        "#]]
        .assert_eq(&word("V0701", false).to_string());
    }

    #[test]
    fn the_message_for_a_program_names_the_program() {
        expect![[r#"
            `keyword-spelling` is not found in this program
            | this silences nothing
            ? remove it
        "#]]
        .assert_eq(&word("keyword-spelling", true).to_string());
    }
}
