//! Conversion of file changes to protocol edits.

use serde_json::json;
use tower_lsp::lsp_types::*;
use val3_analysis::db::{File, FileRange};
use val3_ide::{FileEdit, SourceChange};
use val3_lines::LineIndex;

use super::edits;
use crate::session::ClientCommands;
use crate::snapshot::{Refusal, Snapshot};

/// Reason why the client cannot apply a change, as a sentence for the user.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct ImpossibleChange(&'static str);

impl From<ImpossibleChange> for Refusal {
    fn from(reason: ImpossibleChange) -> Self {
        Self::Because(reason.0.to_owned())
    }
}

/// Converts a change of several files. Clients without support for `documentChanges` receive edits without versions.
///
/// # Errors
/// If the client cannot apply a part of the change, because half a change would leave a broken application.
pub(crate) fn workspace_edit(snapshot: &Snapshot, change: &SourceChange) -> Result<WorkspaceEdit, ImpossibleChange> {
    check(snapshot, change)?;
    let files = by_file(snapshot, change);
    if !snapshot.session.client.has_document_changes {
        let changes = files.into_iter().map(|(file, edits)| (snapshot.uri(file), edits)).collect();
        return Ok(WorkspaceEdit { changes: Some(changes), ..WorkspaceEdit::default() });
    }
    let mut operations = Vec::new();
    for (path, text) in &change.creates {
        operations.extend(creation(snapshot.uri_of(path), text));
    }
    operations.extend(files.into_iter().map(|(file, edits)| edit(snapshot.uri(file), snapshot.version(file), edits)));
    operations.extend(change.moves.iter().map(|(from, to)| {
        let (old_uri, new_uri) = (snapshot.uri_of(from), snapshot.uri_of(to));
        let rename = RenameFile { old_uri, new_uri, options: None, annotation_id: None };
        DocumentChangeOperation::Op(ResourceOp::Rename(rename))
    }));
    operations.extend(change.deletes.iter().map(|path| {
        let delete = DeleteFile { uri: snapshot.uri_of(path), options: None };
        DocumentChangeOperation::Op(ResourceOp::Delete(delete))
    }));
    Ok(WorkspaceEdit { document_changes: Some(DocumentChanges::Operations(operations)), ..WorkspaceEdit::default() })
}

/// Command by which the user replaces a generated name or placeholder; `None` if there is neither or the client has no
/// such command.
pub(crate) fn completion(snapshot: &Snapshot, change: &SourceChange) -> Option<Command> {
    let commands = snapshot.session.commands;
    let name = change.new_name.filter(|_| commands.renames).map(|name| ("Rename", ClientCommands::RENAME, name));
    let placeholder = change.placeholder.filter(|_| commands.selects);
    let placeholder = placeholder.map(|place| ("Select", ClientCommands::SELECT, place));
    let (title, command, FileRange { file, range }) = name.or(placeholder)?;
    let edits = change.edits.iter().filter(|edit| edit.file == file);
    let text = FileEdit::apply_all(file.text(snapshot.db()), edits);
    let index = LineIndex::for_protocol(&text);
    let range = snapshot.lines_of(file, &text, &index).range(range);
    let arguments = vec![json!(snapshot.uri(file)), json!(range)];
    Some(Command { title: title.to_owned(), command: command.to_owned(), arguments: Some(arguments) })
}

fn check(snapshot: &Snapshot, change: &SourceChange) -> Result<(), ImpossibleChange> {
    let can = snapshot.session.client.changes_files;
    if change.edits.iter().any(|edit| !snapshot.is_shown(edit.file)) {
        return Err(ImpossibleChange("the change belongs in a project file, and no project file lists this file"));
    }
    if !change.creates.is_empty() && !can.creates {
        return Err(ImpossibleChange("this editor does not let a language server create files"));
    }
    if !change.moves.is_empty() && !can.renames {
        return Err(ImpossibleChange("this editor does not let a language server rename files"));
    }
    if !change.deletes.is_empty() && !can.deletes {
        return Err(ImpossibleChange("this editor does not let a language server delete files"));
    }
    Ok(())
}

/// Edits by file, in the order of the files' first edits.
fn by_file(snapshot: &Snapshot, change: &SourceChange) -> Vec<(File, Vec<TextEdit>)> {
    let mut files: Vec<(File, Vec<TextEdit>)> = Vec::new();
    for of_file in change.edits.chunk_by(|one, other| one.file == other.file) {
        let Some(file) = of_file.first().map(|edit| edit.file) else { continue };
        let converted = edits(snapshot, file, of_file.iter().map(|edit| (edit.range, edit.text.as_str())));
        match files.iter_mut().find(|(known, _)| *known == file) {
            Some((_, of_file)) => of_file.extend(converted),
            None => files.push((file, converted)),
        }
    }
    files
}

fn edit(uri: Url, version: Option<i32>, edits: Vec<TextEdit>) -> DocumentChangeOperation {
    let text_document = OptionalVersionedTextDocumentIdentifier { uri, version };
    let edits = edits.into_iter().map(OneOf::Left).collect();
    DocumentChangeOperation::Edit(TextDocumentEdit { text_document, edits })
}

/// Operations that create a file and insert its text.
fn creation(uri: Url, text: &str) -> [DocumentChangeOperation; 2] {
    let create = CreateFile { uri: uri.clone(), options: None, annotation_id: None };
    let whole = TextEdit { range: Range::default(), new_text: text.to_owned() };
    [DocumentChangeOperation::Op(ResourceOp::Create(create)), edit(uri, None, vec![whole])]
}
