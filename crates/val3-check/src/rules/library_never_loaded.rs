//! V0603: a library that is never loaded.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A library is used but never loaded.
    ///
    /// ## Why
    /// A library identifier with `autoload="false"` has no library until `libLoad` loads one. An earlier use of its
    /// programs or data stops the task with run-time error 80 (6.4). The whole application has no `libLoad` for this
    /// identifier, so this use always fails.
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

/// Returns the wording of the finding.
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
