//! The book can be built, its links have targets, and its examples give the findings they name.

#![allow(
    clippy::disallowed_methods,
    clippy::unwrap_used,
    reason = "the book is read from the disk, and a test may stop"
)]

use std::fs;

use camino::{Utf8Path, Utf8PathBuf};
use val3_check::testing::check_files;
use val3_test::{Fixture, ROOT};

fn root() -> Utf8PathBuf {
    Utf8Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Every page written by hand: file name and text.
fn pages() -> Vec<(String, String)> {
    let entries = root().join("docs/src").read_dir_utf8().unwrap();
    let pages = entries.map(|entry| entry.unwrap()).filter(|entry| entry.path().extension() == Some("md"));
    pages.map(|page| (page.file_name().to_owned(), fs::read_to_string(page.path()).unwrap())).collect()
}

#[test]
fn the_book_can_be_built() {
    let html = val3_book::build(&root()).unwrap();
    for page in ["index.html", "ci.html", "rules/V0203.html", "instructions/movej.html", "errors/80.html"] {
        assert!(html.join(page).is_file(), "{page}");
    }
}

#[test]
fn the_book_names_the_address_of_the_workspace() {
    let folder = tempfile::tempdir().unwrap();
    let folder = Utf8Path::from_path(folder.path()).unwrap();
    val3_book::write_sources(&root().join("docs"), folder).unwrap();
    let read = |path: &str| fs::read_to_string(folder.join(path)).unwrap();
    let repository = env!("CARGO_PKG_REPOSITORY");
    assert!(read("book.toml").contains(&format!("git-repository-url = \"{repository}\"")));
    assert!(read("src/running.md").contains(&format!("({repository}/blob/main/SECURITY.md)")));
}

/// GitHub shows these pages too, and fills in nothing.
#[test]
fn pages_have_no_placeholders() {
    for (page, text) in pages() {
        // GitHub's own expressions are `${{ … }}`.
        let left = text.match_indices("{{").find(|&(at, _)| !text[..at].ends_with('$'));
        assert_eq!(left, None, "{page}");
    }
}

#[test]
fn recipes_name_the_version_of_the_workspace() {
    let text = fs::read_to_string(root().join("docs/src/ci.md")).unwrap();
    let words = text.split(|symbol: char| !(symbol.is_ascii_digit() || symbol == '.'));
    let versions: Vec<_> = words.filter(|word| word.len() > 4 && word.split('.').count() == 3).collect();
    assert!(versions.len() > 5, "{versions:?}");
    let others: Vec<_> = versions.iter().filter(|version| **version != env!("CARGO_PKG_VERSION")).collect();
    assert!(others.is_empty(), "docs/src/ci.md names {others:?}");
}

#[test]
fn links_between_pages_have_targets() {
    let folder = tempfile::tempdir().unwrap();
    let folder = Utf8Path::from_path(folder.path()).unwrap();
    val3_book::write_sources(&root().join("docs"), folder).unwrap();
    let mut dead = Vec::new();
    for (page, text) in pages() {
        for link in text.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            let file = link.split('#').next().unwrap();
            let is_file = |file: &str| root().join("docs/src").join(file).exists();
            let is_page = !link.contains("://")
                && !(link.starts_with("../../") && is_file(file))
                && !link.starts_with("../../../../releases");
            if is_page && !file.is_empty() && !folder.join("src").join(file).is_file() {
                dead.push(format!("{page}: {link}"));
            }
        }
    }
    assert!(dead.is_empty(), "{dead:#?}");
}

/// A block marked `val3` shows no finding; one marked `val3 V0101 V0201` shows these and no others.
#[test]
fn examples_have_the_findings_they_name() {
    for (page, text) in pages() {
        for block in text.split("\n```val3").skip(1) {
            let (codes, rest) = block.split_once('\n').unwrap();
            let example = rest.split("\n```").next().unwrap();
            let fixture = Fixture::parse(example);
            let files = fixture.files.iter().map(|(path, text)| (format!("{ROOT}/{path}"), text.clone().into_bytes()));
            let found = check_files(&files.collect::<Vec<_>>());
            let found: Vec<_> = found.iter().map(|finding| finding.code).collect();
            assert_eq!(found, codes.split_whitespace().collect::<Vec<_>>(), "{page}:\n{example}");
        }
    }
}
