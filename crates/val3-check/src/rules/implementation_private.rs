//! V0606: a library whose item of the interface is private.

use val3_analysis::problem::NameKind;

use crate::{diagnostic::Wording, phrase::name_kind, rule::rule};

rule! {
    /// A library that is loaded under an identifier declares an item of its interface as private.
    ///
    /// ## Why
    /// Only public programs and data are part of an interface (6.2). A private item counts as missing: `libLoad`
    /// returns 11, and its first use stops the task with run-time error 80 (6.6). Often a program was first written for
    /// the library alone and later became part of the interface. A program that tests the code may be right, so this is
    /// a warning.
    ///
    /// ## Bad
    /// ```val3
    /// library part "Disk://partBox/partBox.pjx"
    /// if part:libLoad("Disk://partBag")==0
    ///   call part:pick(3)
    /// endIf
    ///
    /// --- partBox
    /// public program pick(num x_nCount)
    /// begin
    ///   putln(x_nCount)
    /// end
    ///
    /// --- partBag
    /// program pick(num x_nCount)
    /// begin
    ///   putln(x_nCount*2)
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// library part "Disk://partBox/partBox.pjx"
    /// if part:libLoad("Disk://partBag")==0
    ///   call part:pick(3)
    /// endIf
    ///
    /// --- partBox
    /// public program pick(num x_nCount)
    /// begin
    ///   putln(x_nCount)
    /// end
    ///
    /// --- partBag
    /// public program pick(num x_nCount)
    /// begin
    ///   putln(x_nCount*2)
    /// end
    /// ```
    V0606 "implementation-private" Warning
}

/// Returns the wording of the finding.
pub(crate) fn word(alias: &str, library: &str, item: &str, what: NameKind) -> Wording {
    let what = name_kind(what);
    Wording::new(
        format!("the {what} `{item}` is private in the library `{library}`, but belongs to the interface of `{alias}`"),
        format!("its {what} `{item}` is private"),
        format!("make `{item}` public in `{library}`"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_private_program_is_reported() {
        expect![[r#"
            the program `pick` is private in the library `partBag`, but belongs to the interface of `part`
            | its program `pick` is private
            ? make `pick` public in `partBag`
        "#]]
        .assert_eq(&word("part", "partBag", "pick", NameKind::Program).to_string());
    }
}
