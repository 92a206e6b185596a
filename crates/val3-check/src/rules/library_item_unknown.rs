//! V0601: an item that the interface of a library does not contain.

use smol_str::SmolStr;
use val3_analysis::problem::NameKind;

use crate::{
    diagnostic::Wording,
    english::{all_of, count},
    phrase::{did_you_mean_or, name_kind},
    rule::rule,
};

rule! {
    /// The interface of a library identifier has no program or data of this name.
    ///
    /// ## Why
    /// A library identifier has an interface: the public programs and data of the project that declares it (6.2, 6.3).
    /// Other items cannot be used through the identifier, even if a library that is loaded later has them. The
    /// controller reports an unknown name and does not load the application.
    ///
    /// If the project of the library lists none of the items that are used, there is a single finding at the entry of
    /// the library, which names the unlisted files in its folder. The usual reason is an empty `.pjx` in place of the
    /// true one.
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

/// Returns the wording of the finding.
pub(crate) fn word(alias: &str, item: &str, what: NameKind, near: Option<&str>) -> Wording {
    Wording::new(
        format!("the library `{alias}` has no {} `{item}`", name_kind(what)),
        format!("not in the interface of `{alias}`"),
        did_you_mean_or(near, &format!("only the public programs and data of the project of `{alias}` can be used")),
    )
}

/// Returns the wording of the finding that the library's project does not list the used items.
pub(crate) fn left_out(alias: &str, missing: &[SmolStr], unlisted: &[SmolStr], uses: usize) -> Wording {
    let (label, help) = if unlisted.is_empty() {
        ("its project is empty", format!("list the programs and data of `{alias}` in its project"))
    } else {
        ("its project does not list them", format!("list the files next to it: {}", all_of(unlisted)))
    };
    Wording::new(
        format!("the library `{alias}` does not contain {}, used in {}", all_of(missing), count(uses, "place")),
        label,
        help,
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_help_proposes_a_similar_name() {
        expect![[r#"
            the library `part` has no program `inti`
            | not in the interface of `part`
            ? did you mean `init`?
        "#]]
        .assert_eq(&word("part", "inti", NameKind::Program, Some("init")).to_string());
    }

    #[test]
    fn an_empty_library_is_reported() {
        let (missing, files) = (["init".into(), "nA".into()], ["init.pgx".into(), "part.dtx".into()]);
        expect![[r#"
            the library `part` does not contain `init` and `nA`, used in 3 places
            | its project does not list them
            ? list the files next to it: `init.pgx` and `part.dtx`
        "#]]
        .assert_eq(&left_out("part", &missing, &files, 3).to_string());
        expect![[r#"
            the library `part` does not contain `init` and `nA`, used in 1 place
            | its project is empty
            ? list the programs and data of `part` in its project
        "#]]
        .assert_eq(&left_out("part", &missing, &[], 1).to_string());
    }

    #[test]
    fn the_help_is_empty_without_a_similar_name() {
        expect![[r#"
            the library `part` has no data `nAngle`
            | not in the interface of `part`
            ? only the public programs and data of the project of `part` can be used
        "#]]
        .assert_eq(&word("part", "nAngle", NameKind::Data, None).to_string());
    }
}
