//! V0502: a file that cannot be read.

use val3_analysis::cell::UnreadableCellFile;

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A file of the application, or a configuration file of its cell, exists but cannot be read.
    ///
    /// ## Why
    /// The content of the file is unknown, so nothing that depends on it can be checked. The usual reasons are missing
    /// permissions, a folder with the name of a file, a removed medium, a file that is too large, an editor that saved
    /// UTF-16, an interrupted copy, which leaves an empty file or NUL bytes, and a Git LFS pointer in place of the file. A
    /// configuration file of the cell must also be complete XML without merge conflicts. Only regular files are read: a
    /// device or a pipe has no end, or waits for another program.
    ///
    /// The finding is at the entry of the project. A file of the cell, such as `usr/configs/arm.cfx` or the table of an
    /// add-on in `usr/app`, is reported once, at the first project of the cell that is checked.
    ///
    /// No setting, option or baseline removes the finding, and `val3 check` ends with exit code 2: without the file, a
    /// report without findings would be wrong.
    ///
    /// ## Bad
    /// ```text
    /// usrapp/main/main.pjx        lists the program file cycle.pgx
    /// usrapp/main/cycle.pgx/      a folder
    /// ```
    ///
    /// ## Good
    /// ```text
    /// usrapp/main/main.pjx        lists the program file cycle.pgx
    /// usrapp/main/cycle.pgx       a file
    /// ```
    V0502 "file-unreadable" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(path: &str, reason: &str) -> Wording {
    Wording::new(
        format!("the file `{path}` cannot be read: {reason}"),
        "nothing that depends on it is checked",
        "copy it again, save it as UTF-8 text, allow reading it, or correct its name",
    )
}

/// Returns the wording of the finding about a file of the cell.
pub(crate) fn word_cell_file(file: &UnreadableCellFile) -> Wording {
    let UnreadableCellFile { path, reason } = file;
    Wording::new(
        format!("the file `usr/{path}` of the cell cannot be read: {reason}"),
        "project of this cell",
        "copy the file from the controller again, or delete it if the controller does not have it",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_message_names_the_file_of_the_cell() {
        let file = UnreadableCellFile {
            path: "app/val3.One.anthro.cfx".into(),
            reason: "line 2: a function has no name".into(),
        };
        expect![[r#"
            the file `usr/app/val3.One.anthro.cfx` of the cell cannot be read: line 2: a function has no name
            | project of this cell
            ? copy the file from the controller again, or delete it if the controller does not have it
        "#]]
        .assert_eq(&word_cell_file(&file).to_string());
    }

    #[test]
    fn the_message_gives_the_reason_of_the_system() {
        expect![[r#"
            the file `cycle.pgx` cannot be read: permission denied
            | nothing that depends on it is checked
            ? copy it again, save it as UTF-8 text, allow reading it, or correct its name
        "#]]
        .assert_eq(&word("cycle.pgx", "permission denied").to_string());
    }
}
