//! The server as its clients see it.

mod cell;
mod client;
mod session;

/// The codes of findings.
fn codes(findings: &[serde_json::Value]) -> Vec<&str> {
    findings.iter().map(|finding| finding["code"].as_str().unwrap_or("")).collect()
}
