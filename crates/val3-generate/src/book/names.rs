//! Names that link to pages of the reference.

use std::collections::BTreeMap;

use val3_check::topics::{self, TopicKind};
use val3_lang::runtime_errors;
use val3_lang::types::{Arm, BaseType, attributes, fields};

use super::reference;
use crate::book::page::BookPage;

/// Pages by name.
pub(crate) struct PageNames {
    pages: BTreeMap<String, Vec<(TopicKind, String)>>,
    /// Paths of command pages, by command: `val3 arm list`.
    commands: BTreeMap<String, String>,
}

/// Order of preference among several pages with the same name.
const ORDER: [TopicKind; 7] = [
    TopicKind::Type,
    TopicKind::Instruction,
    TopicKind::Statement,
    TopicKind::Operator,
    TopicKind::Field,
    TopicKind::Word,
    TopicKind::Finding,
];

/// Names without a capital, digit or sign that have no other meaning on hand-written pages.
const UNMISTAKABLE: [&str; 10] = ["movej", "movel", "movec", "herej", "putln", "mdesc", "trsf", "dio", "aio", "sio"];

/// Words that are names in code.
const BUILT_IN: [&str; 3] = ["world", "flange", "Disk://"];

impl PageNames {
    /// Collects the names of all topics except errors, which are numbers, and the commands with a page among `paths`.
    pub(crate) fn new(paths: &[String]) -> Self {
        let mut pages: BTreeMap<String, Vec<(TopicKind, String)>> = BTreeMap::new();
        for topic in topics::all().iter().filter(|topic| ORDER.contains(&topic.kind)) {
            for name in &topic.names {
                pages.entry(name.clone()).or_default().push((topic.kind, reference::path(topic)));
            }
        }
        let command = |path: &String| {
            let name = path.strip_prefix(COMMANDS)?.strip_suffix(".md")?;
            Some((format!("val3 {}", name.replace('-', " ")), path.clone()))
        };
        Self { pages, commands: paths.iter().filter_map(command).collect() }
    }

    /// Returns the page that a code span on `page` names, if any.
    pub(crate) fn meant_on(&self, page: &BookPage, span: &str) -> Option<&str> {
        if let Some(path) = guide(page, span).or_else(|| self.command(span)) {
            return Some(path).filter(|path| *path != page.path);
        }
        let is_call =
            |name: &str| span.ends_with(')') && name.chars().all(|letter| letter.is_alphanumeric() || letter == '$');
        let name = span.split_once('(').map(|(name, _)| name).filter(|name| is_call(name)).unwrap_or(span);
        let rank = |kind: TopicKind| {
            let own = kind == TopicKind::Field && is_field_of(page, name);
            if own { Some(0) } else { ORDER.iter().position(|other| *other == kind).map(|place| place + 1) }
        };
        let fits = |(kind, path): &&(TopicKind, String)| *path != page.path && may_mean(page, *kind, name);
        let found = self.pages.get(name)?.iter().filter(fits).min_by_key(|(kind, _)| rank(*kind))?;
        Some(&found.1)
    }

    /// Returns the page of the command with which a code span begins.
    fn command(&self, span: &str) -> Option<&str> {
        let words: Vec<&str> = span.split_whitespace().collect();
        let found = [3, 2].into_iter().find_map(|count| self.commands.get(&words.get(..count)?.join(" ")))?;
        Some(found)
    }

    /// Returns the page of a kind with this name.
    pub(crate) fn of_kind(&self, kind: TopicKind, name: &str) -> Option<&str> {
        let found = self.pages.get(name)?.iter().find(|(other, _)| *other == kind)?;
        Some(&found.1)
    }
}

/// Folder of command pages.
const COMMANDS: &str = "commands/";

/// Beginnings of code spans on generated pages, with the hand-written pages to which they link.
const GUIDES: [(&str, &str); 3] =
    [("val3.toml", "configuration.md"), ("//val3: allow", "silence.md"), ("val3 check --fix", "fixes.md")];

/// Returns the hand-written page to which a code span on a generated page links.
fn guide(page: &BookPage, span: &str) -> Option<&'static str> {
    let found = GUIDES.iter().find(|(start, _)| page.subject.is_some() && span.starts_with(start));
    found.map(|(_, path)| *path)
}

/// Returns the page of a run-time error.
pub(crate) fn runtime_error(number: &str) -> Option<String> {
    runtime_errors::find(number.parse().ok()?)?;
    Some(format!("{}/{number}.md", TopicKind::RuntimeError.folder()))
}

/// Whether a name can link to a page of this kind. Hand-written pages use many words of the language in another sense,
/// for example for the settings `limit` and `parameters`, and so do pages about findings and instructions.
fn may_mean(page: &BookPage, kind: TopicKind, name: &str) -> bool {
    let is_marked = |name: &str| name.chars().any(|letter| !letter.is_ascii_lowercase() && letter != '_');
    match (page.kind(), kind) {
        (None, TopicKind::Finding) => is_marked(name),
        (_, TopicKind::Finding) => is_marked(name),
        (None, TopicKind::Word) => BUILT_IN.contains(&name),
        (None, _) => is_marked(name) && name.len() > 2 || UNMISTAKABLE.contains(&name),
        (Some(TopicKind::Finding | TopicKind::Instruction | TopicKind::Statement), TopicKind::Word) => {
            BUILT_IN.contains(&name)
        }
        (Some(TopicKind::Finding), TopicKind::Field) => name.len() > 2,
        _ => true,
    }
}

/// Whether the page is about a type that has this field or attribute.
fn is_field_of(page: &BookPage, name: &str) -> bool {
    let subject = page.subject.as_ref().filter(|subject| subject.kind == TopicKind::Type);
    let Some(ty) = subject.and_then(|subject| BaseType::from_name(&subject.name)) else { return false };
    let of_arm = |arm| {
        fields(ty, arm).iter().any(|field| field.name == name)
            || attributes(ty, arm).iter().any(|attribute| attribute.name == name)
    };
    of_arm(None) || of_arm(Some(Arm::Scara))
}
