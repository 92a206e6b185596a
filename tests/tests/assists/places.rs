//! Ranges at which assists are applied.

use std::collections::BTreeMap;

use val3_analysis::db::{File, FileRange};
use val3_ide::assists;
use val3_syntax::{SyntaxKind, SyntaxNode, TextRange};

use crate::assists::chance::Chance;
use crate::assists::edited_cell::EditedCell;
use crate::assists::editor::is_stmt;

/// Returns every statement, every two neighbours, and every token of the code in a file.
pub(crate) fn places(file: File, tree: &SyntaxNode) -> Vec<FileRange> {
    let mut places = Vec::new();
    let stmts: Vec<_> = tree.descendants().filter(|node| is_stmt(node.kind())).collect();
    for stmt in &stmts {
        places.push(FileRange { file, range: stmt.text_range() });
        if let Some(next) = stmt.next_sibling().filter(|next| is_stmt(next.kind())) {
            places.push(FileRange { file, range: stmt.text_range().cover(next.text_range()) });
        }
    }
    places.extend(cursors(file, tree));
    places
}

/// Returns the start of every token except whitespace.
fn cursors(file: File, tree: &SyntaxNode) -> impl Iterator<Item = FileRange> {
    let tokens = tree.descendants_with_tokens().filter_map(|element| element.into_token());
    let worth = tokens.filter(|token| !matches!(token.kind(), SyntaxKind::WHITESPACE | SyntaxKind::NEWLINE));
    worth.map(move |token| FileRange { file, range: TextRange::empty(token.text_range().start()) })
}

/// Returns the parts of statements.
fn expressions(file: File, tree: &SyntaxNode) -> Vec<FileRange> {
    let code = tree.descendants().filter(|node| node.kind() == SyntaxKind::CODE);
    let nodes = code.flat_map(|code| code.descendants().skip(1)).filter(|node| !is_stmt(node.kind()));
    nodes.map(|node| FileRange { file, range: node.text_range() }).filter(|place| !place.range.is_empty()).collect()
}

/// Ranges of a file, by kind: cursors, selected statements, selected expressions.
type ByKind = [Vec<FileRange>; 3];

fn by_kind(cell: &EditedCell, file: File) -> ByKind {
    let tree = cell.tree(file);
    let (cursors, stmts) = places(file, &tree).into_iter().partition(|place| place.range.is_empty());
    [cursors, stmts, expressions(file, &tree)]
}

/// Draws ranges until each assist has `most` ranges or after `draws` attempts. Returns for each assist the ranges at
/// which it is offered.
pub(crate) fn offering(cell: &EditedCell, draws: usize, most: usize) -> BTreeMap<&'static str, Vec<FileRange>> {
    let mut chance = Chance::new(24);
    let files: Vec<ByKind> = cell.project_files().into_iter().map(|file| by_kind(cell, file)).collect();
    let mut offering: BTreeMap<&'static str, Vec<FileRange>> = BTreeMap::new();
    for _ in 0..draws {
        let kinds = &files[chance.below(files.len())];
        let kind = &kinds[chance.below(kinds.len())];
        let Some(place) = kind.get(chance.below(kind.len())) else { continue };
        for assist in assists(cell.db(), *place, None).into_iter().filter(|assist| assist.disabled.is_none()) {
            let found = offering.entry(assist.id).or_default();
            if found.len() < most && !found.contains(place) {
                found.push(*place);
            }
        }
    }
    offering
}
