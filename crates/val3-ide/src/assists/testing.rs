//! Test support for assists: the offers at `$0` (or between two `$0`), and the files after a change.

use camino::Utf8Path;
use expect_test::Expect;
use val3_analysis::db::{Db, FileRange, Sources};
use val3_syntax::TextRange;
use val3_test::ROOT;

use super::{Assist, assists, resolve_assist};
use crate::edit::SourceChange;
use crate::testing::MarkedListing;

/// Title of the offered assist; `None` if it is not offered.
pub(super) fn offered(listing: &str, id: &str) -> Option<String> {
    found(listing, id).filter(|assist| assist.disabled.is_none()).map(|assist| assist.title)
}

/// Reason why the assist is disabled; `None` if it is not.
pub(super) fn refused(listing: &str, id: &str) -> Option<String> {
    found(listing, id)?.disabled
}

fn found(listing: &str, id: &str) -> Option<Assist> {
    let marked = MarkedListing::new(listing);
    let place = place(&marked);
    let found = assists(marked.db(), place, None).into_iter().find(|assist| assist.id == id)?;
    let is_done = resolve_assist(marked.db(), id, place).is_some();
    assert_eq!(is_done, found.disabled.is_none(), "`{id}` does what it offers, and nothing else");
    Some(found)
}

/// Checks that the assist is offered, and that its changes are as expected.
pub(super) fn check(id: &str, listing: &str, expected: Expect) {
    expected.assert_eq(&done(listing, id));
}

/// Changes made by an offered assist.
pub(super) fn done(listing: &str, id: &str) -> String {
    let marked = MarkedListing::new(listing);
    let place = place(&marked);
    let found = assists(marked.db(), place, None);
    assert!(
        found.iter().any(|assist| assist.id == id && assist.disabled.is_none()),
        "`{id}` is not offered: {found:?}"
    );
    let change = resolve_assist(marked.db(), id, place).expect("what is offered can be done");
    shown(marked.db(), &change)
}

fn place(marked: &MarkedListing) -> FileRange {
    let at = marked.at();
    let range = marked.selected.unwrap_or(TextRange::empty(at.offset));
    FileRange { file: at.file, range }
}

/// Changed lines, with `-` and `+`, and created, moved or deleted files.
pub(crate) fn shown(db: &dyn Db, change: &SourceChange) -> String {
    let mut shown = String::new();
    for (path, text) in &change.creates {
        shown += &format!("new {}\n", name(path));
        shown += &text.lines().map(|line| format!("+{line}\n")).collect::<String>();
    }
    let mut files: Vec<_> = Sources::get(db).files(db).values().copied().collect();
    files.sort_by_key(|file| file.path(db).clone());
    for file in files {
        let edits: Vec<_> = change.edits.iter().filter(|edit| edit.file == file).collect();
        if edits.is_empty() {
            continue;
        }
        let before = file.text(db);
        let mut after = before.to_string();
        for edit in edits.iter().rev() {
            after.replace_range(std::ops::Range::<usize>::from(edit.range), &edit.text);
        }
        shown += &format!("{}\n{}", name(file.path(db)), difference(before, &after));
    }
    for (from, to) in &change.moves {
        shown += &format!("{} becomes {}\n", name(from), name(to));
    }
    change.deletes.iter().for_each(|path| shown += &format!("{} goes\n", name(path)));
    shown
}

fn name(path: &Utf8Path) -> &str {
    path.strip_prefix(ROOT).unwrap_or(path).as_str()
}

/// Lines between the first and the last difference.
fn difference(before: &str, after: &str) -> String {
    let (before, after): (Vec<_>, Vec<_>) = (before.lines().collect(), after.lines().collect());
    let same = before.iter().zip(&after).take_while(|(a, b)| a == b).count();
    let rest = before[same..].iter().rev().zip(after[same..].iter().rev()).take_while(|(a, b)| a == b).count();
    let gone = before[same..before.len() - rest].iter().map(|line| format!("-{line}\n"));
    let come = after[same..after.len() - rest].iter().map(|line| format!("+{line}\n"));
    gone.chain(come).collect()
}
