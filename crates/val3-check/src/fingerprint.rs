//! Identity of a finding, independent of the surrounding lines.

use serde::{Deserialize, Serialize};
use val3_analysis::db::{Db, File};
use val3_syntax::TextSlice;

use crate::check::is_once_per_application;
use crate::diagnostic::Diagnostic;

/// Maximum line length in a fingerprint, in characters.
const LINE_LIMIT: usize = 200;

/// Parts of a finding that an edit elsewhere does not change. Baselines and the formats for code scanning services
/// share it.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct Fingerprint {
    /// Path of the file, relative to the folder of the baseline or to the repository's root, with `/`.
    pub file: String,
    /// Code of the rule.
    pub rule: String,
    /// Text of the line, trimmed; for a long line, the part from the marked position on. Empty for a rule that reports
    /// one finding per application.
    pub line: String,
    /// Message. It may change with a version of the tool or with code elsewhere.
    #[serde(default)]
    pub message: String,
}

impl Fingerprint {
    /// Creates the fingerprint of a finding. `path` returns the path of a file relative to the base of the
    /// fingerprints.
    pub fn new(db: &dyn Db, diagnostic: &Diagnostic, path: impl Fn(File) -> String) -> Self {
        let rule = diagnostic.rule.code.to_owned();
        let message = diagnostic.message.clone();
        match diagnostic.application.filter(|_| is_once_per_application(diagnostic.rule)) {
            Some(application) => Self { file: path(application), rule, line: String::new(), message },
            None => {
                let file = diagnostic.place.file;
                let line = line_around(file.text(db), diagnostic.place.range.start().into());
                Self { file: path(file), rule, line, message }
            }
        }
    }
}

/// The line that contains `at`, as stored in fingerprints.
fn line_around(text: &str, at: usize) -> String {
    let (before, behind) = text.split_at_checked(at).unwrap_or((text, ""));
    let start = before.rfind('\n').map_or(0, |end| end + 1);
    let end = before.len() + behind.find('\n').unwrap_or(behind.len());
    let line = trimmed(text.part(start..end));
    if line.chars().nth(LINE_LIMIT).is_none() {
        return line.to_owned();
    }
    trimmed(text.part(at..end)).chars().take(LINE_LIMIT).collect()
}

/// Removes blanks at both ends, and the entity of a line end in escaped code.
fn trimmed(line: &str) -> &str {
    let line = line.trim();
    line.strip_suffix("&#13;").unwrap_or(line).trim_end()
}

#[cfg(test)]
mod tests {
    use super::line_around;

    #[test]
    fn a_fingerprint_contains_the_line_of_the_finding() {
        let text = "one\n  two \r\nthree&#13;\n";
        assert_eq!(["one", "two", "three"], [0, 4, 12].map(|at| line_around(text, at)));
        assert_eq!((line_around(text, 3).as_str(), line_around(text, text.len()).as_str()), ("one", ""));
    }

    #[test]
    fn a_fingerprint_of_a_long_line_contains_the_text_at_the_finding() {
        let line = format!("{}<b/>{}", "<a/>".repeat(60), "<c/>".repeat(60));
        let kept = line_around(&line, line.find("<b/>").unwrap());
        assert!(kept.starts_with("<b/><c/>") && kept.len() == 200, "{kept}");
        assert_eq!(kept, line_around(&format!("<new/>{line}"), line.find("<b/>").unwrap() + 6));
    }
}
