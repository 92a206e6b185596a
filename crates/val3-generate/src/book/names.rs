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
        let commands = paths.iter().filter_map(|path| Some((described_command(path)?, path.clone())));
        Self { pages, commands: commands.collect() }
    }

    /// Returns the page that a code span on `page` names, if any.
    pub(crate) fn meant_on(&self, page: &BookPage, span: &str) -> Option<&str> {
        if let Some(path) = guide(page, span).or_else(|| self.command(span)) {
            return Some(path).filter(|path| *path != page.path);
        }
        let name = without_arguments(span);
        let fits = |(kind, path): &&(TopicKind, String)| *path != page.path && may_mean(page, *kind, name);
        let found = self.pages.get(name)?.iter().filter(fits).min_by_key(|(kind, _)| rank(page, *kind, name))?;
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

/// Returns the command that a page describes, for example `val3 arm list` for `commands/arm-list.md`. `None` for other
/// pages.
fn described_command(path: &str) -> Option<String> {
    let name = path.strip_prefix(COMMANDS)?.strip_suffix(".md")?;
    Some(format!("val3 {}", name.replace('-', " ")))
}

/// Returns the name in a call such as `movej(jStart, tGripper, mNomSpeed)`. Other code spans are names as a whole.
fn without_arguments(span: &str) -> &str {
    let is_in_names = |letter: char| letter.is_alphanumeric() || letter == '$';
    match span.split_once('(') {
        Some((name, _)) if span.ends_with(')') && name.chars().all(is_in_names) => name,
        _ => span,
    }
}

/// Returns the rank of a page's kind among the pages with the same name. On the page of a type, fields of this type
/// precede all other kinds.
fn rank(page: &BookPage, kind: TopicKind, name: &str) -> Option<usize> {
    if kind == TopicKind::Field && is_field_of(page, name) {
        return Some(0);
    }
    ORDER.iter().position(|other| *other == kind).map(|position| position + 1)
}

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
    [None, Some(Arm::Scara)].into_iter().any(|arm| has_member(ty, arm, name))
}

/// Whether the type has this field or attribute on controllers of this arm kind.
fn has_member(ty: BaseType, arm: Option<Arm>, name: &str) -> bool {
    fields(ty, arm).iter().any(|field| field.name == name)
        || attributes(ty, arm).iter().any(|attribute| attribute.name == name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::book::page::Subject;

    #[test]
    fn a_command_page_describes_the_command_in_its_name() {
        assert_eq!(described_command("commands/arm-list.md").as_deref(), Some("val3 arm list"));
        assert_eq!(described_command("silence.md"), None);
    }

    #[test]
    fn a_call_is_named_without_its_arguments() {
        assert_eq!(without_arguments("movej(jStart, tGripper, mNomSpeed)"), "movej");
        assert_eq!(without_arguments("movej"), "movej");
        assert_eq!(without_arguments("(a + b)(c"), "(a + b)(c");
    }

    #[test]
    fn own_fields_have_the_first_rank_on_the_page_of_a_type() {
        let subject = |name: &str| Some(Subject { kind: TopicKind::Type, name: name.to_owned() });
        let page = |name: &str| BookPage { subject: subject(name), ..BookPage::plain("types/x.md", "") };
        assert_eq!(rank(&page("trsf"), TopicKind::Field, "x"), Some(0));
        assert!(rank(&page("string"), TopicKind::Field, "x") > rank(&page("string"), TopicKind::Type, "x"));
    }
}
