//! Builds the book: hand-written pages, and a generated page for every rule, statement, instruction and error.

#![allow(clippy::disallowed_methods, reason = "a tool of the project, not a part of the product")]

mod reference;

use std::fs;

use anyhow::{Context as _, Result};
use camino::{Utf8Path, Utf8PathBuf};
use mdbook_driver::MDBook;

/// Builds the book of the project at `root` as HTML in `target/book/html` and returns the folder.
///
/// # Errors
/// If a page cannot be read or written, or the book is not sound.
pub fn build(root: &Utf8Path) -> Result<Utf8PathBuf> {
    let folder = root.join("target/book");
    write_sources(&root.join("docs"), &folder)?;
    let book = MDBook::load(&folder).context("the book's sources")?;
    book.build().context("building the book")?;
    Ok(folder.join("html"))
}

/// Writes all pages of the book below `folder`, replacing the previous ones.
///
/// # Errors
/// If a file cannot be read or written.
pub fn write_sources(docs: &Utf8Path, folder: &Utf8Path) -> Result<()> {
    let pages = folder.join("src");
    if pages.exists() {
        fs::remove_dir_all(&pages).with_context(|| format!("clearing {pages}"))?;
    }
    fs::create_dir_all(&pages).with_context(|| format!("creating {pages}"))?;
    copy(&docs.join("book.toml"), &folder.join("book.toml"))?;
    for entry in docs.join("src").read_dir_utf8().with_context(|| format!("listing {docs}/src"))? {
        let entry = entry?;
        let target = pages.join(entry.file_name());
        if entry.path().extension() == Some("md") {
            copy(entry.path(), &target)?;
        } else {
            fs::copy(entry.path(), &target).with_context(|| format!("copying {}", entry.path()))?;
        }
    }
    let mut summary = read(&pages.join("SUMMARY.md"))? + "\n";
    for section in reference::sections() {
        summary.push_str(&section.summary());
        for page in &section.pages {
            write(&pages.join(&page.path), &page.text)?;
        }
    }
    write(&pages.join("SUMMARY.md"), &summary)
}

/// Copies a page or the settings of the book, with the values that `Cargo.toml` declares filled in.
fn copy(from: &Utf8Path, to: &Utf8Path) -> Result<()> {
    write(to, &filled(&read(from)?))
}

/// A text of the book from one that GitHub shows as well: links of GitHub lead to the repository, and the recipes name its owner
/// once the repository has its place.
fn filled(text: &str) -> String {
    let repository = env!("CARGO_PKG_REPOSITORY");
    let text = text
        .replace("{{repository}}", repository)
        .replace(RELEASES, &format!("]({repository}/releases"))
        .replace(ROOT, &format!("]({repository}/blob/main/"));
    match repository.strip_prefix(GITHUB).and_then(|name| name.split_once('/')) {
        Some((owner, _)) => text.replace("<owner>", owner),
        None => text,
    }
}

/// A link to the releases, as a page of `docs/src` has it on GitHub, where the folder of the branch is below that of the repository.
const RELEASES: &str = "](../../../../releases";

/// Beginning of a link to a file of the repository outside the book.
const ROOT: &str = "](../../";

/// Beginning of the address of a repository whose owner is known.
const GITHUB: &str = "https://github.com/";

fn read(path: &Utf8Path) -> Result<String> {
    fs::read_to_string(path).with_context(|| format!("reading {path}"))
}

fn write(path: &Utf8Path, text: &str) -> Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).with_context(|| format!("creating {folder}"))?;
    }
    fs::write(path, text).with_context(|| format!("writing {path}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_of_github_lead_to_the_repository() {
        let repository = env!("CARGO_PKG_REPOSITORY");
        let page = "[a](../../../../releases), [b](../../SECURITY.md), [c](running.md)";
        let expected = format!("[a]({repository}/releases), [b]({repository}/blob/main/SECURITY.md), [c](running.md)");
        assert_eq!(filled(page), expected);
    }
}
