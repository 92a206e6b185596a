//! All pages that `val3 explain` prints and that the book and editors show.

use val3_lang::instruction::{Availability, Instruction};
use val3_lang::library_errors::{LIBRARY_ERRORS, LibraryError};
use val3_lang::runtime_errors::{RUNTIME_ERRORS, RuntimeError};
use val3_lang::statements::{STATEMENTS, Statement};
use val3_lang::{instructions, page};

use crate::rule::Rule;
use crate::rules;

/// The address of the published book.
const BOOK: &str = env!("CARGO_PKG_HOMEPAGE");

/// One page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Topic {
    /// The kind of its subject.
    pub kind: Kind,
    /// The words that find it. The first one is listed.
    pub names: Vec<String>,
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
    /// A run-time error.
    RuntimeError,
    /// A result of `libLoad` and similar instructions.
    LibraryError,
}

impl Kind {
    /// The heading of a list of such pages.
    pub fn heading(self) -> &'static str {
        match self {
            Self::Finding => "Findings of val3 check",
            Self::Statement => "Statements",
            Self::Instruction => "Instructions",
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
            Self::RuntimeError => "errors",
            Self::LibraryError => "library-results",
        }
    }
}

impl Topic {
    /// The name of its page in the book, without an extension. Special characters are written as words.
    pub fn file_stem(&self) -> String {
        let signs = [("$", "addon-"), ("?", "print"), ("//", "comment"), ("=", "assignment")];
        let title = self.names.first().cloned().unwrap_or_default();
        signs.iter().fold(title, |name, (sign, word)| name.replace(sign, word))
    }
}

/// The address of the page of a rule in the published book.
pub fn address(rule: &Rule) -> String {
    format!("{BOOK}/{}/{}.html", Kind::Finding.folder(), rule.code)
}

/// Every topic, sorted by kind.
pub fn all() -> Vec<Topic> {
    let mut topics: Vec<Topic> = rules::all().iter().map(|rule| finding(rule)).collect();
    topics.extend(STATEMENTS.iter().map(statement));
    topics.extend(instructions::all().iter().map(|row| instruction(row)));
    topics.extend(RUNTIME_ERRORS.iter().map(runtime_error));
    topics.extend(LIBRARY_ERRORS.iter().map(library_error));
    topics
}

fn finding(rule: &Rule) -> Topic {
    let level = rule.severity.word();
    let off = if rule.on { "" } else { ", off until configured" };
    Topic {
        kind: Kind::Finding,
        names: vec![rule.code.to_owned(), rule.name.to_owned()],
        summary: format!("{:<24} {}", rule.name, page::summary(rule.page)),
        page: format!("# {} {} ({level}{off})\n\n{}", rule.code, rule.name, page::text(rule.page)),
    }
}

fn statement(row: &Statement) -> Topic {
    let others = row.keywords.iter().filter(|keyword| **keyword != row.name);
    Topic {
        kind: Kind::Statement,
        names: std::iter::once(&row.name).chain(others).map(|&name| name.to_owned()).collect(),
        summary: page::summary(row.page),
        page: format!("# {} ({})\n\n{}", row.name, sourced("statement", row.section), page::text(row.page)),
    }
}

fn instruction(row: &Instruction) -> Topic {
    let forms: String = row.overloads.iter().map(|form| form.signature(row.name) + "\n").collect();
    let title = format!("# {} ({})\n\n```\n{forms}```\n\n", row.name, origin(row));
    Topic {
        kind: Kind::Instruction,
        names: vec![row.name.to_owned()],
        summary: page::summary(row.page),
        page: title + &page::text(row.page),
    }
}

/// The origin of an instruction: the section of the manual, the version or the add-on.
fn origin(row: &Instruction) -> String {
    match row.availability {
        Availability::Manual => sourced("instruction", row.section),
        Availability::Version { since, until: Some(until) } => format!("instruction, s{since} to s{until}"),
        Availability::Version { since, until: None } => format!("instruction, from s{since} on"),
        Availability::AddOn(name) => format!("instruction of the add-on {name}"),
    }
}

/// A description with its section of the manual, if there is one.
fn sourced(what: &str, section: &str) -> String {
    if section.is_empty() { what.to_owned() } else { format!("{what}, manual {section}") }
}

fn runtime_error(row: &RuntimeError) -> Topic {
    Topic {
        kind: Kind::RuntimeError,
        names: vec![row.number.to_string()],
        summary: row.short.to_owned(),
        page: format!("# {} {} (run-time error)\n\n{}\n{}", row.number, row.short, row.long, raised_by(row.number)),
    }
}

/// The instructions that can raise a run-time error, as a paragraph.
fn raised_by(number: u16) -> String {
    let raising = instructions::all().iter().filter(|row| row.errors.contains(&number));
    let names: Vec<_> = raising.map(|row| format!("`{}`", row.name)).collect();
    if names.is_empty() { String::new() } else { format!("\nInstructions that raise it: {}.\n", names.join(", ")) }
}

fn library_error(row: &LibraryError) -> Topic {
    Topic {
        kind: Kind::LibraryError,
        names: vec![row.number.to_string()],
        summary: row.short.to_owned(),
        page: format!("# {} {} (result of a library instruction)\n\n{}\n", row.number, row.short, row.long),
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
