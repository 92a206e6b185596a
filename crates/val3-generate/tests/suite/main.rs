//! The book and the generated files of editors, from the documents of the repository.
#![allow(
    clippy::disallowed_methods,
    clippy::unwrap_used,
    reason = "documents are read from the disk, and a test may stop"
)]

mod book;
mod editors;

use camino::{Utf8Path, Utf8PathBuf};

/// Returns the folder of the repository.
fn root() -> Utf8PathBuf {
    Utf8Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}
