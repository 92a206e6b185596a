//! V0543: a program or data file without a project in its folder.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A program or data file lies in a folder without a project file (`.pjx`).
    ///
    /// ## Why
    /// The project declares the data, the user types and the libraries of its programs. Without it, the file is checked for
    /// syntax and for everything else that needs no project: names and types that a project declares are not checked. No
    /// controller loads the file. It may be left over, or the project file was not copied with it.
    ///
    /// `val3 check FOLDER` reports such files in a folder and below it, and `val3 check FILE` a file that is named.
    ///
    /// ## Bad
    /// ```text
    /// old/cycle.pgx       the only file of the folder
    /// ```
    ///
    /// ## Good
    /// ```text
    /// main/main.pjx       lists the program file cycle.pgx
    /// main/main.dtx
    /// main/cycle.pgx
    /// ```
    V0543 "file-without-project" Info
}

/// Returns the wording of the finding.
pub(crate) fn word(name: &str) -> Wording {
    Wording::new(
        format!(
            "`{name}` has no project (`.pjx`) in its folder: names and types that a project declares are not checked"
        ),
        "checked without a project",
        "add the project that lists it, or name the folder that has both",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_message_states_the_extent_of_the_check() {
        expect![[r#"
            `cycle.pgx` has no project (`.pjx`) in its folder: names and types that a project declares are not checked
            | checked without a project
            ? add the project that lists it, or name the folder that has both
        "#]]
        .assert_eq(&word("cycle.pgx").to_string());
    }
}
