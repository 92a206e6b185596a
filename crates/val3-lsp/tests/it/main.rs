//! The server as its clients see it.

#![allow(unreachable_pub, missing_docs, dead_code, reason = "the tests use it all")]

mod cell;
mod client;
mod disk;
mod findings;
mod requests;
mod session;
mod torture;

/// The codes of findings.
fn codes(findings: &[serde_json::Value]) -> Vec<&str> {
    findings.iter().map(|finding| finding["code"].as_str().unwrap_or("")).collect()
}
