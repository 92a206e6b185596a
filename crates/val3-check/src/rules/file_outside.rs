//! V0509: a file of the project that lies outside of it.

use val3_analysis::problem::FileRole;

use crate::{diagnostic::Wording, phrase::file_role, rule::rule};

rule! {
    /// The project names a program or data file outside of its own folder, or a library or user type outside of the
    /// cell: by an absolute path, by `..`, or through a symbolic link. The file is neither read nor changed.
    ///
    /// ## Why
    /// On the controller, the programs and data of a project are files in its folder. A path that leaves the folder works
    /// on one computer at best, and the project file of a stranger could show or change any file of yours.
    ///
    /// The cell is the repository around the project, the folders of `Disk://` and other roots of paths, and the folder
    /// around the project.
    ///
    /// ## Bad
    /// ```text
    /// usrapp/main/main.pjx        lists the program file ../../../shared/cycle.pgx
    /// shared/cycle.pgx            a file
    /// ```
    ///
    /// ## Good
    /// ```text
    /// usrapp/main/main.pjx        lists the program file cycle.pgx
    /// usrapp/main/cycle.pgx       a file
    /// ```
    V0509 "file-outside" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(what: FileRole, path: &str) -> Wording {
    let (place, label, help) = match what {
        FileRole::Program | FileRole::Data | FileRole::Project => (
            "the folder of the project",
            "outside of the project",
            "copy the file into the folder of the project, and write its name",
        ),
        FileRole::Library | FileRole::Type => (
            "the cell",
            "outside of the cell",
            "copy the project into the cell, or name the folder as a root of paths: `roots` in val3.toml, or --root",
        ),
    };
    let role = file_role(what);
    Wording::new(format!("the {role} `{path}` lies outside of {place} and is not read"), label, help)
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_program_outside_of_the_project_is_reported() {
        expect![[r#"
            the program file `../prod/start.pgx` lies outside of the folder of the project and is not read
            | outside of the project
            ? copy the file into the folder of the project, and write its name
        "#]]
        .assert_eq(&word(FileRole::Program, "../prod/start.pgx").to_string());
    }

    #[test]
    fn a_library_outside_of_the_cell_is_reported() {
        expect![[r#"
            the library `../../../home/part` lies outside of the cell and is not read
            | outside of the cell
            ? copy the project into the cell, or name the folder as a root of paths: `roots` in val3.toml, or --root
        "#]]
        .assert_eq(&word(FileRole::Library, "../../../home/part").to_string());
    }
}
