//! V0502: a file or folder that cannot be read.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A file of the application exists and cannot be read.
    ///
    /// ## Why
    /// What the file says stays unknown, so nothing that depends on it can be judged. The usual reasons are missing
    /// rights, a folder that has the name of a file, a medium that was taken out, and an editor that saved UTF-16.
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
        "save it as UTF-8 text, give the right to read it, or correct its name",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_reason_is_the_systems() {
        expect![[r#"
            the file or folder cannot be read: permission denied
            ? save it as UTF-8 text, give the right to read it, or correct its name
        "#]]
        .assert_eq(&word("permission denied").to_string());
    }
}
