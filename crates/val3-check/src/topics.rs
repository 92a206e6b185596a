//! All pages that `val3 explain` prints and that the book and editors show.

mod errors;
mod glossary;
mod instructions;
mod options;
mod rules;
mod search;
mod tables;

use val3_lang::operators::BinaryOp;
use val3_lang::page;
use val3_lang::statements::{STATEMENTS, Statement};

use crate::rule::Rule;

pub use search::{Hit, search};

/// The address of the published book.
const BOOK: &str = env!("CARGO_PKG_HOMEPAGE");

/// One page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Topic {
    /// The kind of its subject.
    pub kind: Kind,
    /// The heading of the pages that are listed together within the kind; empty if the kind has no groups.
    pub group: &'static str,
    /// The words that find it. The first one is listed.
    pub names: Vec<String>,
    /// The name of its page in the book, without an extension.
    pub stem: String,
    /// The title in a table of contents.
    pub title: String,
    /// A description of one line.
    pub summary: String,
    /// The page in Markdown.
    pub page: String,
}

/// The kind of a page's subject, in the order of the list.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// A rule of `val3 check`.
    Finding,
    /// A keyword of the language.
    Statement,
    /// An instruction.
    Instruction,
    /// A type that variables can have.
    Type,
    /// A field of a type, or an attribute of values in data files.
    Field,
    /// An operator, or several of one kind.
    Operator,
    /// A word of robots and controllers.
    Word,
    /// A run-time error.
    RuntimeError,
    /// A result of `libLoad` and similar instructions.
    LibraryError,
}

impl Kind {
    /// Every kind, in the order of the list.
    pub const ALL: [Self; 9] = [
        Self::Finding,
        Self::Statement,
        Self::Instruction,
        Self::Type,
        Self::Field,
        Self::Operator,
        Self::Word,
        Self::RuntimeError,
        Self::LibraryError,
    ];

    /// The heading of a list of such pages.
    pub fn heading(self) -> &'static str {
        match self {
            Self::Finding => "Findings of val3 check",
            Self::Statement => "Statements",
            Self::Instruction => "Instructions",
            Self::Type => "Types",
            Self::Field => "Fields",
            Self::Operator => "Operators",
            Self::Word => "Words of robots and controllers",
            Self::RuntimeError => "Run-time errors",
            Self::LibraryError => "Results of library instructions",
        }
    }

    /// The folder of the book that holds such pages.
    pub fn folder(self) -> &'static str {
        match self {
            Self::Finding => "rules",
            Self::Statement => "statements",
            Self::Instruction => "instructions",
            Self::Type => "types",
            Self::Field => "fields",
            Self::Operator => "operators",
            Self::Word => "words",
            Self::RuntimeError => "errors",
            Self::LibraryError => "library-results",
        }
    }
}

impl Topic {
    /// The first name.
    pub fn name(&self) -> &str {
        self.names.first().map_or("", String::as_str)
    }
}

/// The address of the page of a rule in the published book.
pub fn address(rule: &Rule) -> String {
    format!("{BOOK}/{}/{}.html", Kind::Finding.folder(), rule.code)
}

/// Every topic, sorted by kind and group.
pub fn all() -> Vec<Topic> {
    let mut topics = rules::topics();
    topics.extend(STATEMENTS.iter().map(statement));
    topics.extend(instructions::topics());
    topics.extend(glossary::topics());
    topics.extend(errors::topics());
    topics.sort_by_key(|topic| topic.kind);
    topics
}

/// The topics with this name. A topic with the name as its first one hides others, and the exact letter case hides other
/// spellings. Several topics can have one name: `config` is a type, a field and an instruction.
pub fn find<'a>(topics: &'a [Topic], name: &str) -> Vec<&'a Topic> {
    let is_title = |topic: &&Topic| topic.name() == name;
    let is_title_in_any_case = |topic: &&Topic| topic.name().eq_ignore_ascii_case(name);
    let is_name = |topic: &&Topic| topic.names.iter().any(|known| known == name);
    let is_name_in_any_case = |topic: &&Topic| topic.names.iter().any(|known| known.eq_ignore_ascii_case(name));
    let tests: [&dyn Fn(&&Topic) -> bool; 4] = [&is_title, &is_name, &is_title_in_any_case, &is_name_in_any_case];
    let found = tests.into_iter().map(|test| topics.iter().filter(test).collect::<Vec<_>>());
    found.into_iter().find(|found| !found.is_empty()).unwrap_or_default()
}

/// A description with its section of the manual, if there is one.
fn sourced(what: &str, section: &str) -> String {
    if section.is_empty() { what.to_owned() } else { format!("{what}, manual {section}") }
}

/// A page file for a name. Special characters are written as words.
fn stem(name: &str) -> String {
    let signs = [("$", "addon-"), ("?", "print"), ("//", "comment"), ("=", "assignment")];
    signs.iter().fold(name.to_owned(), |name, (sign, word)| name.replace(sign, word))
}

fn statement(row: &Statement) -> Topic {
    let others = row.keywords.iter().filter(|keyword| **keyword != row.name);
    let operator = BinaryOp::from_symbol(row.name);
    let (kind, what) = if operator.is_some() { (Kind::Operator, "operators") } else { (Kind::Statement, "statement") };
    let names: Vec<String> = std::iter::once(&row.name).chain(others).map(|&name| name.to_owned()).collect();
    let title = if operator.is_some() { names.join(", ") } else { row.name.to_owned() };
    let tables = if operator.is_some() { tables::of_operators(&names) } else { String::new() };
    Topic {
        kind,
        group: "",
        stem: stem(row.name),
        summary: page::summary(row.page),
        page: format!("# {title} ({})\n\n{}{tables}", sourced(what, row.section), page::text(row.page)),
        names,
        title,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_topic_is_complete() {
        for topic in all() {
            assert!(topic.names.iter().all(|name| !name.is_empty()), "{topic:?}");
            assert!(!topic.summary.is_empty() && topic.page.starts_with("# "), "{topic:?}");
        }
    }

    #[test]
    fn no_two_topics_of_a_kind_share_a_name() {
        let mut names: Vec<_> =
            all().iter().flat_map(|topic| topic.names.clone().into_iter().map(|name| (topic.kind, name))).collect();
        let count = names.len();
        names.sort();
        names.dedup();
        assert_eq!(names.len(), count);
    }
}
