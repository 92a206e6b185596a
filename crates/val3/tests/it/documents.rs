//! Documentation tests: each command in a document is executed, in a copy of the repository's examples.
//!
//! The lines of a page's `sh` blocks run one after the other, so a page reads like a session. Pages of the book start
//! in `examples/palletiser`, other documents in the root of the repository. A comment on a line may state that the
//! command `exits with 1`, or why it is `not executed`. A block `text output` contains the output of the preceding
//! commands; `…` matches any text, and on a separate line any lines. A block with a file name (`toml file=boxes.toml`)
//! writes that file; for a program, it replaces the code.

mod block;
mod session;

use std::fs;
use std::path::{Path, PathBuf};

use self::block::blocks;
use self::session::Session;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Documents in a folder, sorted by name.
fn documents(folder: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(root().join(folder)).unwrap().map(|entry| entry.unwrap().path());
    let mut pages: Vec<_> =
        entries.filter(|path| path.extension().is_some_and(|extension| extension == "md")).collect();
    pages.sort();
    pages
}

/// Executes each page's commands, and reports wrong lines.
fn execute(pages: &[PathBuf], start: &str) {
    let mut faults = Vec::new();
    for page in pages {
        let text = fs::read_to_string(page).unwrap();
        let mut session = Session::start(&root(), start);
        for block in blocks(&text) {
            let name = page.strip_prefix(root()).unwrap().display();
            faults.extend(session.execute(&block).into_iter().map(|fault| format!("{name}:{fault}")));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn the_commands_of_the_book_do_what_it_says() {
    execute(&documents("docs/src"), "examples/palletiser");
}

#[test]
fn the_commands_of_other_documents_do_what_they_say() {
    let pages = ["", "editors", "examples", "packaging"].into_iter().flat_map(documents).collect::<Vec<_>>();
    execute(&pages, "");
}
