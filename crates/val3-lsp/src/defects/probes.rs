//! This server with additional requests that stress it.

use std::io::{PipeReader, PipeWriter};

use salsa::Database as _;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use tower_lsp::lsp_types::Url;
use tower_lsp::lsp_types::notification::Notification;
use tower_lsp::lsp_types::request::{Request, WorkspaceFoldersRequest};
use val3_analysis::db::Db as _;

use crate::job::OnEdit::{Refuse, Retry};
use crate::pool::Priority::Latency;
use crate::requests::routes;
use crate::server::{ServerOptions, serve};
use crate::snapshot::{Refusal, Snapshot};

#[derive(Serialize, Deserialize)]
pub(super) struct DocumentParams {
    uri: Url,
    #[serde(default)]
    version: i32,
}

macro_rules! messages {
    ($($kind:ident $name:ident($params:ty) $(-> $result:ty)? = $method:literal;)*) => {
        $(
            pub(super) enum $name {}

            impl $kind for $name {
                type Params = $params;
                $(type Result = $result;)?
                const METHOD: &'static str = $method;
            }
        )*
    };
}

messages! {
    Request Version(DocumentParams) -> Option<i32> = "test/version";
    Request Panic(Value) -> Value = "test/panic";
    Request Spin(Value) -> Value = "test/spin";
    Request SpinUntilEdit(DocumentParams) -> Option<i32> = "test/spinUntilEdit";
    Request Trees(Value) -> usize = "test/trees";
    Request Echo(Value) -> Value = "test/echo";
    Notification PanicNow(Value) = "test/panicNow";
    Notification AskClient(Value) = "test/askClient";
    Notification Spinning(Value) = "test/spinning";
}

/// Serves one client.
pub(super) fn probed(input: PipeReader, output: PipeWriter) -> u8 {
    let mut routes = routes();
    routes.on::<Version>(Latency, Refuse, version);
    routes.on::<Panic>(Latency, Refuse, |_, _| panic!("as it was asked to"));
    routes.on::<Spin>(Latency, Refuse, |snapshot, _| spin(snapshot));
    routes.on::<SpinUntilEdit>(Latency, Retry, |snapshot, asked| {
        if version(snapshot, asked)? == Some(asked.version) { version(snapshot, asked) } else { spin(snapshot) }
    });
    routes.on::<Trees>(Latency, Refuse, |snapshot, _| Ok(snapshot.db.trees().count()));
    routes.on::<Echo>(Latency, Refuse, |_, params| Ok(params.clone()));
    routes.notify::<PanicNow>(|_, _| panic!("as it was asked to"));
    routes.notify::<AskClient>(|server, _| _ = server.outbox.request::<WorkspaceFoldersRequest>(()));
    serve(input, output, &ServerOptions::default(), routes).unwrap()
}

fn version(snapshot: &Snapshot, asked: &DocumentParams) -> Result<Option<i32>, Refusal> {
    Ok(snapshot.documents.get(&asked.uri).map(|document| document.version))
}

/// Computes until it is cancelled.
fn spin<T>(snapshot: &Snapshot) -> Result<T, Refusal> {
    snapshot.outbox.notify::<Spinning>(Value::Null);
    loop {
        snapshot.db.unwind_if_revision_cancelled();
        std::thread::sleep(std::time::Duration::from_micros(100));
    }
}
