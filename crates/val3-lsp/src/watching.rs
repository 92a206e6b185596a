//! Files that change on the disk: the client tells, or the server looks itself.

use camino::Utf8PathBuf;
use notify::{Event, RecursiveMode, Watcher as _};
use tower_lsp::lsp_types::notification::{DidChangeWatchedFiles, Notification as _};
use tower_lsp::lsp_types::request::RegisterCapability;
use tower_lsp::lsp_types::{
    DidChangeWatchedFilesParams, DidChangeWatchedFilesRegistrationOptions, FileSystemWatcher, GlobPattern,
    Registration, RegistrationParams,
};

use crate::inbox::Inbox;
use crate::uri;
use crate::world::World;

/// The files that matter: those of projects, of the cell around them, and configurations.
const PATTERNS: [&str; 3] =
    ["**/*.{pgx,dtx,pjx,PGX,DTX,PJX}", "**/val3.toml", "**/usr/{configs,app,applicom}/**/*.{cfx,xml}"];

/// The endings of these files.
const ENDINGS: [&str; 6] = ["pgx", "dtx", "pjx", "toml", "cfx", "xml"];

/// Begins to watch.
pub(crate) fn start(world: &mut World) {
    if world.session.client.watches_files {
        world.outbox.ask::<RegisterCapability>(registration(), |_, _| {});
    } else {
        watch_disk(world);
    }
}

fn registration() -> RegistrationParams {
    let watchers = PATTERNS
        .iter()
        .map(|pattern| FileSystemWatcher { glob_pattern: GlobPattern::String((*pattern).to_owned()), kind: None });
    let options = DidChangeWatchedFilesRegistrationOptions { watchers: watchers.collect() };
    let registration = Registration {
        id: "files".to_owned(),
        method: DidChangeWatchedFiles::METHOD.to_owned(),
        register_options: serde_json::to_value(options).ok(),
    };
    RegistrationParams { registrations: vec![registration] }
}

/// The client tells which files changed.
pub(crate) fn changed(world: &mut World, params: DidChangeWatchedFilesParams) {
    let paths = params.changes.iter().filter_map(|change| uri::path(&change.uri, None));
    files_changed(world, paths.collect());
}

/// Files changed on the disk. The text of an open document counts all the same.
pub(crate) fn files_changed(world: &mut World, paths: Vec<Utf8PathBuf>) {
    for path in paths {
        if is_of_cell(&path) { world.all_is_stale() } else { world.is_stale(path) }
    }
}

/// A file of the cell, which no file of a project stands for.
fn is_of_cell(path: &Utf8PathBuf) -> bool {
    path.extension().is_some_and(|extension| ["cfx", "xml"].iter().any(|of| extension.eq_ignore_ascii_case(of)))
}

/// Watches the folders of the workspace without the client.
fn watch_disk(world: &mut World) {
    let inbox = world.inbox.clone();
    let watcher = notify::recommended_watcher(move |event: notify::Result<Event>| tell(&inbox, event));
    let mut watcher = match watcher {
        Ok(watcher) => watcher,
        Err(error) => return world.log(&format!("changes on the disk cannot be noticed: {error}")),
    };
    for folder in &world.session.folders.clone() {
        if let Err(error) = watcher.watch(folder.as_std_path(), RecursiveMode::Recursive) {
            world.log(&format!("changes in {folder} cannot be noticed: {error}"));
        }
    }
    world.watcher = Some(watcher);
}

fn tell(inbox: &Inbox, event: notify::Result<Event>) {
    let Ok(event) = event else { return };
    if event.kind.is_access() {
        return;
    }
    let paths: Vec<Utf8PathBuf> =
        event.paths.into_iter().filter_map(|path| Utf8PathBuf::from_path_buf(path).ok()).filter(is_ours).collect();
    if !paths.is_empty() {
        inbox.post(|world| files_changed(world, paths));
    }
}

/// A file that matters, or a folder that may hold some.
fn is_ours(path: &Utf8PathBuf) -> bool {
    path.extension().is_none_or(|extension| ENDINGS.iter().any(|of| extension.eq_ignore_ascii_case(of)))
}
