//! Applications from listings, and their differences as text.

use val3_diff::format::human;
use val3_diff::report::Detail;
use val3_diff::{Comparison, FileTree, compare};
use val3_test::Fixture;

/// Returns the files of a listing as a tree.
pub(crate) fn tree(listing: &str) -> FileTree {
    FileTree::new(Fixture::parse(listing).files)
}

/// Returns the differences between two listings.
pub(crate) fn compared(old: &str, new: &str) -> Comparison {
    compare(&tree(old), &tree(new))
}

/// Formats the report for people, without colours.
pub(crate) fn human(comparison: &Comparison) -> String {
    let lines = human::lines(comparison, Detail::Full);
    let line = |line: &human::StyledLine| line.iter().map(|(_, text)| text.as_str()).collect::<String>();
    lines.iter().map(|texts| line(texts).trim_end().to_owned() + "\n").collect()
}

/// Compares two listings and checks the report.
#[track_caller]
pub(crate) fn check(old: &str, new: &str, expected: &expect_test::Expect) {
    expected.assert_eq(&human(&compared(old, new)));
}
