//! Code actions at many places of the example cell: what they leave can be read, and has no new errors.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::panic, reason = "a fault of a test may stop it")]

mod editor;

use std::collections::BTreeMap;

use editor::Editor;
use val3_ide::{FileRange, SourceChange, assists, resolve_assist};
use val3_syntax::{SyntaxKind, TextRange};
use val3_tests::cell;

/// Of all places, so many; the others are left out at equal distances.
const PLACES: usize = 80;

/// What takes something away that other projects may use.
const CHANGES_INTERFACE: &str = "toggle-access";

/// Every statement, every two neighbours, and every token of the code of the cell.
fn places(editor: &Editor) -> Vec<FileRange> {
    let mut places = Vec::new();
    for file in editor.files() {
        let tree = editor.tree(file);
        let stmts: Vec<_> = tree.descendants().filter(|node| editor::is_stmt(node.kind())).collect();
        for stmt in &stmts {
            places.push(FileRange { file, range: stmt.text_range() });
            if let Some(next) = stmt.next_sibling().filter(|next| editor::is_stmt(next.kind())) {
                places.push(FileRange { file, range: stmt.text_range().cover(next.text_range()) });
            }
        }
        let tokens = tree.descendants_with_tokens().filter_map(|element| element.into_token());
        let worth = tokens.filter(|token| !matches!(token.kind(), SyntaxKind::WHITESPACE | SyntaxKind::NEWLINE));
        places.extend(worth.map(|token| FileRange { file, range: TextRange::empty(token.text_range().start()) }));
    }
    places
}

/// Each assist that is offered somewhere, with the changes it makes at different places.
fn changes(editor: &Editor) -> BTreeMap<&'static str, Vec<SourceChange>> {
    let mut changes: BTreeMap<&'static str, Vec<SourceChange>> = BTreeMap::new();
    for place in places(editor) {
        for assist in assists(editor.db(), place, None) {
            let change = resolve_assist(editor.db(), assist.id, place);
            let found = changes.entry(assist.id).or_default();
            found.extend(change.filter(|change| !found.contains(change)));
        }
    }
    changes
}

fn sample<T>(all: &[T], count: usize) -> impl Iterator<Item = &T> {
    all.iter().step_by(all.len().div_ceil(count).max(1))
}

#[test]
fn no_assist_adds_an_error() {
    let editor = Editor::open(&cell::files("palletiser"));
    assert_eq!(editor.errors(), [] as [String; 0]);
    let changes = changes(&editor);
    for id in ["extract-program", "inline-program", "if-to-switch", "switch-to-if", "surround-for", "extract-constant"]
    {
        assert!(changes.contains_key(id), "`{id}` is offered nowhere: {:?}", changes.keys());
    }
    for (id, changes) in changes.iter().filter(|(id, _)| **id != CHANGES_INTERFACE) {
        for change in sample(changes, PLACES / 10) {
            let after = editor.after(change);
            assert_eq!(Editor::open(&after).errors(), [] as [String; 0], "`{id}` {change:#?}");
        }
    }
}

#[test]
fn every_change_can_be_read() {
    for name in ["palletiser", "faulty"] {
        let editor = Editor::open(&cell::files(name));
        for (id, changes) in changes(&editor) {
            for change in sample(&changes, PLACES) {
                let (before, after) = editor.faults_of_texts(change);
                assert!(after.len() <= before.len(), "`{id}`: {after:?}\n{change:#?}");
            }
        }
    }
}

#[test]
fn what_is_created_is_known() {
    let cell = cell::files("palletiser");
    let editor = Editor::open(&cell);
    let mut created = 0;
    let mut cursors = places(&editor);
    cursors.retain(|place| place.range.is_empty() && editor.is_name(*place));
    for place in sample(&cursors, PLACES / 3) {
        let renamed = editor.with_unknown_name(*place);
        let place = renamed.same_place(&editor, *place);
        for id in ["create-local", "create-parameter", "create-global", "create-program"] {
            let Some(change) = resolve_assist(renamed.db(), id, place) else { continue };
            let after = Editor::open(&renamed.after(&change));
            let unknown: Vec<String> = after
                .errors()
                .into_iter()
                .filter(|error| error.contains(editor::UNKNOWN) && is_unknown(error))
                .collect();
            assert!(unknown.is_empty(), "`{id}`: {unknown:?}\n{change:#?}");
            created += 1;
        }
    }
    assert!(created > 10, "only {created} were created");
}

/// V0101 and V0102: an unknown name, an unknown program.
fn is_unknown(error: &str) -> bool {
    error.contains("V0101") || error.contains("V0102")
}

#[test]
fn layout_changes_no_finding() {
    for name in ["palletiser", "faulty"] {
        let editor = Editor::open(&cell::files(name));
        let style = val3_fmt::Style::default();
        let edits = editor.files().into_iter().flat_map(|file| val3_ide::format_file(editor.db(), file, &style));
        let change = SourceChange { edits: edits.collect(), ..SourceChange::default() };
        let after = Editor::open(&editor.after(&change));
        assert_eq!(after.errors(), editor.errors(), "{name}");
        let again: usize =
            after.files().into_iter().map(|file| val3_ide::format_file(after.db(), file, &style).len()).sum();
        assert_eq!(again, 0, "{name}");
    }
}
