//! Arguments of calls after a change of the parameters.

use val3_analysis::db::Db;
use val3_analysis::items::program::header;
use val3_syntax::ast::{AstNode as _, Expr};
use val3_syntax::{SyntaxKind, TextRange, text_at};

use super::calls::Call;
use super::slots::{ListSlot, Removal, SlotEdit, Slots};
use super::variables::NewParameter;
use crate::RefactoringError;
use crate::edit::FileEdit;
use crate::xml_list::escaped;

/// Edits of a call, and the arguments that it no longer passes.
pub(super) struct NewArguments {
    pub(super) edits: Vec<FileEdit>,
    pub(super) removed: Vec<TextRange>,
}

/// Edits that pass arguments for the new parameters. `renames` are other edits of the file; those inside an argument
/// move with it.
///
/// # Errors
/// If an argument's side effect would be lost or happen in another order.
pub(super) fn edits(
    db: &dyn Db,
    call: &Call,
    wanted: &[NewParameter],
    renames: &[FileEdit],
) -> Result<NewArguments, RefactoringError> {
    keeps_effects(db, call, wanted)?;
    let places = call.places(db);
    let order: Vec<ListSlot> = wanted.iter().map(|new| entry(call, new)).collect();
    if places.is_empty() {
        let added: Vec<&str> = order.iter().filter_map(ListSlot::added).collect();
        let text = added.join(call.separator(db));
        let edit = FileEdit { file: call.file, range: TextRange::empty(call.end), text };
        return Ok(NewArguments { edits: vec![edit], removed: Vec::new() });
    }
    let inside = |edit: &&FileEdit| edit.file == call.file && places.iter().any(|it| it.contains_range(edit.range));
    let inner: Vec<SlotEdit> = renames.iter().filter(inside).map(|edit| (edit.range, edit.text.clone())).collect();
    let slots = Slots {
        text: call.file.text(db),
        entries: &places,
        inner: &inner,
        separator: call.separator(db),
        removal: Removal::Separator,
    };
    let edits = slots.edits(&order).into_iter();
    let edits = edits.map(|(range, text)| FileEdit { file: call.file, range, text }).collect();
    let removed = (0..).zip(&places).filter(|(index, _)| !order.contains(&ListSlot::Kept(*index)));
    Ok(NewArguments { edits, removed: removed.map(|(_, place)| *place).collect() })
}

fn entry(call: &Call, new: &NewParameter) -> ListSlot {
    match new.from {
        Some(index) => ListSlot::Kept(index),
        None if call.is_escaped => ListSlot::Added(escaped(new.argument.trim())),
        None => ListSlot::Added(new.argument.trim().to_owned()),
    }
}

/// Checks that arguments with side effects are still passed, in the same order.
fn keeps_effects(db: &dyn Db, call: &Call, wanted: &[NewParameter]) -> Result<(), RefactoringError> {
    let acting = call.with_effects(db);
    let Some(first) = acting.first() else { return Ok(()) };
    let kept: Vec<usize> = wanted.iter().filter_map(|new| new.from).collect();
    let caller = &header(db, call.file).name;
    if let Some(removed) = acting.iter().find(|index| !kept.contains(index)) {
        let argument = argument_text(db, call, *removed);
        return Err(format!("the argument `{argument}` of a call in `{caller}` has an effect").into());
    }
    if !kept.is_sorted() {
        let argument = argument_text(db, call, *first);
        return Err(format!(
            "the argument `{argument}` of a call in `{caller}` has an effect, so the order of its arguments matters"
        )
        .into());
    }
    Ok(())
}

fn argument_text<'db>(db: &'db dyn Db, call: &Call, index: usize) -> &'db str {
    let place = call.places(db).get(index).copied().unwrap_or_default();
    text_at(call.file.text(db), place)
}

/// Checks that the expression that callers pass is a single expression on one line.
pub(super) fn check(new: &NewParameter) -> Result<(), RefactoringError> {
    let argument = new.argument.trim();
    if argument.is_empty() {
        return Err(format!("calls need an expression to pass for the new parameter `{}`", new.name).into());
    }
    let code =
        format!("<Programs><Program name=\"p\"><Code>begin\n{}\nend</Code></Program></Programs>", call(argument));
    let parse = val3_syntax::parse(&code);
    let root = parse.root();
    let call = root.descendants().find(|node| node.kind() == SyntaxKind::CALL_EXPR);
    let list = call.and_then(|call| call.children().find(|node| node.kind() == SyntaxKind::ARG_LIST));
    let count = list.map_or(0, |list| list.children().filter_map(Expr::cast).count());
    let is_one = parse.errors().is_empty() && count == 1 && !argument.contains(['\n', '\r']);
    let is_plain = !argument.contains("//") && !argument.contains("]]>");
    if is_one && is_plain { Ok(()) } else { Err(format!("`{argument}` is no expression").into()) }
}

fn call(argument: &str) -> String {
    format!("call p({})", escaped(argument))
}
