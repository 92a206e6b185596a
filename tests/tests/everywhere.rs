//! Every editor feature at every position of complete and of broken files: nothing panics, and every range is inside
//! its file.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail loudly")]

use std::sync::Arc;

use camino::Utf8PathBuf;
use salsa::Setter;
use val3_analysis::db::{Database, Db, File, Sources};
use val3_analysis::load::load;
use val3_analysis::system::Memory;
use val3_ide::{
    FilePosition, InlayHintSettings, completions, definition, folds, highlights, hover, implementations, inlay_hints,
    outline, prepare_rename, references, rename, selections, semantic_tokens, signature_help, type_definition,
};
use val3_syntax::{TextRange, TextSize};
use val3_tests::cell;

fn open(name: &str) -> Database {
    let files = cell::files(name).into_iter();
    let system = Memory::new(files.map(|(path, bytes)| (Utf8PathBuf::from("/").join(path), bytes)));
    load(&system, &[Utf8PathBuf::from("/")]).unwrap().db
}

fn files(db: &dyn Db) -> Vec<File> {
    let mut files: Vec<File> = Sources::get(db).files(db).values().copied().collect();
    files.sort_by_key(|file| file.path(db).clone());
    files
}

#[track_caller]
fn assert_inside(db: &dyn Db, file: File, range: TextRange) {
    let text: &str = file.text(db);
    assert!(text.get(std::ops::Range::<usize>::from(range)).is_some(), "{range:?} of {}", file.path(db));
}

fn whole_file(db: &dyn Db, file: File) {
    let whole = TextRange::up_to(TextSize::of(&**file.text(db)));
    folds(db, file).iter().for_each(|fold| assert_inside(db, file, fold.range));
    outline(db, file).iter().for_each(|item| assert_inside(db, file, item.range));
    semantic_tokens(db, file, None).iter().for_each(|token| assert_inside(db, file, token.range));
    for hint in inlay_hints(db, file, whole, &InlayHintSettings::default()) {
        assert_inside(db, file, TextRange::empty(hint.offset));
    }
}

fn position(db: &dyn Db, at: FilePosition) {
    for item in completions(db, at) {
        assert_inside(db, at.file, item.range);
        assert!(item.range.contains_inclusive(at.offset), "{} at {:?}", item.label, at.offset);
        item.additional.iter().for_each(|edit| assert_inside(db, edit.file, edit.range));
    }
    if let Some(found) = hover(db, at) {
        assert_inside(db, at.file, found.range);
        assert!(!found.markdown.is_empty());
    }
    if let Some(help) = signature_help(db, at) {
        let form = help.forms.get(help.active_form).unwrap();
        assert!(form.parameters.iter().all(|(from, to)| form.line.get(*from as usize..*to as usize).is_some()));
    }
    let targets = definition(db, at).into_iter().chain(type_definition(db, at)).chain(implementations(db, at));
    targets.for_each(|target| assert_inside(db, target.to.file, target.to.range));
    highlights(db, at).iter().for_each(|found| assert_inside(db, at.file, found.range));
    let selections = selections(db, at);
    assert!(selections.windows(2).all(|pair| matches!(pair, [inner, outer] if outer.contains_range(*inner))));
}

/// Calls the features that search the entire workspace, at a name.
fn name(db: &dyn Db, at: FilePosition) {
    references(db, at, true).iter().for_each(|place| assert_inside(db, place.file, place.range));
    if prepare_rename(db, at).is_ok() {
        let change = rename(db, at, "zq1").unwrap_or_default();
        change.edits.iter().for_each(|edit| assert_inside(db, edit.file, edit.range));
    }
}

#[test]
fn every_request_works_at_every_position_of_the_sorter() {
    let db = open("faulty");
    for file in files(&db) {
        whole_file(&db, file);
        let text: Arc<str> = Arc::clone(file.text(&db));
        for (offset, _) in text.char_indices() {
            position(&db, FilePosition { file, offset: TextSize::try_from(offset).unwrap() });
        }
        for (offset, _) in text.char_indices().step_by(23) {
            name(&db, FilePosition { file, offset: TextSize::try_from(offset).unwrap() });
        }
    }
}

/// A file that ends at any position, and a file with a missing piece.
#[test]
fn every_request_works_in_broken_files() {
    let mut db = open("palletiser");
    for file in files(&db) {
        let text = file.text(&db).to_string();
        for (offset, _) in text.char_indices().step_by(61) {
            let (head, tail) = text.split_at(offset);
            let skipped = tail.char_indices().nth(17).map_or(tail.len(), |(at, _)| at);
            for broken in [head.to_owned(), format!("{head}{}", tail.split_at(skipped).1)] {
                file.set_text(&mut db).to(Arc::from(broken));
                whole_file(&db, file);
                position(&db, FilePosition { file, offset: TextSize::try_from(offset).unwrap() });
            }
        }
        file.set_text(&mut db).to(Arc::from(text));
    }
}
