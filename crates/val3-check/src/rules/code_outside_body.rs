//! V0029: code before `begin` or after `end`.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// There is code before `begin` or after `end`.
    ///
    /// ## Why
    /// The code of a program is enclosed by `begin` and `end`. Only blank lines are allowed before and after it. The
    /// controller rejects other text there. If lines follow `end`, that `end` is often a mistake for `endIf` or
    /// `endFor`.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    ///
    /// === main/start.pgx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Programs xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
    ///   <Program name="start" access="public">
    ///     <Code><![CDATA[begin
    ///   nCount=0
    /// end
    /// nCount=1]]></Code>
    ///   </Program>
    /// </Programs>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    ///
    /// === main/start.pgx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Programs xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
    ///   <Program name="start" access="public">
    ///     <Code><![CDATA[begin
    ///   nCount=0
    ///   nCount=1
    /// end]]></Code>
    ///   </Program>
    /// </Programs>
    /// ```
    V0029 "code-outside-body" Error
}

/// Returns the wording of the finding.
pub(crate) fn word() -> Wording {
    Wording::new(
        "this code is outside `begin` and `end`",
        "not part of the program",
        "move it between `begin` and `end`; if an earlier `end` is wrong, remove that one",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_line_after_end_is_reported() {
        expect![[r#"
            this code is outside `begin` and `end`
            | not part of the program
            ? move it between `begin` and `end`; if an earlier `end` is wrong, remove that one
        "#]]
        .assert_eq(&word().to_string());
    }
}
