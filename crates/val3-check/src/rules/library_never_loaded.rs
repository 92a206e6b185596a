//! V0603: a library that nothing loads.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A library is used, and nothing ever loads it.
    ///
    /// ## Why
    /// A library identifier with `autoload="false"` is known from the start, but there is no library behind it until
    /// `libLoad` has put one there. The first use of its programs or data before that stops the task with the run-time
    /// error 80 (6.4). Here the whole application has no `libLoad` for the identifier, so this use always fails.
    ///
    /// ## Bad
    /// ```val3
    /// library part "Disk://part/part.pjx" autoload=false
    /// call part:init()
    ///
    /// --- part
    /// public program init()
    /// begin
    ///   putln("part")
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// library part "Disk://part/part.pjx" autoload=false
    /// if part:libLoad("Disk://part")==0
    ///   call part:init()
    /// endIf
    ///
    /// --- part
    /// public program init()
    /// begin
    ///   putln("part")
    /// end
    /// ```
    V0603 "library-never-loaded" Error
}

/// Words the finding.
pub(crate) fn word(alias: &str) -> Wording {
    Wording::new(
        format!("the library `{alias}` is used, but nothing loads it"),
        "run-time error 80 here",
        format!("call `{alias}:libLoad(\"…\")` before, or set `autoload=\"true\"` in the project"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_identifier_is_named() {
        expect![[r#"
            the library `part` is used, but nothing loads it
            | run-time error 80 here
            ? call `part:libLoad("…")` before, or set `autoload="true"` in the project
        "#]]
        .assert_eq(&word("part").to_string());
    }
}
