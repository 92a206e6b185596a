//! Folders that come and go, and settings that change.

use std::sync::Arc;

use tower_lsp::lsp_types::{DidChangeConfigurationParams, DidChangeWorkspaceFoldersParams, SetTraceParams, TraceValue};
use val3_analysis::paths::{is_same, normalise};

use crate::options::Options;
use crate::server_state::ServerState;
use crate::session::Trace;
use crate::uri;
use crate::watching;

/// Folders were added or removed.
pub(crate) fn folders_changed(server: &mut ServerState, params: DidChangeWorkspaceFoldersParams) {
    let session = Arc::make_mut(&mut server.session);
    let path = |uri| uri::path(uri, None).map(|path| normalise(&path));
    for folder in &params.event.removed {
        let removed = path(&folder.uri);
        session.folders.retain(|known| !removed.as_ref().is_some_and(|removed| is_same(known, removed)));
    }
    for added in params.event.added.iter().filter_map(|folder| path(&folder.uri)) {
        if !session.folders.iter().any(|known| is_same(known, &added)) {
            session.folders.push(added);
        }
    }
    if server.watcher.is_some() {
        watching::start(server);
    }
    server.all_is_stale();
}

/// The settings of the editor changed. Clients that can be asked send nothing of use along.
pub(crate) fn settings_changed(server: &mut ServerState, params: DidChangeConfigurationParams) {
    if server.session.client.has_settings {
        server.ask_for_settings();
    } else {
        server.set_options(Options::read_sent(&params.settings));
    }
}

/// The client wants to know more or less.
pub(crate) fn trace_set(server: &mut ServerState, params: SetTraceParams) {
    let is_off = params.value == TraceValue::Off;
    Arc::make_mut(&mut server.session).trace = if is_off { Trace::Off } else { Trace::On };
}
