//! Assists on programs that are executed: a program prints the same before and after an assist.

mod choices;
mod program;

use std::collections::BTreeMap;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::db::{FileRange, Sources};
use val3_analysis::items::parse;
use val3_analysis::load::{Workspace, load};
use val3_analysis::system::Memory;
use val3_ide::{SourceChange, resolve_assist};
use val3_syntax::{SyntaxKind, SyntaxNode, TextRange};
use val3_test::{Fixture, ROOT};
use val3_tests::running::Running;

use choices::Choices;

/// Assists whose purpose is to change the behaviour. A missing case gets its value from `default`, for the user to
/// complete.
const CHANGE_BEHAVIOUR: [&str; 5] =
    ["surround-while", "surround-for", "surround-if", "wait-for-arm", "add-missing-cases"];

/// Number of ranges in a program at which all assists are applied.
const PLACES: usize = 4;

/// Largest duration of a program on the controller, in s; a program without a fault needs a hundredth.
const SECONDS: u32 = 1;

/// Files of a cell, by path in the folder of the fixture.
type Files = BTreeMap<Utf8PathBuf, String>;

/// Writes a program according to `bytes`, and applies every assist at some ranges in it.
pub fn assists(bytes: &[u8]) {
    let mut choices = Choices::new(bytes);
    let files: Files = Fixture::parse(&program::listing(&mut choices))
        .files
        .into_iter()
        .map(|(path, text)| (path.into(), text))
        .collect();
    let before = printed(&files).unwrap_or_else(|fault| panic!("the program has faults: {fault}\n{}", shown(&files)));
    let workspace = workspace(&files);
    let places = places(&workspace);
    for _ in 0..PLACES {
        let place = places[choices.below(places.len())];
        let offered = val3_ide::assists(&workspace.db, place, None);
        let ids = offered.into_iter().filter(|assist| assist.disabled.is_none()).map(|assist| assist.id);
        for id in ids.filter(|id| !CHANGE_BEHAVIOUR.contains(id)) {
            check(&workspace, &files, place, id, &before);
        }
    }
}

fn check(workspace: &Workspace, files: &Files, place: FileRange, id: &str, before: &str) {
    let offset = usize::from(place.range.start())..usize::from(place.range.end());
    let selected = &place.file.text(&workspace.db)[offset];
    let at = || format!("`{id}` at {:?} {selected:?} of {}", place.range, place.file.path(&workspace.db));
    let Some(change) = resolve_assist(&workspace.db, id, place) else { panic!("{} changes nothing", at()) };
    let changed = changed(workspace, files, &change).unwrap_or_else(|fault| panic!("{}: {fault}", at()));
    match printed(&changed) {
        Ok(after) if after == before => {}
        Ok(after) => {
            panic!("{} prints\n{after}instead of\n{before}before\n{}after\n{}", at(), shown(files), shown(&changed))
        }
        Err(fault) => panic!("{} has a fault: {fault}\nbefore\n{}after\n{}", at(), shown(files), shown(&changed)),
    }
}

fn workspace(files: &Files) -> Workspace {
    let files = files.iter().map(|(path, text)| (absolute(path), text.clone().into_bytes()));
    load(&Memory::new(files), &[Utf8PathBuf::from(ROOT)]).unwrap_or_else(|error| panic!("{error:?}"))
}

fn absolute(path: &Utf8Path) -> Utf8PathBuf {
    Utf8Path::new(ROOT).join(path)
}

/// Returns the application's output, with the numbers of run-time errors; the error is the first fault that prevents
/// execution.
fn printed(files: &Files) -> Result<String, String> {
    let fixture: String = files.iter().map(|(path, text)| fixture_part(path, text)).collect();
    Ok(Running::try_start(&fixture)?.for_seconds(SECONDS).printed())
}

/// Formats a file as a part of a fixture.
fn fixture_part(path: &Utf8Path, text: &str) -> String {
    format!("=== {}\n{}\n", path.as_str().trim_start_matches("usrapp/"), text.trim_end())
}

/// Returns the code of the programs.
fn shown(files: &Files) -> String {
    let programs = files.iter().filter(|(path, _)| path.extension() == Some("pgx"));
    programs.map(|(path, text)| format!("--- {path}\n{text}\n")).collect()
}

/// Returns the ranges of every statement and expression, every two neighbours, and every word of the programs.
fn places(workspace: &Workspace) -> Vec<FileRange> {
    let db = &workspace.db;
    let mut files: Vec<_> = Sources::get(db).files(db).values().copied().collect();
    files.retain(|file| file.path(db).extension() == Some("pgx"));
    files.sort_by_key(|file| file.path(db).clone());
    let mut places = Vec::new();
    for file in files {
        let root = parse(db, file).root();
        let Some(code) = root.descendants().find(|node| node.kind() == SyntaxKind::CODE) else { continue };
        let mut add = |range: TextRange| places.push(FileRange { file, range });
        for node in code.descendants().skip(1) {
            add(node.text_range());
            let next = node.next_sibling().filter(|next| next.text_range().start() > node.text_range().end());
            next.into_iter().for_each(|next| add(node.text_range().cover(next.text_range())));
        }
        words(&code).for_each(|start| add(TextRange::empty(start)));
    }
    places
}

fn words(code: &SyntaxNode) -> impl Iterator<Item = val3_syntax::TextSize> {
    let tokens = code.descendants_with_tokens().filter_map(|element| element.into_token());
    tokens.filter(|token| !token.kind().is_trivia()).map(|token| token.text_range().start())
}

/// Applies a change to the files. Edits have to be sorted, and must not overlap.
fn changed(workspace: &Workspace, files: &Files, change: &SourceChange) -> Result<Files, String> {
    let relative = |path: &Utf8Path| path.strip_prefix(ROOT).map(Utf8Path::to_owned).map_err(|error| error.to_string());
    let mut changed = files.clone();
    for (path, text) in &change.creates {
        if changed.insert(relative(path)?, text.clone()).is_some() {
            return Err(format!("the new file {path} exists"));
        }
    }
    for pair in change.edits.windows(2) {
        if pair[0].file == pair[1].file && pair[0].range.end() > pair[1].range.start() {
            return Err(format!("the edits overlap: {pair:?}"));
        }
    }
    for edit in change.edits.iter().rev() {
        let path = relative(edit.file.path(&workspace.db))?;
        let text = changed.get_mut(&path).ok_or_else(|| format!("{path} is edited and does not exist"))?;
        text.replace_range(std::ops::Range::<usize>::from(edit.range), &edit.text);
    }
    for (from, to) in &change.moves {
        let text = changed.remove(&relative(from)?).ok_or_else(|| format!("{from} moves and does not exist"))?;
        changed.insert(relative(to)?, text);
    }
    for path in &change.deletes {
        changed.remove(&relative(path)?);
    }
    Ok(changed)
}
