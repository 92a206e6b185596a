//! `workspace/willRenameFiles`, `willCreateFiles`, `willDeleteFiles`, and the notifications that follow them.

use camino::Utf8PathBuf;
use tower_lsp::lsp_types::*;
use val3_ide::SourceChange;

use crate::convert::workspace_edit;
use crate::server_state::ServerState;
use crate::snapshot::{Refusal, Snapshot};
use crate::uri;
use crate::watching::{Change, files_changed};

type EditResult = Result<Option<WorkspaceEdit>, Refusal>;

/// Filters for these requests: files of projects, and folders, because projects move with them.
pub(super) fn capabilities() -> WorkspaceFileOperationsServerCapabilities {
    let files = filter("**/*.{pgx,dtx,pjx}", FileOperationPatternKind::File);
    let folders = filter("**", FileOperationPatternKind::Folder);
    let of_files = FileOperationRegistrationOptions { filters: vec![files.clone()] };
    let of_all = FileOperationRegistrationOptions { filters: vec![files, folders] };
    WorkspaceFileOperationsServerCapabilities {
        will_create: Some(of_files.clone()),
        did_create: Some(of_files.clone()),
        will_rename: Some(of_all.clone()),
        did_rename: Some(of_all.clone()),
        will_delete: Some(of_files),
        did_delete: Some(of_all),
    }
}

fn filter(glob: &str, matches: FileOperationPatternKind) -> FileOperationFilter {
    let options = FileOperationPatternOptions { ignore_case: Some(true) };
    let pattern = FileOperationPattern { glob: glob.to_owned(), matches: Some(matches), options: Some(options) };
    FileOperationFilter { scheme: Some("file".to_owned()), pattern }
}

pub(crate) fn will_rename(snapshot: &Snapshot, params: &RenameFilesParams) -> EditResult {
    let renames = params.files.iter().filter_map(|file| Some((path(&file.old_uri)?, path(&file.new_uri)?)));
    let renames: Vec<_> = renames.collect();
    answer(snapshot, &val3_ide::will_rename_files(snapshot.db(), &renames))
}

pub(crate) fn will_create(snapshot: &Snapshot, params: &CreateFilesParams) -> EditResult {
    let created: Vec<_> = params.files.iter().filter_map(|file| path(&file.uri)).collect();
    answer(snapshot, &val3_ide::will_create_files(snapshot.db(), &created))
}

pub(crate) fn will_delete(snapshot: &Snapshot, params: &DeleteFilesParams) -> EditResult {
    let deleted: Vec<_> = params.files.iter().filter_map(|file| path(&file.uri)).collect();
    answer(snapshot, &val3_ide::will_delete_files(snapshot.db(), &deleted))
}

fn answer(snapshot: &Snapshot, change: &SourceChange) -> EditResult {
    // A change that the client cannot apply must not prevent the file operation.
    Ok(workspace_edit(snapshot, change).ok().filter(|_| !change.is_empty()))
}

pub(crate) fn renamed(server: &mut ServerState, params: RenameFilesParams) {
    let uris = params.files.iter().flat_map(|file| [&file.old_uri, &file.new_uri]);
    changed(server, uris.filter_map(|uri| path(uri)).collect());
}

pub(crate) fn created(server: &mut ServerState, params: CreateFilesParams) {
    changed(server, params.files.iter().filter_map(|file| path(&file.uri)).collect());
}

pub(crate) fn deleted(server: &mut ServerState, params: DeleteFilesParams) {
    changed(server, params.files.iter().filter_map(|file| path(&file.uri)).collect());
}

fn changed(server: &mut ServerState, paths: Vec<Utf8PathBuf>) {
    files_changed(server, paths.into_iter().map(|path| (path, Change::Existence)).collect());
}

fn path(uri: &str) -> Option<Utf8PathBuf> {
    uri::path(&Url::parse(uri).ok()?, None)
}
