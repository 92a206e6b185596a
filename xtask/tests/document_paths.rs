//! Files and folders in the documents exist.

#![allow(clippy::unwrap_used, reason = "a test may fail loudly")]

use camino::Utf8Path;

const DOCUMENTS: &[&str] =
    &["ARCHITECTURE.md", "CONTRIBUTING.md", "README.md", "docs/releasing.md", "docs/src/wrong-run.md"];

/// Folders of the project in which a path may begin. Crates also appear without `crates/`.
const FOLDERS: &[&str] = &[".github/", "crates/", "docs/", "editors/", "tests/", "tools/", "xtask/", "val3-"];

/// Returns the paths in code spans and links, without patterns and examples.
fn paths(text: &str) -> impl Iterator<Item = &str> {
    let spans = text.split('`').skip(1).step_by(2);
    let links = text.split("](").skip(1).filter_map(|rest| rest.split([')', '#']).next());
    let words = spans.chain(links).filter_map(|span| span.split_whitespace().next());
    words.filter(|word| {
        let is_exact = !word.contains(['<', '*', '{', '…']) && word.contains('/');
        is_exact && FOLDERS.iter().any(|folder| word.starts_with(folder))
    })
}

fn exists(root: &Utf8Path, path: &str) -> bool {
    root.join(path).exists() || root.join("crates").join(path).exists()
}

#[test]
fn paths_exist() {
    let root = xtask::project::root();
    let mut missing = Vec::new();
    for document in DOCUMENTS {
        let text = xtask::project::read(document).unwrap();
        // Code blocks contain examples of users' files.
        let prose: String = text.split("```").step_by(2).collect();
        assert!(paths(&prose).count() > 0, "{document}");
        missing.extend(paths(&prose).filter(|path| !exists(&root, path)).map(|path| format!("{document}: {path}")));
    }
    assert!(missing.is_empty(), "{missing:#?}");
}
