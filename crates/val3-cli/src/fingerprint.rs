//! Fingerprints, by which services know a finding again although lines above it came or went.

use std::fmt::Write;

use rustc_hash::FxHashMap;
use sha2::{Digest, Sha256};

use crate::report::Finding;

/// What a finding is known by: code, file and the text of its first line.
type Mark<'a> = (&'a str, &'a str, &'a str);

/// One fingerprint a finding, in the same order; no two are equal. The same line with the same finding further down
/// the file counts as the next occurrence.
pub(crate) fn fingerprints(findings: &[Finding]) -> Vec<String> {
    let mut seen: FxHashMap<Mark<'_>, usize> = FxHashMap::default();
    let fingerprint = |finding| {
        let mark = mark(finding);
        let occurrence = seen.entry(mark).or_default();
        *occurrence += 1;
        hash(mark, *occurrence)
    };
    findings.iter().map(fingerprint).collect()
}

fn mark(finding: &Finding) -> Mark<'_> {
    let file = &finding.place.file;
    let line = file.lines.line_range(file.lines.line(finding.place.range.start)).unwrap_or_default();
    (finding.code, &file.in_repository, file.text.get(line).unwrap_or_default().trim())
}

fn hash((code, path, line): Mark<'_>, occurrence: usize) -> String {
    let digest = Sha256::digest(format!("{code}\0{path}\0{line}\0{occurrence}"));
    digest.iter().fold(String::new(), |mut hex, byte| {
        // Writing to a string cannot fail.
        let _ = write!(hex, "{byte:02x}");
        hex
    })
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use val3_syntax::encoding::Encoding;

    use super::*;
    use crate::report::{Place, SourceFile, sample};

    /// Findings at each `nCout` of a text.
    fn of(text: &str) -> Vec<String> {
        let file = Arc::new(SourceFile::new("a.pgx", text.into(), Encoding::Utf8));
        let finding = sample::report().findings.remove(2);
        let found = text.match_indices("nCout").map(|(at, name)| {
            let place = Place { file: Arc::clone(&file), range: at..at + name.len() };
            Finding { place, ..finding.clone() }
        });
        fingerprints(&found.collect::<Vec<_>>())
    }

    #[test]
    fn lines_may_move_and_be_indented() {
        assert_eq!(of("  nCout=1\n"), of("// new\n\n    nCout=1\r\n"));
    }

    #[test]
    fn equal_lines_are_told_apart() {
        let twice = of("nCout=1\nnCout=1\n");
        assert_ne!(twice[0], twice[1]);
        assert_eq!(twice[0], of("nCout=1\n")[0]);
        assert_ne!(of("nCout=1"), of("nCout=2"));
    }
}
