//! V0501: a file of the project that is not on the disk.

use val3_analysis::problem::FileRole;

use crate::{diagnostic::Wording, phrase::file_role, rule::rule};

rule! {
    /// The project names a program file, a data file, a library or a user type that is not on the disk.
    ///
    /// ## Why
    /// The controller opens every file of a project when it loads the application, and does not load it if one is
    /// missing. Files usually get lost when only part of a project is copied. A library is also missing if its folder
    /// has another name on the controller: `Disk://` always means the folder `usrapp`. The letter case of a name does
    /// not matter.
    ///
    /// ## Bad
    /// ```val3
    /// library part "Disk://parts/part.pjx"
    /// putln("ready")
    ///
    /// --- part
    /// public num nWeight
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// library part "Disk://part/part.pjx"
    /// putln("ready")
    ///
    /// --- part
    /// public num nWeight
    /// ```
    V0501 "file-missing" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(what: FileRole, path: &str) -> Wording {
    Wording::new(format!("the {} `{path}` is not on the disk", file_role(what)), "no such file", help(what, path))
}

/// Describes where the controller searches the file.
fn help(what: FileRole, path: &str) -> &'static str {
    match what {
        FileRole::Program | FileRole::Data | FileRole::Project => {
            "copy the file into the folder of the project, or remove the entry"
        }
        FileRole::Library | FileRole::Type if path.starts_with('.') => {
            "`./` is the folder of this project: copy the missing project, or correct the path"
        }
        FileRole::Library | FileRole::Type => {
            "`Disk://` is the folder `usrapp`: copy the missing project there, or correct the path"
        }
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_missing_program_file_is_reported() {
        expect![[r#"
            the program file `cycle.pgx` is not on the disk
            | no such file
            ? copy the file into the folder of the project, or remove the entry
        "#]]
        .assert_eq(&word(FileRole::Program, "cycle.pgx").to_string());
    }

    #[test]
    fn a_missing_library_is_reported() {
        expect![[r#"
            the library `Disk://parts/part.pjx` is not on the disk
            | no such file
            ? `Disk://` is the folder `usrapp`: copy the missing project there, or correct the path
        "#]]
        .assert_eq(&word(FileRole::Library, "Disk://parts/part.pjx").to_string());
    }

    #[test]
    fn a_missing_type_is_reported_with_its_path() {
        expect![[r#"
            the user type `./Slot/Slot.pjx` is not on the disk
            | no such file
            ? `./` is the folder of this project: copy the missing project, or correct the path
        "#]]
        .assert_eq(&word(FileRole::Type, "./Slot/Slot.pjx").to_string());
    }
}
