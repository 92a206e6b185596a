//! Code actions at many positions in the example cells, which must keep the laws of refactorings.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::panic, reason = "a fault of a test may stop it")]

mod chance;
mod edited_cell;
mod editor;
mod execution;
mod laws;
mod places;
mod public;
mod task_names;

use camino::Utf8PathBuf;
use chance::Chance;
use edited_cell::EditedCell;
use editor::Editor;
use laws::Laws;
use val3_analysis::db::FileRange;
use val3_ide::{SourceChange, assists, resolve_assist};
use val3_syntax::TextRange;
use val3_tests::cell;

/// Assists that are offered somewhere in the palletiser.
const ALWAYS_OFFERED: [&str; 6] =
    ["extract-program", "inline-program", "switch-to-if", "surround-for", "extract-constant", "toggle-access"];

/// Number of tested positions, at equal distances.
const PLACES: usize = 80;

/// Returns the ranges to test in all files of a cell.
fn places(editor: &Editor) -> Vec<FileRange> {
    editor.files().into_iter().flat_map(|file| places::places(file, &editor.tree(file))).collect()
}

fn sample<T>(all: &[T], count: usize) -> impl Iterator<Item = &T> {
    all.iter().step_by(all.len().div_ceil(count).max(1))
}

#[test]
fn the_laws_hold_in_the_examples() {
    for (name, ids) in [("palletiser", ALWAYS_OFFERED.as_slice()), ("faulty", &[])] {
        let files = cell::files(name).into_iter().map(|(path, bytes)| (Utf8PathBuf::from("/").join(path), bytes));
        let mut laws = Laws::of(EditedCell::open(files.collect()));
        let offering = places::offering(&laws.cell, 2500, PLACES / 13);
        for id in ids {
            assert!(offering.contains_key(id), "`{id}` is offered nowhere: {:?}", offering.keys());
        }
        for (id, places) in offering {
            for place in places {
                let outcome = laws.check(id, place);
                let at = &place.file.text(laws.cell.db())[usize::from(place.range.start())..];
                assert_eq!(outcome.failures, [] as [&str; 0], "`{id}` {}", at.lines().next().unwrap_or(""));
            }
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

/// Whether the error is V0101 or V0102: an unknown name or program.
fn is_unknown(error: &str) -> bool {
    error.contains("V0101") || error.contains("V0102")
}

#[test]
fn layout_changes_no_finding() {
    for name in ["palletiser", "faulty"] {
        let editor = Editor::open(&cell::files(name));
        let style = val3_fmt::CodeStyle::default();
        let edits = editor.files().into_iter().flat_map(|file| val3_ide::format_file(editor.db(), file, &style));
        let change = SourceChange { edits: edits.collect(), ..SourceChange::default() };
        let after = Editor::open(&editor.after(&change));
        assert_eq!(after.errors(), editor.errors(), "{name}");
        let again: usize =
            after.files().into_iter().map(|file| val3_ide::format_file(after.db(), file, &style).len()).sum();
        assert_eq!(again, 0, "{name}");
    }
}

/// Pieces that break a program in different ways.
const SLIPS: [&str; 12] = ["", "endIf\n", "if a\n", "\"", "(", "[", "=", ".", "]]>", "<", "call ", "switch"];

#[test]
fn broken_programs_are_no_trouble() {
    let cell = cell::files("palletiser");
    let mut chance = Chance::new(1);
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
                // Edits that overlap, or are outside their file, fail here.
                let change = resolve_assist(editor.db(), assist.id, *place).unwrap_or_default();
                editor.after(&change);
            }
        }
    }
}
