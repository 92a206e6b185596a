//! V0605: a library that lacks an item of the interface.

use val3_analysis::problem::NameKind;

use crate::{diagnostic::Wording, phrase::name_kind, rule::rule};

rule! {
    /// A library that is loaded under an identifier lacks a program or data of its interface.
    ///
    /// ## Why
    /// The project that declares the identifier fixes the interface; any library with the same public programs and
    /// data may be loaded under it (6.3). If one is missing, `libLoad` returns 11, and the first use of the missing
    /// item stops the task with the run-time error 80 (6.6). `libExist` and `isDefined` tell beforehand whether an
    /// item is there.
    ///
    /// ## Bad
    /// ```val3
    /// library part "Disk://partBox/partBox.pjx"
    /// part:libLoad("Disk://partBag")
    /// call part:pick(3)
    ///
    /// --- partBox
    /// public program pick(num x_nCount)
    /// begin
    ///   putln(x_nCount)
    /// end
    ///
    /// --- partBag
    /// public num nWeight
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// library part "Disk://partBox/partBox.pjx"
    /// part:libLoad("Disk://partBag")
    /// call part:pick(3)
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
    V0605 "implementation-missing" Error
}

/// Words the finding.
pub(crate) fn word(alias: &str, library: &str, item: &str, what: NameKind) -> Wording {
    let brackets = if what == NameKind::Program { "()" } else { "" };
    let what = name_kind(what);
    Wording::new(
        format!("the library `{library}` lacks the {what} `{item}` of the interface of `{alias}`"),
        format!("has no {what} `{item}`"),
        format!("add it as public to `{library}`, or ask `{alias}:libExist(\"{item}{brackets}\")` before each use"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_program() {
        expect![[r#"
            the library `partBag` lacks the program `pick` of the interface of `part`
            | has no program `pick`
            ? add it as public to `partBag`, or ask `part:libExist("pick()")` before each use
        "#]]
        .assert_eq(&word("part", "partBag", "pick", NameKind::Program).to_string());
    }

    #[test]
    fn data() {
        expect![[r#"
            the library `partBag` lacks the data `nWeight` of the interface of `part`
            | has no data `nWeight`
            ? add it as public to `partBag`, or ask `part:libExist("nWeight")` before each use
        "#]]
        .assert_eq(&word("part", "partBag", "nWeight", NameKind::Data).to_string());
    }
}
