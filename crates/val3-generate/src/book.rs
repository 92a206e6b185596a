//! Builds the book: hand-written pages, and a generated page for every rule, instruction, type, word and error.

mod arms;
mod code;
mod descriptions;
mod links;
mod names;
mod page;
mod pages;
mod reference;
mod spans;

use std::fs;

use anyhow::{Context as _, Result};
use camino::{Utf8Path, Utf8PathBuf};
use mdbook_driver::MDBook;

use crate::files::{read, write};
use page::BookPage;

/// Builds the book of the project at `root` as HTML in `target/book/html` and returns the folder.
///
/// # Errors
/// A page cannot be read or written, or the book is not sound.
pub fn build(root: &Utf8Path) -> Result<Utf8PathBuf> {
    let folder = root.join("target/book");
    let pages = write_pages(&root.join("docs"), &folder)?;
    let book = MDBook::load(&folder).context("the book's sources")?;
    book.build().context("building the book")?;
    let html = folder.join("html");
    descriptions::write(&html, &pages)?;
    Ok(html)
}

/// Writes all pages of the book below `folder`, replacing the previous ones.
///
/// # Errors
/// A file cannot be read or written.
pub fn write_sources(docs: &Utf8Path, folder: &Utf8Path) -> Result<()> {
    write_pages(docs, folder).map(|_| ())
}

fn write_pages(docs: &Utf8Path, folder: &Utf8Path) -> Result<Vec<BookPage>> {
    let sources = folder.join("src");
    if sources.exists() {
        fs::remove_dir_all(&sources).with_context(|| format!("clearing {sources}"))?;
    }
    copy(&docs.join("book.toml"), &folder.join("book.toml"))?;
    pages::copy_files(&docs.join("theme"), &folder.join("theme"))?;
    pages::copy_files(&docs.join("src"), &sources)?;
    let pages = pages::all(docs)?;
    for page in &pages {
        write(&sources.join(&page.path), &page.text)?;
    }
    Ok(pages)
}

/// Copies the book's settings and inserts the values from `Cargo.toml`.
fn copy(from: &Utf8Path, to: &Utf8Path) -> Result<()> {
    write(to, &filled(&read(from)?))
}

/// Converts a text that GitHub shows too to a text of the book: GitHub's relative links become links to the repository,
/// and recipes name the repository's owner, once the repository has an address.
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

/// A link to the releases in a page of `docs/src`. On GitHub the address of a page is below the folder of the branch.
const RELEASES: &str = "](../../../../releases";

/// Beginning of a link to a file of the repository outside the book.
const ROOT: &str = "](../../";

/// Beginning of a repository address with a known owner.
const GITHUB: &str = "https://github.com/";

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
