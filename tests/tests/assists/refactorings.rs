//! Assists that rearrange code: no new errors, no lost comments, and an inverse that restores every byte.

use std::collections::BTreeMap;

use val3_analysis::db::{File, FileRange};
use val3_fmt::Style;
use val3_ide::{SourceChange, assists, resolve_assist};
use val3_syntax::ast::{AstNode as _, Expr};
use val3_syntax::{SyntaxKind, TextRange};
use val3_tests::cell;

use crate::editor::Editor;

/// The assists, each with the one that takes it back and whether that always has to be offered.
const PAIRS: [(&str, &str, bool); 5] = [
    ("extract-variable", "inline-variable", true),
    ("invert-if", "invert-if", true),
    ("split-if", "merge-if", true),
    ("merge-if", "split-if", false),
    ("inline-variable", "extract-variable", false),
];

/// Further assists.
const OTHERS: [&str; 3] = ["extract-variable-all", "add-default", "add-missing-cases"];

/// Every expression, and every line of an `if`.
fn places(editor: &Editor) -> Vec<FileRange> {
    let mut places = Vec::new();
    for file in editor.files() {
        let tree = editor.tree(file);
        let exprs = tree.descendants().filter_map(Expr::cast).map(|expr| expr.syntax().text_range());
        let tokens = tree.descendants_with_tokens().filter_map(|element| element.into_token());
        let words = tokens.filter(|token| {
            matches!(token.kind(), SyntaxKind::IF_KW | SyntaxKind::ELSE_IF_KW | SyntaxKind::ELSE_KW | SyntaxKind::IDENT)
        });
        let words = words.map(|token| TextRange::empty(token.text_range().start()));
        places.extend(exprs.chain(words).map(|range| FileRange { file, range }));
    }
    places
}

/// At most `count` changes of each assist, at equal distances, with their places.
fn changes(editor: &Editor, count: usize) -> BTreeMap<&'static str, Vec<(FileRange, SourceChange)>> {
    let mut offered: BTreeMap<&'static str, Vec<FileRange>> = BTreeMap::new();
    for place in places(editor) {
        let found = assists(editor.db(), place, None).into_iter().filter(|it| it.disabled.is_none());
        found.for_each(|assist| offered.entry(assist.id).or_default().push(place));
    }
    let change = |id: &str, place: &FileRange| Some((*place, resolve_assist(editor.db(), id, *place)?));
    let sampled = |id: &str, places: Vec<FileRange>| {
        let step = places.len().div_ceil(count).max(1);
        places.iter().step_by(step).filter_map(|place| change(id, place)).collect()
    };
    offered.into_iter().map(|(id, places)| (id, sampled(id, places))).collect()
}

/// The place of the inverse in the changed text.
fn place_back(id: &str, place: FileRange, change: &SourceChange) -> FileRange {
    let range = match id {
        // At the name in the new assignment, which is the second edit.
        "extract-variable" => {
            let [declared, assigned, ..] = change.edits.as_slice() else { panic!("{change:?}") };
            let shift = u32::try_from(declared.text.len()).unwrap() - u32::from(declared.range.len());
            TextRange::empty(assigned.range.start() + val3_syntax::TextSize::new(shift))
        }
        _ => TextRange::empty(change.edits.first().unwrap().range.start()),
    };
    FileRange { range, ..place }
}

/// An empty list of locals is written in several ways: only the code is compared.
fn comparable(text: &str) -> &str {
    match text.contains("<localSection/>") || text.contains("<localSection />") || text.contains("<Locals />") {
        true => text.get(text.find("begin").unwrap_or_default()..).unwrap_or_default(),
        false => text,
    }
}

fn check(editor: &mut Editor, count: usize) -> BTreeMap<&'static str, usize> {
    let errors = editor.errors();
    let changes = changes(editor, count);
    let mut restored = BTreeMap::new();
    for (id, found) in &changes {
        let pair = PAIRS.into_iter().find(|(name, ..)| name == id);
        for (place, change) in found.iter().filter(|_| pair.is_some() || OTHERS.contains(id)) {
            assert_eq!(editor.lost_comments(change), [] as [String; 0], "`{id}` {change:#?}");
            assert_eq!(editor.errors_with(change), errors, "`{id}` {change:#?}");
            assert!(keeps_layout(editor, place.file, change), "`{id}` {change:#?}");
            let Some((_, inverse, must)) = pair else { continue };
            let back = there_and_back(editor, id, inverse, *place, change);
            let Some((before, after)) = back else {
                assert!(!must, "`{inverse}` does not follow `{id}`: {change:#?}");
                continue;
            };
            if must && !is_simplified(id, *place, &before) {
                assert_eq!(comparable(&after), comparable(&before), "`{id}` {change:#?}");
            }
            *restored.entry(*id).or_default() += usize::from(comparable(&before) == comparable(&after));
        }
    }
    restored
}

/// A program in the layout of the formatter stays in it.
fn keeps_layout(editor: &mut Editor, file: File, change: &SourceChange) -> bool {
    let is_laid_out = |editor: &Editor| val3_ide::format_file(editor.db(), file, &Style::default()).is_empty();
    if !is_laid_out(editor) {
        return true;
    }
    let before = file.text(editor.db()).to_string();
    editor.set_texts(editor.edited(change));
    let keeps = is_laid_out(editor);
    editor.set_texts(vec![(file, before)]);
    keeps
}

/// `!(…)` loses its parentheses when it is inverted.
fn is_simplified(id: &str, place: FileRange, text: &str) -> bool {
    let line = text.get(usize::from(place.range.start())..).and_then(|rest| rest.lines().next());
    id == "invert-if" && line.is_some_and(|line| line.contains("!(") || line.contains("if!"))
}

/// The text of a file before a change and after the inverse; `None` if that is not offered.
fn there_and_back(
    editor: &mut Editor,
    id: &str,
    inverse: &str,
    place: FileRange,
    change: &SourceChange,
) -> Option<(String, String)> {
    let before = place.file.text(editor.db()).to_string();
    let new: Vec<(File, String)> = editor.edited(change);
    editor.set_texts(new);
    let back = resolve_assist(editor.db(), inverse, place_back(id, place, change));
    let after = back.map(|back| editor.edited(&back));
    editor.set_texts(vec![(place.file, before.clone())]);
    let after = after?.into_iter().find(|(file, _)| *file == place.file)?.1;
    Some((before, after))
}

#[test]
fn the_inverse_restores_every_byte() {
    let mut editor = Editor::open(&cell::files("palletiser"));
    let restored = check(&mut editor, 12);
    for (id, _, must) in PAIRS {
        assert!(!must || restored.get(id).is_some_and(|count| *count > 0), "`{id}`: {restored:?}");
    }
}
