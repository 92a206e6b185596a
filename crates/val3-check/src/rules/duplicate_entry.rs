//! V0503: an entry that a project has twice.

use val3_analysis::problem::FileRole;

use crate::{
    diagnostic::{Fix, Wording},
    fix::Site,
    phrase::file_role,
    rule::rule,
};

rule! {
    /// A project lists a file twice, or declares a library identifier or a user type twice.
    ///
    /// ## Why
    /// A program file listed twice would define its program twice. If a library identifier or a user type is declared
    /// twice, it is unclear which project it means. The controller rejects both when it loads the project. One library
    /// may have several identifiers; only the identifiers must be unique.
    ///
    /// ## Bad
    /// ```val3
    /// library part "Disk://partBox/partBox.pjx"
    /// library part "Disk://partBag/partBag.pjx"
    /// putln("ready")
    ///
    /// --- partBox
    /// public num nWeight
    ///
    /// --- partBag
    /// public num nWeight
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// library box "Disk://partBox/partBox.pjx"
    /// library bag "Disk://partBag/partBag.pjx"
    /// putln("ready")
    ///
    /// --- partBox
    /// public num nWeight
    ///
    /// --- partBag
    /// public num nWeight
    /// ```
    V0503 "duplicate-entry" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(what: FileRole, name: &str) -> Wording {
    match what {
        FileRole::Library => declared_twice("library identifier", name),
        FileRole::Type => declared_twice("user type", name),
        FileRole::Project | FileRole::Program | FileRole::Data => Wording::new(
            format!("the {} `{name}` is listed twice", file_role(what)),
            "the second entry",
            "remove one of the two entries",
        ),
    }
}

fn declared_twice(what: &str, name: &str) -> Wording {
    Wording::new(
        format!("the {what} `{name}` is declared twice"),
        "the second declaration",
        "remove one of the two, or rename it",
    )
}

/// Removes the second entry of a file if it is the only text on its line. There is no fix for libraries and types,
/// because either declaration may be the right one.
pub(crate) fn fix(site: &Site<'_>, what: FileRole) -> Option<Fix> {
    let is_list = matches!(what, FileRole::Program | FileRole::Data);
    let opens = site.before().trim_start().strip_prefix('<').is_some_and(|rest| !rest.contains('<'));
    let closes = site.after().trim_end().strip_suffix("/>").is_some_and(|rest| !rest.contains('>'));
    (is_list && opens && closes).then(|| Fix::safe("remove the second entry", vec![site.remove_line()]))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_program_listed_twice_is_reported() {
        expect![[r#"
            the program file `pick.pgx` is listed twice
            | the second entry
            ? remove one of the two entries
        "#]]
        .assert_eq(&word(FileRole::Program, "pick.pgx").to_string());
    }

    #[test]
    fn a_library_identifier_listed_twice_is_reported() {
        expect![[r#"
            the library identifier `part` is declared twice
            | the second declaration
            ? remove one of the two, or rename it
        "#]]
        .assert_eq(&word(FileRole::Library, "part").to_string());
    }

    #[test]
    fn a_type_listed_twice_is_reported() {
        expect![[r#"
            the user type `Slot` is declared twice
            | the second declaration
            ? remove one of the two, or rename it
        "#]]
        .assert_eq(&word(FileRole::Type, "Slot").to_string());
    }
}
