//! Links in documents that are also read in the repository: in the book they lead to its pages.

use std::ops::Range;

use pulldown_cmark::{Event, Options, Parser, Tag};

use crate::book::page::BookPage;

/// Path of `docs/fidelity.md` in the book.
pub(crate) const FIDELITY: &str = "fidelity.md";
/// Path of `CHANGELOG.md` in the book.
pub(crate) const CHANGELOG: &str = "changelog.md";
/// Path of `ARCHITECTURE.md` in the book.
pub(crate) const ARCHITECTURE: &str = "architecture.md";

/// Location of repository files in the book: beginning of the path and its replacement.
const MOVED: [(&str, &str); 7] = [
    ("docs/adr/README.md", "adr/index.md"),
    ("docs/src/", ""),
    ("docs/adr/", "adr/"),
    ("docs/fidelity.md", FIDELITY),
    ("docs/", ""),
    ("CHANGELOG.md", CHANGELOG),
    ("ARCHITECTURE.md", ARCHITECTURE),
];

/// Replaces links by links to pages of the book. A link to another file of the repository is reduced to its text.
pub(crate) fn within_book(page: &BookPage, paths: &[String]) -> String {
    let mut edits = Vec::new();
    for (event, range) in Parser::new_ext(&page.text, options()).into_offset_iter() {
        if let Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) = event
            && is_relative(&dest_url)
        {
            let source = page.text.get(range.clone()).unwrap_or_default();
            edits.extend(edit(page, paths, &dest_url, source).map(|text| (range, text)));
        }
    }
    replaced(&page.text, edits)
}

/// Markdown extensions that the pages use.
pub(crate) fn options() -> Options {
    Options::ENABLE_TABLES
}

/// Replaces ranges of a text, which must not overlap.
pub(crate) fn replaced(text: &str, mut edits: Vec<(Range<usize>, String)>) -> String {
    edits.sort_by_key(|(range, _)| range.start);
    let mut result = text.to_owned();
    for (range, new) in edits.into_iter().rev() {
        result.replace_range(range, &new);
    }
    result
}

fn is_relative(address: &str) -> bool {
    !address.contains("://") && !address.starts_with('#') && !address.starts_with("mailto:")
}

/// Returns the new source of a link or picture, if its target has another path in the book.
fn edit(page: &BookPage, paths: &[String], address: &str, source: &str) -> Option<String> {
    let (file, anchor) =
        address.split_once('#').map_or((address, ""), |(file, _)| (file, address.split_at(file.len()).1));
    let is_page = |path: &String| paths.contains(path);
    let folder = page.path.rsplit_once('/').map_or("", |(folder, _)| folder);
    if is_page(&joined(folder, file)) {
        return None;
    }
    let found = [joined(&repository_folder(page), file)].into_iter().map(|path| moved(&path)).find(is_page);
    match found {
        Some(path) => Some(source.replace(&format!("]({address})"), &format!("]({}{anchor})", page.link_to(&path)))),
        None => source.rsplit_once("](").and_then(|(text, _)| text.strip_prefix('[')).map(str::to_owned),
    }
}

/// Returns the folder of a page's source in the repository.
fn repository_folder(page: &BookPage) -> String {
    match page.path.as_str() {
        CHANGELOG | ARCHITECTURE => String::new(),
        FIDELITY => "docs".to_owned(),
        path if path.starts_with("adr/") => "docs/adr".to_owned(),
        path => format!("docs/src/{}", path.rsplit_once('/').map_or("", |(folder, _)| folder)),
    }
}

/// Returns the path in the book for a file of the repository.
fn moved(path: &str) -> String {
    let row = MOVED.iter().find_map(|(from, to)| path.strip_prefix(from).map(|rest| format!("{to}{rest}")));
    row.unwrap_or_else(|| path.to_owned())
}

/// Resolves a relative path in a folder, without `.` and `..`.
fn joined(folder: &str, file: &str) -> String {
    let mut parts: Vec<&str> = folder.split('/').filter(|part| !part.is_empty()).collect();
    for part in file.split('/') {
        match part {
            "." | "" => {}
            ".." => {
                parts.pop();
            }
            part => parts.push(part),
        }
    }
    parts.join("/")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_lead_to_pages_of_the_book() {
        let paths = ["adr/index.md", "arms.md", "b.svg", "changelog.md"].map(str::to_owned);
        let page = BookPage::plain(
            ARCHITECTURE,
            "See [a](docs/adr/README.md), [b](docs/src/arms.md#x), [c](xtask/a.md), [d](CHANGELOG.md).",
        );
        assert_eq!(within_book(&page, &paths), "See [a](adr/index.md), [b](arms.md#x), c, [d](changelog.md).");
        let page = BookPage::plain("adr/0001.md", "[a](../src/arms.md) [b](README.md) ![c](../src/b.svg)");
        assert_eq!(within_book(&page, &paths), "[a](../arms.md) [b](../adr/index.md) ![c](../b.svg)");
    }
}
