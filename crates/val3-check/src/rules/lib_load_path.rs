//! V0604: a path for `libLoad` without a library.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// The cell has no library at the path given to `libLoad`.
    ///
    /// ## Why
    /// If `libLoad` finds nothing, it does not stop the task but returns an error code from 20 on (6.6, 6.7). A program
    /// that ignores the code continues with the previous library or with none. The library may exist on the controller
    /// only, so this is a warning. A path that the application passes to `libSave` is not reported.
    ///
    /// ## Bad
    /// ```val3
    /// library part "Disk://part/part.pjx"
    /// if part:libLoad("Disk://patr")==0
    ///   call part:init()
    /// endIf
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
    /// library part "Disk://part/part.pjx"
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
    V0604 "lib-load-path" Warning
}

/// Returns the wording of the finding.
pub(crate) fn word(path: &str) -> Wording {
    Wording::new(
        format!("there is no library at the path `{path}`"),
        "`libLoad` returns an error code here",
        "`Disk://`, or no root at all, is the folder `usrapp`; `./` is the folder of this application",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_message_shows_the_path() {
        expect![[r#"
            there is no library at the path `Disk://patr`
            | `libLoad` returns an error code here
            ? `Disk://`, or no root at all, is the folder `usrapp`; `./` is the folder of this application
        "#]]
        .assert_eq(&word("Disk://patr").to_string());
    }
}
