//! The first and last messages of a session, which tower-lsp handles itself.

use tower_lsp::jsonrpc::Result;
use tower_lsp::lsp_types::{InitializeParams, InitializeResult, InitializedParams, ServerInfo};
use tower_lsp::{LanguageServer, async_trait};

use crate::inbox::Inbox;
use crate::log::ServerLog;
use crate::parent_process;
use crate::requests::capabilities;
use crate::session::Session;

/// State for the messages that tower-lsp handles itself.
pub(crate) struct Lifecycle {
    pub(crate) inbox: Inbox,
    pub(crate) log: ServerLog,
    pub(crate) version: String,
}

#[async_trait]
impl LanguageServer for Lifecycle {
    async fn initialize(&self, params: InitializeParams) -> Result<InitializeResult> {
        let (session, faults) = Session::new(&params);
        let capabilities = capabilities(&session);
        if let Some(process) = params.process_id {
            parent_process::die_with(process);
        }
        let client = params.client_info.map_or_else(|| "a client".to_owned(), |info| info.name);
        self.inbox.post(move |server| {
            server.log(&format!("{client} opens {:?}, columns in {:?}", session.folders, session.encoding));
            faults.iter().for_each(|fault| server.warn(fault));
            server.begin(session);
        });
        let version = Some(self.version.clone());
        Ok(InitializeResult { capabilities, server_info: Some(ServerInfo { name: "val3".to_owned(), version }) })
    }

    async fn initialized(&self, _: InitializedParams) {}

    async fn shutdown(&self) -> Result<()> {
        // Not through the main loop: the process may end before the loop reads the message.
        self.log.write("the session ends");
        Ok(())
    }
}
