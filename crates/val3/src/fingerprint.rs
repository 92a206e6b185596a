//! Unique fingerprints of findings, as services require them.

use std::fmt::Write;

use rustc_hash::FxHashMap;
use sha2::{Digest, Sha256};
use val3_check::fingerprint::Fingerprint;

use crate::report::Finding;

/// Returns one unique fingerprint for each finding, in order. Findings with the same rule on equal lines of a file are
/// numbered. The message is not included, so that a service recognises a finding after an update of the tool.
pub(crate) fn fingerprints(findings: &[Finding]) -> Vec<String> {
    let mut seen: FxHashMap<[&str; 3], usize> = FxHashMap::default();
    let mut hashes = Vec::with_capacity(findings.len());
    for finding in findings {
        let Fingerprint { file, rule, line, .. } = &finding.fingerprint;
        let occurrence = seen.entry([rule, file, line]).or_default();
        *occurrence += 1;
        hashes.push(hash(&format!("{rule}\0{file}\0{line}\0{occurrence}")));
    }
    hashes
}

fn hash(text: &str) -> String {
    Sha256::digest(text).iter().fold(String::new(), |mut hex, byte| {
        // Writing to a string cannot fail.
        let _ = write!(hex, "{byte:02x}");
        hex
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::sample;

    /// Fingerprints of findings on these lines.
    fn of(lines: &[&str]) -> Vec<String> {
        let finding = sample::report().findings.remove(2);
        let found = lines.iter().map(|line| {
            let fingerprint = Fingerprint { line: (*line).to_owned(), ..finding.fingerprint.clone() };
            Finding { fingerprint, ..finding.clone() }
        });
        fingerprints(&found.collect::<Vec<_>>())
    }

    #[test]
    fn equal_lines_have_different_fingerprints() {
        let [first, second, other] = of(&["nCout=1", "nCout=1", "nCout=2"]).try_into().unwrap();
        assert!(first != second && first != other && second != other);
        assert_eq!([first, other], *of(&["nCout=1", "nCout=2"]), "and do not depend on what else there is");
    }

    #[test]
    fn a_fingerprint_does_not_depend_on_the_wording() {
        let mut finding = sample::report().findings.remove(0);
        let before = fingerprints(&[finding.clone()]);
        finding.fingerprint.message = "now it says something else".to_owned();
        assert_eq!(before, fingerprints(&[finding]));
    }
}
