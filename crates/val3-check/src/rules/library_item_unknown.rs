//! V0601: an item that the interface of a library lacks.

use val3_analysis::problem::NameKind;

use crate::{
    diagnostic::Wording,
    phrase::{did_you_mean_or, name_kind},
    rule::rule,
};

rule! {
    /// The interface of a library identifier has no program or data of this name.
    ///
    /// ## Why
    /// A library identifier stands for an interface: the public programs and data of the project that declares it
    /// (6.2, 6.3). What is not in the interface cannot be used through the identifier, even if a library that is
    /// loaded under it later has it: the controller reports an unknown name and does not load the application.
    ///
    /// ## Bad
    /// ```val3
    /// library part "Disk://part/part.pjx"
    /// call part:inti()
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
    /// call part:init()
    ///
    /// --- part
    /// public program init()
    /// begin
    ///   putln("part")
    /// end
    /// ```
    V0601 "library-item-unknown" Error
}

/// Words the finding.
pub(crate) fn word(alias: &str, item: &str, what: NameKind, near: Option<&str>) -> Wording {
    Wording::new(
        format!("the library `{alias}` has no {} `{item}`", name_kind(what)),
        format!("not in the interface of `{alias}`"),
        did_you_mean_or(
            near,
            &format!("only the public programs and data of the project behind `{alias}` can be used"),
        ),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_near_miss() {
        expect![[r#"
            the library `part` has no program `inti`
            | not in the interface of `part`
            ? did you mean `init`?
        "#]]
        .assert_eq(&word("part", "inti", NameKind::Program, Some("init")).to_string());
    }

    #[test]
    fn nothing_near() {
        expect![[r#"
            the library `part` has no data `nAngle`
            | not in the interface of `part`
            ? only the public programs and data of the project behind `part` can be used
        "#]]
        .assert_eq(&word("part", "nAngle", NameKind::Data, None).to_string());
    }
}
