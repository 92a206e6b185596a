//! Language server for VAL 3.
//!
//! tower-lsp only transports messages. Every message enters one inbox in the order in which it was read. One thread,
//! the main loop, processes the inbox and is the only writer of the database. Slow requests are computed on snapshots
//! by a thread pool. `docs/adr/0010-language-server.md` gives the reasons.

#![allow(clippy::disallowed_methods, reason = "a server has threads, a clock and a process to watch")]

mod checks;
mod convert;
mod detached;
mod display_cache;
mod documents;
mod inbox;
mod initialize;
mod job;
mod lifecycle;
mod lines;
mod log;
mod options;
mod outbox;
mod overlay;
mod panics;
mod parent;
mod parent_process;
mod pool;
mod progress;
mod published;
mod reply;
mod requests;
mod router;
mod routes;
mod schema;
mod server;
mod server_state;
mod session;
mod snapshot;
mod sync;
mod transport;
mod uri;
mod watching;
mod workspace_folders;

pub use requests::server_requests_schema;
pub use server::{ServerOptions, run};

#[cfg(test)]
extern crate self as val3_lsp;
#[cfg(test)]
#[path = "../tests/it/client.rs"]
#[allow(dead_code, unreachable_pub, missing_docs, reason = "the tests of whole sessions use the rest")]
mod client;
#[cfg(test)]
mod defects;
