//! `initialized`: the end of the handshake, after which the server may send requests.

use tower_lsp::lsp_types::InitializedParams;

use crate::server_state::ServerState;
use crate::watching;

/// Marks the client as initialized, registers file watchers and requests the settings.
pub(crate) fn initialized(server: &mut ServerState, _: InitializedParams) {
    server.ready();
    watching::start(server);
    server.register_for_settings();
    server.ask_for_settings();
}
