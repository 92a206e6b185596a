//! Conflicts: their names, and the comment that preserves the values of base and theirs in the file.

use std::fmt;

/// Start of a comment that contains a conflict, which the parser of VAL 3 files reports.
pub(crate) const OPENING: &str = "<!-- <<<<<<<";

/// A change that a person must merge.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Conflict {
    /// Name of the data, element or program, for example `pPick[2]` or `parameter x_nSlot`.
    pub path: String,
    /// Contradicting changes, for example `x is 5 in ours and 7 in theirs`.
    pub reason: String,
}

impl fmt::Display for Conflict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "conflict in `{}`: {}", self.path, self.reason)
    }
}

/// Place of ours in a conflict.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Ours {
    /// Ours follows the comment.
    Follows,
    /// Ours has removed the element.
    Removed,
    /// Ours is in another list of the file.
    Elsewhere,
}

/// Formats the comment with the text of base and theirs; `None` for an element that does not exist. `line_end` is the
/// line end of the file.
pub(crate) fn comment(conflict: &Conflict, ours: Ours, [base, theirs]: [Option<&str>; 2], line_end: &str) -> String {
    let quoted = |text: &str| text.replace("--", "-&#45;");
    let version = |text: Option<&str>| text.map_or_else(|| "(none)".to_owned(), |text| quoted(&unindented(text)));
    let ours = match ours {
        Ours::Follows => "ours follows this comment",
        Ours::Removed => "ours has removed it",
        Ours::Elsewhere => "ours is in another section",
    };
    let lines = [
        format!("{OPENING} {}", quoted(&conflict.to_string())),
        "||||||| base".to_owned(),
        version(base),
        "======= theirs".to_owned(),
        version(theirs),
        format!(">>>>>>> {ours}: choose a version, and remove the comment -->"),
    ];
    lines.join("\n").replace("\r\n", "\n").replace('\n', line_end)
}

/// Removes the common indentation of all lines after the first.
fn unindented(text: &str) -> String {
    let indentation = |line: &str| line.len() - line.trim_start_matches([' ', '\t']).len();
    let common = text.lines().skip(1).filter(|line| !line.trim().is_empty()).map(indentation).min().unwrap_or(0);
    let mut lines = text.lines();
    let first = lines.next().unwrap_or("").to_owned();
    lines.fold(first, |all, line| format!("{all}\n{}", line.get(common..).unwrap_or("")))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_comment_is_one_comment_of_xml() {
        let conflict = Conflict { path: "sName[0]".to_owned(), reason: "value is `--` in ours".to_owned() };
        let text = comment(&conflict, Ours::Follows, [None, Some("<Value value=\"-->\">\n    <a/>\n  </Value>")], "\n");
        expect![[r#"
            <!-- <<<<<<< conflict in `sName[0]`: value is `-&#45;` in ours
            ||||||| base
            (none)
            ======= theirs
            <Value value="-&#45;>">
              <a/>
            </Value>
            >>>>>>> ours follows this comment: choose a version, and remove the comment -->"#]]
        .assert_eq(&text);
    }
}
