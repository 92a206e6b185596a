//! Sources of pages: `docs/src`, other documents of the repository, and the code.

use std::fs;

use anyhow::{Context as _, Result};
use camino::Utf8Path;

use super::{arms, code, filled, links, reference, spans};
use crate::book::names::PageNames;
use crate::book::page::BookPage;
use crate::files::read;

/// Line of `SUMMARY.md` that the entries of generated pages replace.
const GENERATED: &str = "<!-- generated pages -->\n";

/// Line of `SUMMARY.md` that the entries of decisions replace.
const DECISIONS: &str = "<!-- decisions -->\n";

/// Line of `SUMMARY.md` that the entries of commands replace.
const COMMANDS: &str = "<!-- commands -->\n";

/// Returns all pages, with links and coloured code, including the table of contents.
pub(crate) fn all(docs: &Utf8Path) -> Result<Vec<BookPage>> {
    let mut pages = Vec::new();
    written(&docs.join("src"), "", &mut pages)?;
    written(&docs.join("adr"), "adr/", &mut pages)?;
    for (path, name) in documents(docs)? {
        pages.push(BookPage::plain(name, filled(&read(&path)?)));
    }
    let sections = reference::sections();
    let (commands, decisions) = (entries(&pages, "commands/"), entries(&pages, "adr/"));
    for page in pages.iter_mut().filter(|page| page.path == "SUMMARY.md") {
        let entries: String = sections.iter().map(|section| section.summary.as_str()).collect();
        let filled = page.text.replacen(GENERATED, &entries, 1);
        page.text = filled.replacen(COMMANDS, &commands, 1).replacen(DECISIONS, &decisions, 1);
    }
    pages.extend(sections.into_iter().flat_map(|section| section.pages));
    pages.push(arms::page()?);
    let mut paths = files(&docs.join("src"))?;
    paths.extend(pages.iter().map(|page| page.path.clone()));
    let names = PageNames::new(&paths);
    for page in pages.iter_mut().filter(|page| page.path != "SUMMARY.md") {
        page.text = links::within_book(page, &paths);
        page.text = code::coloured(page, &names);
        page.text = spans::linked(page, &names);
    }
    Ok(pages)
}

/// Returns the repository documents that are pages too: file, and path in the book.
fn documents(docs: &Utf8Path) -> Result<Vec<(camino::Utf8PathBuf, &'static str)>> {
    let root = docs.parent().context("the folder of the documents has no parent")?;
    Ok(vec![
        (docs.join("fidelity.md"), links::FIDELITY),
        (root.join("CHANGELOG.md"), links::CHANGELOG),
        (root.join("ARCHITECTURE.md"), links::ARCHITECTURE),
    ])
}

/// Returns the table of contents for a folder without its index, with the pages' titles.
fn entries(pages: &[BookPage], folder: &str) -> String {
    let is_entry = |page: &&BookPage| page.path.starts_with(folder) && !page.path.ends_with("/index.md");
    pages.iter().filter(is_entry).map(entry).collect()
}

/// Returns the line of the table of contents for a page.
fn entry(page: &BookPage) -> String {
    let title = page.text.lines().next().and_then(|line| line.strip_prefix("# ")).unwrap_or_default();
    format!("  - [{title}]({})\n", page.path)
}

/// Collects the Markdown pages below a folder.
fn written(folder: &Utf8Path, prefix: &str, pages: &mut Vec<BookPage>) -> Result<()> {
    let entries = folder.read_dir_utf8().with_context(|| format!("listing {folder}"))?;
    let mut entries = entries.collect::<Result<Vec<_>, _>>().with_context(|| format!("listing {folder}"))?;
    entries.sort_by(|left, right| left.path().cmp(right.path()));
    for entry in entries {
        let path = format!("{prefix}{}", entry.file_name());
        if entry.file_type().with_context(|| format!("reading {path}"))?.is_dir() {
            written(entry.path(), &format!("{path}/"), pages)?;
        } else if path.ends_with(".md") {
            pages.push(BookPage::plain(path.replace("README.md", "index.md"), filled(&read(entry.path())?)));
        }
    }
    Ok(())
}

/// Copies the files in a folder that are not pages, for example pictures.
pub(crate) fn copy_files(from: &Utf8Path, to: &Utf8Path) -> Result<()> {
    fs::create_dir_all(to).with_context(|| format!("creating {to}"))?;
    for name in files(from)? {
        fs::copy(from.join(&name), to.join(&name)).with_context(|| format!("copying {from}/{name}"))?;
    }
    Ok(())
}

/// Returns the names of the files in a folder that are not pages.
fn files(folder: &Utf8Path) -> Result<Vec<String>> {
    let mut names = Vec::new();
    for entry in folder.read_dir_utf8().with_context(|| format!("listing {folder}"))? {
        let entry = entry.with_context(|| format!("listing {folder}"))?;
        let is_file = entry.file_type().with_context(|| format!("reading {}", entry.path()))?.is_file();
        if is_file && entry.path().extension() != Some("md") {
            names.push(entry.file_name().to_owned());
        }
    }
    Ok(names)
}
