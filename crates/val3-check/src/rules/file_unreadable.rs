//! V0502: a file or folder that cannot be read.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A file of the application, or the table of an add-on in its cell, exists but cannot be read.
    ///
    /// ## Why
    /// The content of the file is unknown, so nothing that depends on it can be checked. The usual reasons are missing
    /// permissions, a folder with the name of a file, a removed medium, and an editor that saved UTF-16.
    ///
    /// An unreadable table in `usr/app` is reported once, at the first project of the cell that is checked: without it,
    /// the instructions of the add-on are unknown.
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

/// Words the finding.
pub(crate) fn word(reason: &str) -> Wording {
    Wording::new(
        format!("the file or folder cannot be read: {reason}"),
        "",
        "save it as UTF-8 text, allow reading it, or correct its name",
    )
}

/// Words the finding about the table of an add-on.
pub(crate) fn word_table(path: &str, reason: &str) -> Wording {
    Wording::new(
        format!("the table of add-on instructions `usr/{path}` cannot be read: {reason}"),
        "project of this cell",
        "copy the table from the controller again, or delete it if the add-on is not installed",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_message_names_the_path_of_a_table() {
        expect![[r#"
            the table of add-on instructions `usr/app/val3.One.anthro.cfx` cannot be read: line 2: a function has no name
            | project of this cell
            ? copy the table from the controller again, or delete it if the add-on is not installed
        "#]]
        .assert_eq(&word_table("app/val3.One.anthro.cfx", "line 2: a function has no name").to_string());
    }

    #[test]
    fn the_message_gives_the_reason_of_the_system() {
        expect![[r#"
            the file or folder cannot be read: permission denied
            ? save it as UTF-8 text, allow reading it, or correct its name
        "#]]
        .assert_eq(&word("permission denied").to_string());
    }
}
