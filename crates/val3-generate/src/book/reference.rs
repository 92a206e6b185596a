//! Pages that are generated from the pages of `val3 explain`.

use val3_check::topics::{self, Topic, TopicKind};

use crate::book::page::{BookPage, Subject};

/// Pages of a kind.
pub(crate) struct Section {
    /// Page with the list, pages of groups, and pages of topics.
    pub(crate) pages: Vec<BookPage>,
    /// Lines for the table of contents.
    pub(crate) summary: String,
}

/// Returns the sections, one for each kind of page.
pub(crate) fn sections() -> Vec<Section> {
    let topics = topics::all();
    TopicKind::ALL.into_iter().map(|kind| section(kind, &topics)).collect()
}

fn section(kind: TopicKind, topics: &[Topic]) -> Section {
    let topics: Vec<&Topic> = topics.iter().filter(|topic| topic.kind == kind).collect();
    let index = format!("{}/index.md", kind.folder());
    let mut summary = format!("- [{}]({index})\n", heading(kind));
    let mut text = format!("# {}\n", heading(kind));
    let mut pages = Vec::new();
    for group in topics.chunk_by(|left, right| left.group == right.group) {
        let name = group.first().map_or("", |topic| topic.group);
        let mut indent = "  ";
        if !name.is_empty() {
            let path = format!("{}/{}", kind.folder(), group_file(kind, name));
            summary.push_str(&format!("  - [{name}]({path})\n"));
            text.push_str(&format!("\n## [{name}]({})\n", group_file(kind, name)));
            pages.push(BookPage::plain(path, format!("# {name}: {}\n{}", heading(kind), table(group))));
            indent = "    ";
        }
        text.push_str(&table(group));
        for topic in group {
            summary.push_str(&format!("{indent}- [{}]({})\n", escaped(&topic.title), path(topic)));
            pages.push(page(topic));
        }
    }
    pages.insert(0, BookPage::plain(index, text));
    Section { pages, summary }
}

/// Returns the title of a section. The words are the book's glossary.
fn heading(kind: TopicKind) -> &'static str {
    if kind == TopicKind::Word { "Glossary" } else { kind.heading() }
}

fn page(topic: &Topic) -> BookPage {
    let subject = Subject { kind: topic.kind, name: topic.name().to_owned() };
    BookPage { path: path(topic), subject: Some(subject), text: topic.page.clone() }
}

/// Returns the path of a topic's page.
pub(crate) fn path(topic: &Topic) -> String {
    format!("{}/{}.md", topic.kind.folder(), topic.stem)
}

/// Returns the file of a group, for example `motion-instructions.md`.
fn group_file(kind: TopicKind, group: &str) -> String {
    let words: Vec<String> = group
        .split(|letter: char| !letter.is_ascii_alphanumeric())
        .filter(|word| !word.is_empty())
        .map(str::to_lowercase)
        .collect();
    format!("{}-{}.md", words.join("-"), kind.folder())
}

/// Returns a table of pages in the same folder.
fn table(topics: &[&Topic]) -> String {
    format!("\n| | |\n|---|---|\n{}", topics.iter().map(|topic| row(topic)).collect::<String>())
}

/// Returns the row of a table of pages.
fn row(topic: &Topic) -> String {
    format!("| [{}]({}.md) | {} |\n", escaped(&topic.title), topic.stem, topic.summary.replace('|', "\\|"))
}

/// Escapes a title for Markdown.
fn escaped(title: &str) -> String {
    title.replace('<', "&lt;").replace('*', "\\*").replace('|', "\\|")
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    fn paths() -> Vec<String> {
        sections().into_iter().flat_map(|section| section.pages).map(|page| page.path).collect()
    }

    #[test]
    fn no_two_pages_share_a_file() {
        let paths: Vec<String> = paths().into_iter().map(|path| path.to_lowercase()).collect();
        let different: BTreeSet<&String> = paths.iter().collect();
        assert_eq!(different.len(), paths.len());
    }

    #[test]
    fn every_rule_has_a_page_at_its_address() {
        let paths = paths();
        for rule in val3_check::rules::all() {
            let address = topics::address(rule);
            let page = paths.iter().any(|path| address.ends_with(&format!("/{}", path.replace(".md", ".html"))));
            assert!(page, "{address}");
        }
    }

    #[test]
    fn file_names_suit_every_system() {
        for path in paths() {
            let fine = |c: char| c.is_ascii_alphanumeric() || "/-_.".contains(c);
            assert!(path.chars().all(fine), "{path}");
        }
    }
}
