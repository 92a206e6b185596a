//! Files and folders that the documents name exist.

#![allow(clippy::unwrap_used, reason = "a test may fail loudly")]

use camino::Utf8Path;

const DOCUMENTS: &[&str] =
    &["ARCHITECTURE.md", "CONTRIBUTING.md", "README.md", "docs/releasing.md", "docs/src/wrong-run.md"];

/// The folders of the project in which a path may begin. Crates are also named without `crates/`.
const FOLDERS: &[&str] = &[".github/", "crates/", "docs/", "editors/", "tests/", "tools/", "xtask/", "val3-"];

/// The paths in code spans and links; patterns and examples aside.
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
        // Blocks of code contain examples of users' files.
        let prose: String = text.split("```").step_by(2).collect();
        assert!(paths(&prose).count() > 0, "{document}");
        missing.extend(paths(&prose).filter(|path| !exists(&root, path)).map(|path| format!("{document}: {path}")));
    }
    assert!(missing.is_empty(), "{missing:#?}");
}
