//! V0029: code before `begin` or after `end`.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// Code stands before `begin` or after `end`.
    ///
    /// ## Why
    /// A program is what stands between `begin` and `end`. Around them only blank lines are possible. The
    /// controller refuses other text there. When lines follow `end`, that `end` is often one too many,
    /// meant to be an `endIf` or `endFor`.
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

/// Words the finding.
pub(crate) fn word() -> Wording {
    Wording::new(
        "code stands outside `begin` and `end`",
        "not part of the program",
        "move it between `begin` and `end`; if an `end` stands too early, remove that one",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_line_behind_end() {
        expect![[r#"
            code stands outside `begin` and `end`
            | not part of the program
            ? move it between `begin` and `end`; if an `end` stands too early, remove that one
        "#]]
        .assert_eq(&word().to_string());
    }
}
