//! File changes on the disk, reported by the client or watched by the server.

use camino::{Utf8Path, Utf8PathBuf};
use notify::event::{EventKind, ModifyKind};
use notify::{Event, RecursiveMode, Watcher as _};
use tower_lsp::lsp_types::notification::{DidChangeWatchedFiles, Notification as _};
use tower_lsp::lsp_types::request::RegisterCapability;
use tower_lsp::lsp_types::{
    DidChangeWatchedFilesParams, DidChangeWatchedFilesRegistrationOptions, FileChangeType, FileSystemWatcher,
    GlobPattern, Registration, RegistrationParams,
};
use val3_analysis::system::{Disk, PathKind, System as _};

use crate::inbox::Inbox;
use crate::server_state::ServerState;
use crate::uri;

/// All files are watched. A moved or deleted folder is reported as one event with any name, and most clients match
/// patterns case-sensitively.
const PATTERN: &str = "**/*";

/// Relevant file extensions: projects, the surrounding cell, configurations, and meshes.
const ENDINGS: [&str; 8] = ["pgx", "dtx", "pjx", "toml", "cfx", "xml", "stl", "glb"];

/// Relevant file extensions in the folder of an application's user pages.
const OF_PAGES: [&str; 2] = ["json", "html"];

/// Kind of a change.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Change {
    /// The contents of the file have changed.
    Content,
    /// The file or folder was created, deleted or moved.
    Existence,
}

/// Starts watching.
pub(crate) fn start(server: &mut ServerState) {
    if server.session.client.watches_files {
        server.outbox.request::<RegisterCapability>(registration());
    } else {
        watch_disk(server);
    }
}

fn registration() -> RegistrationParams {
    let watcher = FileSystemWatcher { glob_pattern: GlobPattern::String(PATTERN.to_owned()), kind: None };
    let options = DidChangeWatchedFilesRegistrationOptions { watchers: vec![watcher] };
    let registration = Registration {
        id: "files".to_owned(),
        method: DidChangeWatchedFiles::METHOD.to_owned(),
        register_options: serde_json::to_value(options).ok(),
    };
    RegistrationParams { registrations: vec![registration] }
}

/// Handles changes reported by the client.
pub(crate) fn changed(server: &mut ServerState, params: DidChangeWatchedFilesParams) {
    let changes = params.changes.iter().filter_map(|event| {
        let is_content = event.typ == FileChangeType::CHANGED;
        Some((uri::path(&event.uri, None)?, if is_content { Change::Content } else { Change::Existence }))
    });
    files_changed(server, changes.collect());
}

/// Handles changed files and folders. For an open document, its text stays in effect.
pub(crate) fn files_changed(server: &mut ServerState, changes: Vec<(Utf8PathBuf, Change)>) {
    for (path, change) in changes {
        if matters(&path) || change == Change::Existence && may_be_folder(server, &path) {
            server.mark_stale(&path);
        }
    }
}

/// Whether the path is or was a folder that may contain files of projects. A deleted folder is recognised by its files.
fn may_be_folder(server: &ServerState, path: &Utf8Path) -> bool {
    match Disk.kind(path) {
        Some(kind) => kind == PathKind::Folder,
        None => path.extension().is_none() || server.has_files_in(path),
    }
}

/// Watches the folders of the workspace if the client does not.
fn watch_disk(server: &mut ServerState) {
    let inbox = server.inbox.clone();
    let watcher = notify::recommended_watcher(move |event: notify::Result<Event>| tell(&inbox, event));
    let mut watcher = match watcher {
        Ok(watcher) => watcher,
        Err(error) => return server.log(&format!("cannot watch for changes on the disk: {error}")),
    };
    for folder in &server.session.folders.clone() {
        if let Err(error) = watcher.watch(folder.as_std_path(), RecursiveMode::Recursive) {
            server.log(&format!("cannot watch for changes in {folder}: {error}"));
        }
    }
    server.watcher = Some(watcher);
}

fn tell(inbox: &Inbox, event: notify::Result<Event>) {
    match event {
        Ok(event) if event.need_rescan() => inbox.post(ServerState::mark_all_stale),
        Ok(event) => {
            let Some(change) = change(event.kind) else { return };
            let paths = event.paths.into_iter().filter_map(|path| Utf8PathBuf::from_path_buf(path).ok());
            let changes: Vec<_> =
                paths.filter(|path| change == Change::Existence || matters(path)).map(|path| (path, change)).collect();
            if !changes.is_empty() {
                inbox.post(move |server| files_changed(server, changes));
            }
        }
        Err(error) => inbox.post(move |server| server.log(&format!("cannot read a change on the disk: {error}"))),
    }
}

/// Change reported by an event; `None` for read access.
fn change(kind: EventKind) -> Option<Change> {
    match kind {
        EventKind::Access(_) => None,
        // Some systems report a folder whenever a file in it changes.
        EventKind::Modify(kind) if !matches!(kind, ModifyKind::Name(_)) => Some(Change::Content),
        _ => Some(Change::Existence),
    }
}

fn matters(path: &Utf8PathBuf) -> bool {
    let Some(extension) = path.extension() else { return false };
    contains(&ENDINGS, extension) || contains(&OF_PAGES, extension) && is_in_pages(path)
}

/// Whether one of the words is `extension`, in any letter case.
fn contains(words: &[&str], extension: &str) -> bool {
    words.iter().any(|word| word.eq_ignore_ascii_case(extension))
}

fn is_in_pages(path: &Utf8Path) -> bool {
    let folder = path.parent().and_then(Utf8Path::file_name);
    folder.is_some_and(|folder| folder.eq_ignore_ascii_case(val3_analysis::pages::FOLDER))
}
