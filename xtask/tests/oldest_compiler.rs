//! The compiler of all tests is the oldest supported one.
//!
//! A newer feature therefore fails to compile here. `.github/workflows/scheduled.yml` tests newer compilers.

#![allow(clippy::unwrap_used, reason = "a test may fail loudly")]

#[test]
fn the_toolchain_is_the_minimum_version() {
    let toolchain = xtask::project::read("rust-toolchain.toml").unwrap();
    let channel = toolchain.lines().find_map(|line| line.strip_prefix("channel = ")).unwrap().trim_matches('"');
    let minimum = env!("CARGO_PKG_RUST_VERSION");
    assert!(channel == minimum || channel.starts_with(&format!("{minimum}.")), "{channel} is not {minimum}");
}
