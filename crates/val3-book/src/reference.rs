//! The pages that are generated from the code.

use val3_check::topics::{self, Kind, Topic};

/// The pages of one kind, with a page that lists them.
pub(crate) struct Section {
    /// The page with the list, then the pages in its order.
    pub(crate) pages: Vec<Page>,
}

/// A page of the book.
pub(crate) struct Page {
    /// Path relative to `src`.
    pub(crate) path: String,
    /// Title in the table of contents.
    pub(crate) title: String,
    /// Markdown.
    pub(crate) text: String,
}

/// One section for each kind of page.
pub(crate) fn sections() -> Vec<Section> {
    let topics = topics::all();
    Kind::ALL.into_iter().map(|kind| section(kind, &topics)).collect()
}

fn section(kind: Kind, topics: &[Topic]) -> Section {
    let topics: Vec<&Topic> = topics.iter().filter(|topic| topic.kind == kind).collect();
    let mut pages = vec![Page {
        path: format!("{}/index.md", kind.folder()),
        title: kind.heading().to_owned(),
        text: list(kind, &topics),
    }];
    pages.extend(topics.into_iter().map(page));
    Section { pages }
}

fn page(topic: &Topic) -> Page {
    Page { path: format!("{}/{}", topic.kind.folder(), file(topic)), title: title(topic), text: topic.page.clone() }
}

/// A table of all pages of a kind.
fn list(kind: Kind, topics: &[&Topic]) -> String {
    let rows = topics.iter().map(|topic| format!("| [{}]({}) | {} |\n", title(topic), file(topic), summary(topic)));
    format!("# {}\n\n| | |\n|---|---|\n{}", kind.heading(), rows.collect::<String>())
}

fn title(topic: &Topic) -> String {
    topic.title.clone()
}

/// The summary of a topic, without the padding for terminals.
fn summary(topic: &Topic) -> String {
    let words: Vec<&str> = topic.summary.split_whitespace().collect();
    words.join(" ").replace('|', "\\|")
}

fn file(topic: &Topic) -> String {
    format!("{}.md", topic.stem)
}

impl Section {
    /// The lines of the table of contents.
    pub(crate) fn summary(&self) -> String {
        let line = |(index, page): (usize, &Page)| {
            let indent = if index == 0 { "" } else { "  " };
            format!("{indent}- [{}]({})\n", page.title, page.path)
        };
        self.pages.iter().enumerate().map(line).collect()
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn no_two_pages_share_a_file() {
        let paths: Vec<String> =
            sections().into_iter().flat_map(|section| section.pages).map(|page| page.path.to_lowercase()).collect();
        let different: BTreeSet<&String> = paths.iter().collect();
        assert_eq!(different.len(), paths.len());
    }

    #[test]
    fn every_rule_has_a_page_at_its_address() {
        let paths: BTreeSet<String> =
            sections().into_iter().flat_map(|section| section.pages).map(|page| page.path).collect();
        for rule in val3_check::rules::all() {
            let address = topics::address(rule);
            let page = paths.iter().any(|path| address.ends_with(&format!("/{}", path.replace(".md", ".html"))));
            assert!(page, "{address}");
        }
    }

    #[test]
    fn file_names_suit_every_system() {
        for page in sections().into_iter().flat_map(|section| section.pages) {
            let fine = |c: char| c.is_ascii_alphanumeric() || "/-_.".contains(c);
            assert!(page.path.chars().all(fine), "{}", page.path);
        }
    }
}
