//! Server of the usual design, for comparison: shared state in a mutex, asynchronous handlers that await before they
//! lock it, and the message loop of tower-lsp with its limits.

use std::io::{PipeReader, PipeWriter, Read as _};
use std::time::Duration;

use rustc_hash::FxHashMap;
use serde_json::Value;
use tokio::sync::Mutex;
use tower_lsp::jsonrpc::Result;
use tower_lsp::lsp_types::*;
use tower_lsp::{Client, LanguageServer, LspService, Server, async_trait};

use crate::transport::{Intake, Pump, PumpWriter};

struct NaiveServer {
    client: Client,
    versions: Mutex<FxHashMap<Url, i32>>,
}

#[async_trait]
impl LanguageServer for NaiveServer {
    async fn initialize(&self, _: InitializeParams) -> Result<InitializeResult> {
        Ok(InitializeResult::default())
    }

    async fn did_change(&self, params: DidChangeTextDocumentParams) {
        // Simulates a server that parses the text before it updates the state: a longer text takes more time.
        let version = params.text_document.version;
        for _ in 0..(version * 7) % 5 {
            tokio::task::yield_now().await;
        }
        self.versions.lock().await.insert(params.text_document.uri, version);
    }

    async fn shutdown(&self) -> Result<()> {
        Ok(())
    }
}

impl NaiveServer {
    async fn version(&self, params: Value) -> Result<Option<i32>> {
        let uri: Url = serde_json::from_value(params["uri"].clone()).unwrap();
        Ok(self.versions.lock().await.get(&uri).copied())
    }

    async fn panic(&self, _: Value) -> Result<Value> {
        panic!("as it was asked to")
    }

    async fn busy(&self, _: Value) -> Result<bool> {
        std::thread::sleep(Duration::from_millis(200));
        Ok(true)
    }

    async fn ask_client(&self, _: Value) -> Result<Value> {
        let _ = self.client.apply_edit(WorkspaceEdit::default()).await;
        Ok(Value::Null)
    }
}

/// Serves one client.
pub(super) fn serve(mut input: PipeReader, output: PipeWriter) -> u8 {
    let (sender, intake) = Intake::new();
    std::thread::spawn(move || {
        let mut buffer = vec![0; 4096];
        while let Ok(length @ 1..) = input.read(&mut buffer) {
            if sender.unbounded_send(buffer[..length].to_vec()).is_err() {
                return;
            }
        }
    });
    let pump = Pump::start(output, || ()).unwrap();
    let (service, socket) = LspService::build(|client| NaiveServer { client, versions: Mutex::default() })
        .custom_method("test/version", NaiveServer::version)
        .custom_method("test/panic", NaiveServer::panic)
        .custom_method("test/busy", NaiveServer::busy)
        .custom_method("test/askClient", NaiveServer::ask_client)
        .finish();
    let runtime = tokio::runtime::Builder::new_current_thread().build().unwrap();
    runtime.block_on(Server::new(intake, PumpWriter(pump), socket).serve(service));
    0
}
