//! Random merges: the result equals a simple model's result or is a conflict, and no change is lost.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::panic, reason = "a test may fail loudly")]

mod data;
mod lists;

use quick_xml::events::Event;
use val3_merge::{MergeResult, MergedKind, merge};

/// Merges three versions and checks properties that hold for every merge.
pub(crate) fn checked(kind: MergedKind, [base, ours, theirs]: [&str; 3]) -> MergeResult {
    for side in [ours, theirs] {
        assert_eq!(merge(kind, base, base, side).text, side);
        assert_eq!(merge(kind, base, side, base).text, side);
        assert_eq!(merge(kind, base, side, side).text, side);
    }
    let merged = merge(kind, base, ours, theirs);
    assert_eq!(merged.by_lines, None);
    assert_well_formed(&merged.text);
    let other = merge(kind, base, theirs, ours);
    assert_eq!(merged.is_clean(), other.is_clean(), "{}\n{}", merged.text, other.text);
    merged
}

/// Checks with another XML parser that a text is well-formed.
fn assert_well_formed(text: &str) {
    let mut reader = quick_xml::Reader::from_str(text);
    reader.config_mut().check_comments = true;
    let mut depth = 0;
    loop {
        match reader.read_event().unwrap_or_else(|error| panic!("{error}\n{text}")) {
            Event::Start(start) => {
                start.attributes().for_each(|attribute| _ = attribute.unwrap());
                depth += 1;
            }
            Event::End(_) => depth -= 1,
            Event::Eof => break,
            _ => {}
        }
    }
    assert_eq!(depth, 0, "{text}");
}
