//! The server from the view of its clients.

#![allow(unreachable_pub, missing_docs, dead_code, reason = "two suites share the client")]
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test may fail loudly")]
#![allow(clippy::disallowed_methods, reason = "clients have threads, a clock and patience")]

mod actions;
mod cell;
mod client;
mod completion;
mod data;
mod disk;
mod files;
mod findings;
mod hierarchies;
mod lenses;
mod open_session;
mod pages;
mod project_items;
mod requests;
mod session;
mod surroundings;
mod test_list;
mod torture;
mod variables;

/// Codes of findings.
fn codes(findings: &[serde_json::Value]) -> Vec<&str> {
    findings.iter().map(|finding| finding["code"].as_str().unwrap_or("")).collect()
}
