//! V0544: an archive in a checked folder.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A checked folder contains a ZIP archive with VAL 3 files, which is not read.
    ///
    /// ## Why
    /// The archive is probably a backup of a controller. An old backup next to the present files would repeat their
    /// findings, so that archives are only read if they are named: `val3 check backup.zip`. Without this finding, a
    /// report without findings would seem to cover the archive.
    ///
    /// Archives without project, program and data files are not reported. An archive whose contents cannot be listed is
    /// reported with the reason. Set the rule to `off` in `[rules]` if backups belong in the folder, or exclude their
    /// folder.
    ///
    /// ## Bad
    /// ```text
    /// cell/usr/usrapp/main/main.pjx
    /// cell/backup.zip                 contains usr/usrapp/main/main.pjx
    /// ```
    ///
    /// ## Good
    /// ```text
    /// cell/usr/usrapp/main/main.pjx
    /// ```
    V0544 "archive-not-read" Info
}

/// Reason why an archive was not read.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum ArchiveContent {
    /// It contains this number of project files, and no argument names it.
    Projects(usize),
    /// It contains programs or data files without a project file, and no argument names it.
    Parts,
    /// It is inside another archive that was read.
    Nested,
    /// Its contents cannot be listed, for this reason.
    Unknown(String),
}

/// Returns the wording of the finding about the archive `name`; `path` opens it from the current folder.
pub(crate) fn word(name: &str, path: &str, content: &ArchiveContent) -> Wording {
    let (reason, help) = match content {
        ArchiveContent::Projects(1) => ("it contains a project".to_owned(), named(path)),
        ArchiveContent::Projects(count) => (format!("it contains {count} projects"), named(path)),
        ArchiveContent::Parts => ("it contains VAL 3 files".to_owned(), named(path)),
        ArchiveContent::Nested => {
            ("it is in another archive".to_owned(), "unpack the outer archive, and check the inner one".to_owned())
        }
        ArchiveContent::Unknown(reason) => (reason.clone(), "copy it again, or remove it".to_owned()),
    };
    Wording::new(format!("the archive `{name}` is not read: {reason}"), "", help)
}

fn named(path: &str) -> String {
    format!("check it with `val3 check {path}`, or exclude it in `val3.toml`")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_message_states_the_reason_and_the_remedy() {
        let reasons = [
            ArchiveContent::Projects(3),
            ArchiveContent::Parts,
            ArchiveContent::Nested,
            ArchiveContent::Unknown("permission denied".to_owned()),
        ];
        let worded = reasons.map(|reason| word("b.zip", "old/b.zip", &reason).to_string());
        expect![[r#"
            the archive `b.zip` is not read: it contains 3 projects
            ? check it with `val3 check old/b.zip`, or exclude it in `val3.toml`
            the archive `b.zip` is not read: it contains VAL 3 files
            ? check it with `val3 check old/b.zip`, or exclude it in `val3.toml`
            the archive `b.zip` is not read: it is in another archive
            ? unpack the outer archive, and check the inner one
            the archive `b.zip` is not read: permission denied
            ? copy it again, or remove it
        "#]]
        .assert_eq(&worded.concat());
    }
}
