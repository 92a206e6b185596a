//! Changes of workspace folders, settings and the trace level.

use std::sync::Arc;

use tower_lsp::lsp_types::{DidChangeConfigurationParams, DidChangeWorkspaceFoldersParams, SetTraceParams, TraceValue};
use val3_analysis::paths::{is_same, normalise};

use crate::options::Options;
use crate::server_state::ServerState;
use crate::session::TraceLevel;
use crate::uri;
use crate::watching;

/// Handles added and removed folders.
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
    server.mark_all_stale();
}

/// Handles changed editor settings. Clients that support `workspace/configuration` send nothing usable here, so the
/// settings are requested.
pub(crate) fn settings_changed(server: &mut ServerState, params: DidChangeConfigurationParams) {
    if server.session.client.has_settings {
        server.ask_for_settings();
    } else {
        let (options, faults) = Options::read_sent(&params.settings);
        server.set_options(options, &faults);
    }
}

/// Handles a changed trace level.
pub(crate) fn trace_set(server: &mut ServerState, params: SetTraceParams) {
    let is_off = params.value == TraceValue::Off;
    Arc::make_mut(&mut server.session).trace = if is_off { TraceLevel::Off } else { TraceLevel::On };
}
