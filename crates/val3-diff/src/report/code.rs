//! Programs, and files that were compared as text.

use super::block::{Block, Mark, entry, heading};
use super::changes::arrow;
use super::counts::counted;
use crate::model::{Change, CodeKind, Hunk, ProgramChange, TextChange};

/// Adds the programs that differ. Those of which only the layout or comments differ share a line.
pub(super) fn add(programs: &[ProgramChange], blocks: &mut Vec<Block>) {
    if !programs.is_empty() {
        blocks.push(heading(2, "Programs", ""));
    }
    let (cosmetic, others): (Vec<&ProgramChange>, Vec<&ProgramChange>) =
        programs.iter().partition(|change| is_layout(change));
    others.into_iter().for_each(|change| program(change, blocks));
    let names: Vec<&str> = cosmetic.iter().map(|change| change.name.as_str()).collect();
    if !names.is_empty() {
        blocks.push(entry(Mark::Changed, &names.join(", "), "only the layout of the code differs"));
    }
}

fn is_layout(change: &ProgramChange) -> bool {
    change.change == Change::Changed && change.code.kind == CodeKind::Layout && change.has_same_head()
}

fn program(change: &ProgramChange, blocks: &mut Vec<Block>) {
    let lines = |count: usize| counted(count, "line", "lines");
    let text = match change.change {
        Change::Added => lines(change.code.added),
        Change::Removed => lines(change.code.removed),
        Change::Changed => changed(change),
    };
    blocks.push(entry(change.change.into(), &change.signature, text));
    for (word, pair) in [("was", &change.signatures), ("access", &change.access)] {
        if let Some(pair) = pair {
            let text = if word == "was" { format!("was {}", pair.old) } else { format!("{word} {}", arrow(pair)) };
            blocks.push(entry(Mark::Note, "", text));
        }
    }
    if let Some(listed) = &change.listed {
        let text = if listed.new {
            "the project file lists it now"
        } else {
            "the project file no longer lists it, so it is not part of the application"
        };
        blocks.push(entry(Mark::Note, "", text));
    }
    for local in &change.locals {
        let shown = match (&local.old, &local.new) {
            (Some(old), Some(new)) => format!("local {old} → {new}"),
            (None, Some(new)) => format!("new local {new}"),
            (old, _) => format!("removed local {}", old.as_deref().unwrap_or("")),
        };
        blocks.push(entry(Mark::Note, "", shown));
    }
    if change.description_changed {
        blocks.push(entry(Mark::Note, "", "the description differs"));
    }
    if change.code.syntax_errors.new && !change.code.syntax_errors.old {
        blocks.push(entry(Mark::Warning, "", "the new code has syntax errors; `val3 check` shows them"));
    }
    if change.code.kind != CodeKind::Layout {
        add_hunks(&change.code.hunks, blocks);
    }
}

fn changed(change: &ProgramChange) -> String {
    match change.code.kind {
        CodeKind::Same => "same code".to_owned(),
        CodeKind::Layout => "only the layout of the code differs".to_owned(),
        CodeKind::Comments => "only comments differ".to_owned(),
        CodeKind::Code => format!("+{} −{} lines", change.code.added, change.code.removed),
    }
}

fn add_hunks(hunks: &[Hunk], blocks: &mut Vec<Block>) {
    if !hunks.is_empty() {
        blocks.push(Block::Lines(hunks.iter().map(|hunk| hunk.lines.clone()).collect()));
    }
}

/// Adds files that were compared as text.
pub(super) fn texts(texts: &[TextChange], blocks: &mut Vec<Block>) {
    if !texts.is_empty() {
        blocks.push(heading(2, "Files compared as text", ""));
    }
    texts.iter().for_each(|change| text(change, blocks));
}

/// Adds a file that was compared as text.
pub(super) fn text(change: &TextChange, blocks: &mut Vec<Block>) {
    let is_opaque = change.change == Change::Changed && change.hunks.is_empty();
    let note = if is_opaque { "the bytes differ" } else { "" };
    blocks.push(entry(change.change.into(), &change.path, note));
    add_hunks(&change.hunks, blocks);
}
