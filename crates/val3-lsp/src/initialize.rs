//! The end of the handshake: from now on the client can be asked.

use tower_lsp::lsp_types::InitializedParams;

use crate::server_state::ServerState;
use crate::watching;

/// The client is ready to be asked.
pub(crate) fn initialized(server: &mut ServerState, _: InitializedParams) {
    server.ready();
    watching::start(server);
    server.register_for_settings();
    server.ask_for_settings();
}
