//! Folders that come and go, and settings that change.

use std::sync::Arc;

use tower_lsp::lsp_types::request::{InlayHintRefreshRequest, WorkspaceConfiguration};
use tower_lsp::lsp_types::{
    ConfigurationItem, ConfigurationParams, DidChangeConfigurationParams, DidChangeWorkspaceFoldersParams,
    SetTraceParams, TraceValue,
};
use val3_analysis::paths::{is_same, normalise};

use crate::options::{Options, SECTION};
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

impl ServerState {
    /// Asks the client for the user's settings, if it has some.
    pub(crate) fn ask_for_settings(&mut self) {
        if !self.session.client.has_settings {
            return;
        }
        let item = ConfigurationItem { scope_uri: None, section: Some(SECTION.to_owned()) };
        self.outbox.ask::<WorkspaceConfiguration>(ConfigurationParams { items: vec![item] }, |server, settings| {
            if let Some(settings) = settings.and_then(|settings| settings.into_iter().next()).filter(|it| !it.is_null())
            {
                server.set_options(Options::read(&settings));
            }
        });
    }

    fn set_options(&mut self, (options, faults): (Options, Vec<String>)) {
        faults.iter().for_each(|fault| self.warn(fault));
        if options != self.session.options {
            // How findings get to the client was agreed at the start.
            let delivery = self.session.options.check.delivery;
            let session = Arc::make_mut(&mut self.session);
            session.options = options;
            session.options.check.delivery = delivery;
            self.settings_are_stale();
            if self.session.client.refreshes_hints {
                self.outbox.ask::<InlayHintRefreshRequest>((), |_, _| {});
            }
        }
    }
}
