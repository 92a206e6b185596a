//! Opening, changing, saving and closing of documents.

use std::sync::Arc;

use camino::Utf8Path;
use tower_lsp::lsp_types::{
    DidChangeTextDocumentParams, DidCloseTextDocumentParams, DidOpenTextDocumentParams, DidSaveTextDocumentParams,
};
use val3_analysis::load::{loads_alike, names_meshes_alike};

use crate::documents::Document;
use crate::server_state::ServerState;
use crate::uri;

/// Adds an opened document, whose text replaces the stored file.
pub(crate) fn opened(server: &mut ServerState, params: DidOpenTextDocumentParams) {
    // Some clients open documents without sending `initialized`.
    server.ready();
    let item = params.text_document;
    let Some(path) = uri::path(&item.uri, Some(&item.language_id)) else {
        return server.log(&format!("{} has no path in UTF-8", item.uri));
    };
    let text: Arc<str> = item.text.into();
    let document = Document { uri: item.uri, path: path.clone(), version: item.version, text: Arc::clone(&text) };
    Arc::make_mut(&mut server.documents).open(document);
    let file = server.file(&path);
    server.edited(file, &text);
    match file {
        // An editor shows a stored file without its byte order mark. That difference does not invalidate references.
        Some(file) if !shapes_workspace(&path) && !server.is_unreadable(file) => server.checks.edited(file),
        _ => server.mark_stale(&path),
    }
}

/// Applies changes to a document.
pub(crate) fn changed(server: &mut ServerState, params: DidChangeTextDocumentParams) {
    let encoding = server.session.encoding;
    let uri = params.text_document.uri;
    let Some(document) = Arc::make_mut(&mut server.documents).get_mut(&uri) else {
        return server.log(&format!("{uri} was changed but is not open"));
    };
    if params.text_document.version <= document.version {
        let known = document.version;
        return server.log(&format!("{uri}: version {} comes after {known}", params.text_document.version));
    }
    let before = Arc::clone(&document.text);
    document.change(params.content_changes, encoding);
    document.version = params.text_document.version;
    let (path, text) = (document.path.clone(), Arc::clone(&document.text));
    if !server.documents.get(&uri).is_some_and(|document| server.documents.is_effective(document)) {
        return;
    }
    let file = server.file(&path);
    server.edited(file, &text);
    let loads_alike = if is_table(&path) { names_meshes_alike(&before, &text) } else { loads_alike(&before, &text) };
    if file.is_none() || shapes_workspace(&path) || !loads_alike {
        server.mark_stale(&path);
    }
}

/// Marks the file of a saved document to be read again: its text is known, but its stored encoding may have changed.
pub(crate) fn saved(server: &mut ServerState, params: DidSaveTextDocumentParams) {
    let path = server.documents.get(&params.text_document.uri).map(|document| document.path.clone());
    path.iter().for_each(|path| server.mark_stale(path));
}

/// Removes a closed document; the stored file is in effect again.
pub(crate) fn closed(server: &mut ServerState, params: DidCloseTextDocumentParams) {
    let Some(document) = Arc::make_mut(&mut server.documents).close(&params.text_document.uri) else { return };
    server.published.closed(&document);
    if let Some(file) = server.file(&document.path) {
        server.checks.edited(file);
    }
    server.mark_stale(&document.path);
}

/// Whether the file determines which other files belong to the workspace.
pub(crate) fn shapes_workspace(path: &Utf8Path) -> bool {
    let is_manifest = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("pjx"));
    is_manifest || path.file_name().is_some_and(|name| name.eq_ignore_ascii_case(val3_config::FILE_NAME))
}

/// Whether the file is a TOML file: a `cell.toml`, or a configuration.
fn is_table(path: &Utf8Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml"))
}
