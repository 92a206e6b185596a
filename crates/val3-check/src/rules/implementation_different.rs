//! V0607: a library whose item differs from the interface.

use val3_analysis::problem::NameKind;

use crate::{diagnostic::Wording, phrase::name_kind, rule::rule};

rule! {
    /// A library that is loaded under an identifier declares an item differently from the interface.
    ///
    /// ## Why
    /// The programs that use the identifier were compiled against the interface. Type, container and, for a program,
    /// each parameter with its type and passing (`&` or not) must be the same (6.2, 6.3). If an item differs, the
    /// interfaces do not match and `libLoad` returns 11 (6.6). A program that tests the code may be right, so this is a
    /// warning.
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
    /// public program pick(string x_sName)
    /// begin
    ///   putln(x_sName)
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
    V0607 "implementation-different" Warning
}

/// Returns the wording of the finding. `expected` and `found` are declarations as syntax lines.
pub(crate) fn word(alias: &str, library: &str, item: &str, what: NameKind, expected: &str, found: &str) -> Wording {
    let what = name_kind(what);
    Wording::new(
        format!(
            "the {what} `{item}` of `{library}` is `{found}`, but the interface of `{alias}` declares `{expected}`"
        ),
        format!("it has `{found}`"),
        format!("declare it as `{expected}` in `{library}`, or change all libraries of this interface alike"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_program_with_other_parameters_is_reported() {
        expect![[r#"
            the program `pick` of `partBag` is `pick(string x_sName)`, but the interface of `part` declares `pick(num x_nCount)`
            | it has `pick(string x_sName)`
            ? declare it as `pick(num x_nCount)` in `partBag`, or change all libraries of this interface alike
        "#]].assert_eq(&word("part", "partBag", "pick", NameKind::Program, "pick(num x_nCount)", "pick(string x_sName)").to_string());
    }

    #[test]
    fn data_of_another_type_are_reported() {
        expect![[r#"
            the data `nSize` of `partBag` is `num nSize`, but the interface of `part` declares `num nSize[3]`
            | it has `num nSize`
            ? declare it as `num nSize[3]` in `partBag`, or change all libraries of this interface alike
        "#]]
        .assert_eq(&word("part", "partBag", "nSize", NameKind::Data, "num nSize[3]", "num nSize").to_string());
    }
}
