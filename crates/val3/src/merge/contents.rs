//! Merges the bytes of three versions.

use val3_merge::{MergeResult, MergedKind};
use val3_syntax::encoding::{Encoding, decode};
use val3_syntax::foreign::ForeignContent;

/// Result of a merge.
pub(super) struct Outcome {
    /// Content of the merged file.
    pub(super) bytes: Vec<u8>,
    /// Merge of the texts, or the reason why OURS is unchanged.
    pub(super) merged: Result<MergeResult, String>,
}

impl Outcome {
    /// Whether the result contains all changes.
    pub(super) fn is_clean(&self) -> bool {
        self.merged.as_ref().is_ok_and(MergeResult::is_clean)
    }

    /// Reason why the result must not replace a file with this extension; `None` if it may.
    ///
    /// Settings are only marked with XML comments, and only in `.cfx`: lines of marks are no XML, and a controller may read
    /// other files without noticing them.
    pub(super) fn unmarked(&self, kind: MergedKind, extension: &str) -> Option<String> {
        match &self.merged {
            Err(reason) => Some(reason.clone()),
            Ok(_) if kind != MergedKind::Settings => None,
            Ok(MergeResult { by_lines: Some(reason), .. }) => Some(reason.clone()),
            Ok(merged) if merged.is_clean() || extension.eq_ignore_ascii_case("cfx") => None,
            Ok(merged) => merged.conflicts.first().map(ToString::to_string),
        }
    }

    fn unchanged(bytes: &[u8]) -> Self {
        let merged = MergeResult { text: String::new(), conflicts: Vec::new(), moved: Vec::new(), by_lines: None };
        Self { bytes: bytes.to_vec(), merged: Ok(merged) }
    }
}

/// Merges the bytes of BASE, OURS and THEIRS.
pub(super) fn merge(kind: MergedKind, [base, ours, theirs]: &[Vec<u8>; 3]) -> Outcome {
    if base == theirs || ours == theirs {
        return Outcome::unchanged(ours);
    }
    if base == ours {
        return Outcome::unchanged(theirs);
    }
    let refused = |reason| Outcome { bytes: ours.clone(), merged: Err(reason) };
    for (name, bytes) in [("BASE", base), ("OURS", ours), ("THEIRS", theirs)] {
        match ForeignContent::of(bytes) {
            // Both sides have added the file.
            Some(ForeignContent::Empty) if name == "BASE" => {}
            Some(fault) => return refused(format!("{name} is no text of a controller: {fault}")),
            None => {}
        }
    }
    let [base, our_text, theirs] = [base, ours, theirs].map(|bytes| decode(bytes.clone()));
    let merged = val3_merge::merge(kind, &base.text, &our_text.text, &theirs.text);
    let encoding = our_text.encoding;
    if !supports_all(encoding, &merged.text) {
        return refused(format!("OURS is {}, which has not all characters of THEIRS", encoding.name()));
    }
    Outcome { bytes: encoding.encode(&merged.text), merged: Ok(merged) }
}

/// Whether the encoding has all characters of the text, apart from a byte order mark.
fn supports_all(encoding: Encoding, text: &str) -> bool {
    text.chars().all(|character| encoding.supports(character) || character == '\u{feff}')
}

#[cfg(test)]
mod tests {
    use super::*;

    const LATIN: &[u8] = b"<?xml version=\"1.0\" encoding=\"iso-8859-1\"?>\n<a>\n<b name=\"x\" v=\"\xe9\"/>\n<b name=\"y\" v=\"1\"/>\n</a>";

    fn replaced(from: &str, to: &[u8]) -> Vec<u8> {
        let at = LATIN.windows(from.len()).position(|window| window == from.as_bytes()).unwrap();
        [&LATIN[..at], to, &LATIN[at + from.len()..]].concat()
    }

    #[test]
    fn the_encoding_of_ours_is_kept() {
        let theirs = "<a>\n<b name=\"x\" v=\"é\"/>\n<b name=\"y\" v=\"ü\"/>\n</a>".as_bytes().to_vec();
        let ours = replaced("<a>", b"<a w=\"\xe8\">");
        let outcome = merge(MergedKind::Settings, &[LATIN.to_vec(), ours.clone(), theirs]);
        assert!(outcome.is_clean());
        assert!(outcome.bytes.windows(6).any(|window| window == b"v=\"\xfc\"/") && outcome.bytes.contains(&0xe8));
        let chinese = "<a>\n<b name=\"x\" v=\"é\"/>\n<b name=\"y\" v=\"你\"/>\n</a>".as_bytes().to_vec();
        let refused = merge(MergedKind::Settings, &[LATIN.to_vec(), ours.clone(), chinese]);
        assert!(!refused.is_clean() && refused.bytes == ours);
    }

    #[test]
    fn settings_are_not_replaced_by_lines_of_marks() {
        let versions = |value: &str| format!("<a>\n<b name=\"x\" v=\"{value}\"/>\n</a>").into_bytes();
        let contradiction = merge(MergedKind::Settings, &[versions("0"), versions("1"), versions("2")]);
        assert_eq!(contradiction.unmarked(MergedKind::Settings, "CFX"), None);
        assert!(contradiction.unmarked(MergedKind::Settings, "xml").is_some());
        let broken = merge(MergedKind::Settings, &[versions("0"), versions("1"), b"<a".to_vec()]);
        assert!(broken.unmarked(MergedKind::Settings, "cfx").is_some());
        let agreement = merge(MergedKind::Settings, &[versions("0"), versions("1"), versions("0")]);
        assert_eq!(agreement.unmarked(MergedKind::Settings, "xml"), None);
    }

    #[test]
    fn contents_that_are_no_text_are_not_merged() {
        for foreign in [&b""[..], b"\xff\xfe<\0", b"PK\x03\x04"] {
            let outcome = merge(MergedKind::Data, &[b"<a/>".to_vec(), LATIN.to_vec(), foreign.to_vec()]);
            assert!(outcome.bytes == LATIN && outcome.merged.is_err());
        }
    }
}
