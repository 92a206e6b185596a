//! V0602: a private item of a library.

use val3_analysis::problem::NameKind;

use crate::{diagnostic::Wording, phrase::name_kind, rule::rule};

rule! {
    /// Another project uses a private program or private data of a library.
    ///
    /// ## Why
    /// Each program and each variable of a library is public or private. Only the public ones belong to its interface;
    /// only the library's own programs can use the private ones (6.2). A program whose file does not declare its access
    /// is private.
    ///
    /// A test application may use the private items of the tested application. A controller rejects the test
    /// application then; `val3 test` does not.
    ///
    /// ## Bad
    /// ```val3
    /// library part "Disk://part/part.pjx"
    /// call part:init()
    ///
    /// --- part
    /// program init()
    /// begin
    ///   putln("part")
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// library part "Disk://part/part.pjx"
    /// call part:init()
    ///
    /// --- part
    /// public program init()
    /// begin
    ///   putln("part")
    /// end
    /// ```
    V0602 "library-item-private" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(alias: &str, item: &str, what: NameKind) -> Wording {
    Wording::new(
        format!("the {} `{item}` of the library `{alias}` is private", name_kind(what)),
        "private in the library",
        "make it public in the library",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_private_program_is_reported() {
        expect![[r#"
            the program `init` of the library `part` is private
            | private in the library
            ? make it public in the library
        "#]]
        .assert_eq(&word("part", "init", NameKind::Program).to_string());
    }

    #[test]
    fn private_data_are_reported() {
        expect![[r#"
            the data `nWeight` of the library `part` is private
            | private in the library
            ? make it public in the library
        "#]]
        .assert_eq(&word("part", "nWeight", NameKind::Data).to_string());
    }
}
