//! The book can be built, its links have targets, and its examples have the findings that they name.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use camino::Utf8Path;
use val3_check::testing::check_files;
use val3_generate::book;
use val3_test::{Fixture, ROOT};

use crate::root;

/// Returns every hand-written page: file name and text.
fn pages() -> Vec<(String, String)> {
    let entries = root().join("docs/src").read_dir_utf8().unwrap();
    let pages = entries.map(|entry| entry.unwrap()).filter(|entry| entry.path().extension() == Some("md"));
    pages.map(|page| (page.file_name().to_owned(), fs::read_to_string(page.path()).unwrap())).collect()
}

#[test]
fn the_book_can_be_built() {
    let html = book::build(&root()).unwrap();
    for page in ["index.html", "ci.html", "rules/V0203.html", "instructions/movej.html", "errors/80.html"] {
        assert!(html.join(page).is_file(), "{page}");
    }
    let pages = html_pages(&html);
    check_links(&html, &pages);
    check_titles(&pages);
    check_search(&html);
}

/// Returns the pages of the built book: path relative to the book, and text.
fn html_pages(html: &Utf8Path) -> BTreeMap<String, String> {
    let mut pages = BTreeMap::new();
    let mut folders = vec![html.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in folder.read_dir_utf8().unwrap().map(|entry| entry.unwrap()) {
            if entry.file_type().unwrap().is_dir() {
                folders.push(entry.path().to_owned());
            } else if entry.path().extension() == Some("html") {
                let path = entry.path().strip_prefix(html).unwrap().as_str().replace('\\', "/");
                pages.insert(path, fs::read_to_string(entry.path()).unwrap());
            }
        }
    }
    pages
}

/// Checks that every address in the book has its file and anchor.
fn check_links(html: &Utf8Path, pages: &BTreeMap<String, String>) {
    let mut dead = Vec::new();
    let mut count = 0;
    for (page, text) in pages {
        for address in
            text.split([' ', '<']).filter_map(|part| part.strip_prefix("href=\"").or(part.strip_prefix("src=\"")))
        {
            let address = address.split('"').next().unwrap();
            // The page for missing addresses links to the root of the site.
            if address.contains("://") || address.starts_with("mailto:") || address == "/" {
                continue;
            }
            count += 1;
            let (file, anchor) = address.split_once('#').unwrap_or((address, ""));
            let target = if file.is_empty() { page.clone() } else { joined(page, file) };
            let has_part = |text: &String| text.contains(&format!("id=\"{anchor}\""));
            let is_found =
                html.join(&target).is_file() && (anchor.is_empty() || pages.get(&target).is_some_and(has_part));
            if !is_found {
                dead.push(format!("{page}: {address}"));
            }
        }
    }
    assert!(dead.is_empty(), "{} of {count} links are dead\n{}", dead.len(), dead.join("\n"));
    for (page, link) in [
        ("rules/V0203.html", "../instructions/movej.html"),
        ("instructions/movej.html", "../errors/154.html"),
        ("instructions/movej.html", "../types/mdesc.html"),
        ("errors/154.html", "../instructions/movej.html"),
        ("words/father.html", "../words/world.html"),
        ("rules/V0203.html", "../configuration.html"),
        ("rules/V0203.html", "../silence.html"),
        ("running.html", "commands/run.html"),
        ("types/mdesc.html", "../fields/leave.html"),
    ] {
        assert!(pages[page].contains(&format!("href=\"{link}\"")), "{page} has no link to {link}");
    }
}

/// Returns the path for an address on a page.
fn joined(page: &str, address: &str) -> String {
    let mut parts: Vec<&str> = page.split('/').collect();
    parts.pop();
    for part in address.split('/') {
        match part {
            ".." => drop(parts.pop()),
            part => parts.push(part),
        }
    }
    parts.join("/")
}

/// Checks that titles and descriptions identify their page.
fn check_titles(pages: &BTreeMap<String, String>) {
    let between =
        |text: &str, start: &str, end: &str| text.split_once(start).unwrap().1.split_once(end).unwrap().0.to_owned();
    let own = |page: &&String| !["index.html", "404.html", "toc.html"].contains(&page.as_str());
    let titles: BTreeSet<String> =
        pages.iter().filter(|(page, _)| own(page)).map(|(_, text)| between(text, "<title>", "</title>")).collect();
    let descriptions: BTreeSet<String> = pages
        .iter()
        .filter(|(page, _)| own(page))
        .map(|(_, text)| between(text, "<meta name=\"description\" content=\"", "\""))
        .collect();
    assert!(
        titles.contains("V0203 argument-type - val3") && titles.contains("100 bad vel in the mdesc - val3"),
        "{titles:?}"
    );
    assert!(titles.len() * 100 > pages.len() * 95, "{} titles of {} pages", titles.len(), pages.len());
    assert!(
        descriptions.len() * 100 > pages.len() * 90,
        "{} descriptions of {} pages",
        descriptions.len(),
        pages.len()
    );
}

/// Checks that the search index contains the pages and their words.
fn check_search(html: &Utf8Path) {
    let files = html.read_dir_utf8().unwrap().map(|entry| entry.unwrap());
    let index = files.into_iter().find(|entry| entry.file_name().starts_with("searchindex")).unwrap();
    let text = fs::read_to_string(index.path()).unwrap();
    for word in ["rules/V0203.html", "types/mdesc.html", "singularity", "fatherid"] {
        assert!(text.contains(word), "{word}");
    }
}

#[test]
fn the_book_names_the_address_of_the_workspace() {
    let folder = tempfile::tempdir().unwrap();
    let folder = Utf8Path::from_path(folder.path()).unwrap();
    book::write_sources(&root().join("docs"), folder).unwrap();
    let read = |path: &str| fs::read_to_string(folder.join(path)).unwrap();
    let repository = env!("CARGO_PKG_REPOSITORY");
    assert!(read("book.toml").contains(&format!("git-repository-url = \"{repository}\"")));
    assert!(read("src/running.md").contains(&format!("({repository}/blob/main/SECURITY.md)")));
}

/// GitHub shows these pages too, and replaces no placeholders.
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
    book::write_sources(&root().join("docs"), folder).unwrap();
    let mut dead = Vec::new();
    for (page, text) in pages() {
        for link in text.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            let file = link.split('#').next().unwrap();
            // Releases exist only on GitHub, and other files of the repository are outside the book.
            let is_outside = link.starts_with("../../../../releases")
                || link.starts_with("../../") && root().join("docs/src").join(file).exists();
            let is_page = !link.contains("://") && !is_outside;
            if is_page && !file.is_empty() && !folder.join("src").join(file).is_file() {
                dead.push(format!("{page}: {link}"));
            }
        }
    }
    assert!(dead.is_empty(), "{dead:#?}");
}

#[test]
fn every_page_is_in_the_table_of_contents() {
    let summary = fs::read_to_string(root().join("docs/src/SUMMARY.md")).unwrap();
    let lacking: Vec<String> = pages()
        .into_iter()
        .map(|(page, _)| page)
        .filter(|page| page != "SUMMARY.md" && !summary.contains(&format!("]({page})")))
        .collect();
    assert!(lacking.is_empty(), "{lacking:?}");
}

/// A block marked `val3` has no finding; a block marked `val3 V0101 V0201` has exactly these findings.
#[test]
fn examples_have_the_findings_they_name() {
    for (page, text) in pages() {
        for block in text.split("\n```val3").skip(1) {
            let (codes, rest) = block.split_once('\n').unwrap();
            // The programs of a tutorial are executed with their applications.
            if codes.contains("file=") {
                continue;
            }
            let example = rest.split("\n```").next().unwrap();
            let fixture = Fixture::parse(example).with_stops();
            let files = fixture.files.iter().map(|(path, text)| (format!("{ROOT}/{path}"), text.clone().into_bytes()));
            let found = check_files(&files.collect::<Vec<_>>());
            let found: Vec<_> = found.iter().map(|finding| finding.code).collect();
            assert_eq!(found, codes.split_whitespace().collect::<Vec<_>>(), "{page}:\n{example}");
        }
    }
}
