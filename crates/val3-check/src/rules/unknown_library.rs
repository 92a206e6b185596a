//! V0105: a library identifier that the project does not declare.

use crate::{diagnostic::Wording, english::meant, rule::rule};

rule! {
    /// The project does not declare this library identifier.
    ///
    /// ## Why
    /// The name before a colon is a library identifier. The project file declares it in `<Libraries>` together with the
    /// library that defines its interface. Without the declaration the library's programs and data are unknown, and the
    /// controller does not load the application. `libLoad` changes the library of an identifier but does not declare
    /// one (6.3).
    ///
    /// ## Bad
    /// ```val3
    /// library part "Disk://part/part.pjx"
    ///
    /// call parts:pick()
    ///
    /// --- part
    /// public program pick()
    /// begin
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// library part "Disk://part/part.pjx"
    ///
    /// call part:pick()
    ///
    /// --- part
    /// public program pick()
    /// begin
    /// end
    /// ```
    V0105 "unknown-library" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(alias: &str, near: Option<&str>) -> Wording {
    Wording::new(
        format!("the project declares no library identifier `{alias}`"),
        "no such library identifier",
        meant(alias, near, "declare it in `<Libraries>` of the project file"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            the project declares no library identifier `parts`
            | no such library identifier
            ? did you mean `part`?
        "#]]
        .assert_eq(&word("parts", Some("part")).to_string());
        expect![[r#"
            the project declares no library identifier `vision`
            | no such library identifier
            ? declare it in `<Libraries>` of the project file
        "#]]
        .assert_eq(&word("vision", None).to_string());
    }
}
