//! Code actions at many places of the example cell: what they leave can be read, and has no new errors.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::panic, reason = "a fault of a test may stop it")]

mod editor;
mod execution;
mod refactorings;

use std::collections::BTreeMap;

use editor::Editor;
use val3_analysis::db::FileRange;
use val3_ide::{SourceChange, assists, resolve_assist};
use val3_syntax::{SyntaxKind, TextRange};
use val3_tests::cell;

/// Number of positions that are tested, at equal distances.
const PLACES: usize = 80;

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
    for id in ["extract-program", "inline-program", "switch-to-if", "surround-for", "extract-constant", "toggle-access"]
    {
        assert!(changes.contains_key(id), "`{id}` is offered nowhere: {:?}", changes.keys());
    }
    for (id, changes) in &changes {
        for change in sample(changes, PLACES / 10) {
            let after = editor.after(change);
            assert_eq!(Editor::open(&after).errors(), [] as [String; 0], "`{id}` {change:#?}");
        }
    }
}

#[test]
fn a_switch_goes_there_and_back() {
    let editor = Editor::open(&cell::files("palletiser"));
    let mut returned = 0;
    for place in places(&editor).into_iter().filter(|place| !place.range.is_empty()) {
        let Some(change) = resolve_assist(editor.db(), "switch-to-if", place) else { continue };
        let chain = Editor::open(&editor.after(&change));
        let there = chain.same_place(&editor, FileRange { range: TextRange::empty(place.range.start()), ..place });
        let Some(back) = resolve_assist(chain.db(), "if-to-switch", there) else { continue };
        assert_eq!(Editor::open(&chain.after(&back)).tokens(), editor.tokens(), "{change:#?}");
        returned += 1;
    }
    assert!(returned > 0);
}

#[test]
fn every_change_can_be_read() {
    for name in ["palletiser", "faulty"] {
        let editor = Editor::open(&cell::files(name));
        for (id, changes) in changes(&editor) {
            for change in sample(&changes, PLACES) {
                let (before, after) = editor.faults_of_texts(change);
                assert!(after.len() <= before.len(), "`{id}`: {after:?}\n{change:#?}");
                assert_eq!(editor.lost_comments(change), [] as [String; 0], "`{id}` {change:#?}");
            }
        }
    }
}

#[test]
fn created_items_are_found() {
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
            let (before, after) = (renamed.errors(), after.errors());
            assert!(after.len() <= before.len(), "`{id}`: {before:#?} becomes {after:#?}\n{change:#?}");
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

/// Pieces that break a program in one way or another.
const SLIPS: [&str; 12] = ["", "endIf\n", "if a\n", "\"", "(", "[", "=", ".", "]]>", "<", "call ", "switch"];

/// Numbers without a pattern, the same in every run.
struct Chance(u64);

impl Chance {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).unwrap() % limit.max(1)
    }
}

#[test]
fn broken_programs_are_no_trouble() {
    let cell = cell::files("palletiser");
    let mut chance = Chance(1);
    for _ in 0..60 {
        let mut broken = cell.clone();
        let programs: Vec<usize> = (0..broken.len()).filter(|index| broken[*index].0.ends_with("gx")).collect();
        let (path, bytes) = &mut broken[programs[chance.below(programs.len())]];
        let start = chance.below(bytes.len());
        let end = (start + chance.below(40)).min(bytes.len());
        bytes.splice(start..end, SLIPS[chance.below(SLIPS.len())].bytes());
        let path = path.clone();
        let editor = Editor::open(&broken);
        let file = editor.files().into_iter().find(|file| file.path(editor.db()).as_str().ends_with(&path)).unwrap();
        let places: Vec<FileRange> = places(&editor).into_iter().filter(|place| place.file == file).collect();
        for place in sample(&places, 30) {
            for assist in assists(editor.db(), *place, None) {
                // Edits that overlap, or lie outside of their file, fail here.
                let change = resolve_assist(editor.db(), assist.id, *place).unwrap_or_default();
                editor.after(&change);
            }
        }
    }
}
